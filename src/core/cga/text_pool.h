#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/lang/value.h"

namespace pcg::cga {

// Texts that shapes carry, as numbers: 0 is the empty text, equal texts have equal numbers.
class TextPool {
public:
	TextPool() { clear(); }
	void clear();
	size_t size() const { return _texts.size(); }
	// Constants of a program are looked up once each.
	uint32_t intern(const Text &text);
	uint32_t intern(std::string_view text);
	std::string_view text(uint32_t id) const { return _texts[id]; }

private:
	std::deque<std::string> _texts; // never move
	std::unordered_map<std::string_view, uint32_t> _ids;
	std::vector<uint32_t> _ids_of_symbols;
};

} // namespace pcg::cga
