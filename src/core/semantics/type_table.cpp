#include "core/semantics/city_model.h"

namespace pcg {

TypeId TypeTable::add(std::string_view name) {
	if (const TypeId known = find(name); is_valid(known)) {
		return known;
	}
	const TypeId id = TypeId(_names.size());
	_names.emplace_back(name);
	_ids.emplace(_names.back(), id);
	return id;
}

TypeId TypeTable::find(std::string_view name) const {
	const auto found = _ids.find(name);
	return found == _ids.end() ? TypeId::Invalid : found->second;
}

std::string_view TypeTable::name(TypeId id) const {
	return index_of(id) < _names.size() ? std::string_view(_names[index_of(id)]) : std::string_view();
}

} // namespace pcg
