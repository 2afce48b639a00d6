#include "godot/resources/pcg_rule_set_saver.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include "core/io/atomic_file.h"
#include "godot/convert.h"
#include "godot/report.h"
#include "godot/resources/pcg_rule_set.h"

using namespace godot;

namespace pcg {

Error PCGRuleSetSaver::_save(const Ref<Resource> &p_resource, const String &p_path, uint32_t) {
	const Ref<PCGRuleSet> rules = p_resource;
	ERR_FAIL_COND_V(rules.is_null(), ERR_INVALID_PARAMETER);
	const Error error = save_to(p_path, [&rules](const std::string &path, Diagnostics &diagnostics) { write_file(path, from_godot(rules->get_source()), diagnostics); });
	if (error == OK && rules->get_file() != p_path) {
		rules->read_file(p_path);
	}
	return error;
}

bool PCGRuleSetSaver::_recognize(const Ref<Resource> &p_resource) const { return Ref<PCGRuleSet>(p_resource).is_valid(); }

PackedStringArray PCGRuleSetSaver::_get_recognized_extensions(const Ref<Resource> &p_resource) const {
	PackedStringArray extensions;
	const Ref<PCGRuleSet> rules = p_resource;
	if (rules.is_valid()) {
		extensions.push_back(rules->get_dialect() == PCGRuleSet::DIALECT_CGA ? "cga" : "pcg");
	}
	return extensions;
}

} // namespace pcg
