#include "core/agenda/renumbering.h"

#include "core/agenda/agenda_edit.h"

namespace pcg {

Renumbering::Renumbering(AgendaSet &set, std::span<const std::string> names, std::span<const Requirement> requirements, std::span<const uint32_t> origins,
		size_t first_group) : _origins(origins), _first_group(uint32_t(first_group)) {
	for (const std::string &name : names) {
		_names.push_back(name.empty() ? uint16_t(0) : task_name(set, name));
	}
	for (Requirement requirement : requirements) {
		if (_requirements.empty()) { // means none
			_requirements.push_back(0);
			continue;
		}
		requirement.name = _names[requirement.name];
		requirement.outer = _requirements[requirement.outer];
		_requirements.push_back(task_requirement(set, requirement));
	}
}

} // namespace pcg
