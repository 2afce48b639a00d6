#include "core/cga/text_pool.h"

namespace pcg::cga {

namespace {

constexpr uint32_t unknown = UINT32_MAX;

} // namespace

void TextPool::clear() {
	_ids.clear();
	_ids_of_symbols.clear();
	_texts.clear();
	intern(std::string_view());
}

uint32_t TextPool::intern(const Text &text) {
	if (text.symbol == no_symbol) {
		return intern(text.view);
	}
	if (text.symbol >= _ids_of_symbols.size()) {
		_ids_of_symbols.resize(text.symbol + 1u, unknown);
	}
	uint32_t &id = _ids_of_symbols[text.symbol];
	if (id == unknown) {
		id = intern(text.view);
	}
	return id;
}

uint32_t TextPool::intern(std::string_view text) {
	const auto found = _ids.find(text);
	if (found != _ids.end()) {
		return found->second;
	}
	_texts.emplace_back(text);
	const uint32_t id = uint32_t(_texts.size()) - 1;
	_ids.emplace(_texts.back(), id);
	return id;
}

} // namespace pcg::cga
