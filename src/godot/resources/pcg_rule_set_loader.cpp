#include "godot/resources/pcg_rule_set_loader.h"

#include <godot_cpp/core/class_db.hpp>

#include "godot/resources/pcg_rule_set.h"

using namespace godot;

namespace pcg {

PackedStringArray PCGRuleSetLoader::_get_recognized_extensions() const {
	PackedStringArray extensions;
	extensions.push_back("cga");
	extensions.push_back("pcg");
	return extensions;
}

bool PCGRuleSetLoader::_handles_type(const StringName &p_type) const {
	return p_type == StringName("PCGRuleSet") || p_type == StringName("Resource");
}

String PCGRuleSetLoader::_get_resource_type(const String &p_path) const {
	const String extension = p_path.get_extension().to_lower();
	return extension == "cga" || extension == "pcg" ? "PCGRuleSet" : "";
}

Variant PCGRuleSetLoader::_load(const String &p_path, const String &, bool, int32_t) const {
	return PCGRuleSet::from_file(p_path);
}

} // namespace pcg
