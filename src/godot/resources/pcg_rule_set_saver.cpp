#include "godot/resources/pcg_rule_set_saver.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/class_db.hpp>

#include "godot/resources/pcg_rule_set.h"

using namespace godot;

namespace pcg {

Error PCGRuleSetSaver::_save(const Ref<Resource> &p_resource, const String &p_path, uint32_t) {
	const Ref<PCGRuleSet> rules = p_resource;
	ERR_FAIL_COND_V(rules.is_null(), ERR_INVALID_PARAMETER);
	const String partial = p_path + String(".tmp"); // an editor that ends half-way leaves the old rules
	Ref<FileAccess> file = FileAccess::open(partial, FileAccess::WRITE);
	ERR_FAIL_COND_V_MSG(file.is_null(), ERR_FILE_CANT_WRITE, String("PCGRuleSet: cannot write ") + p_path + String(". May you write in this folder?"));
	const bool is_written = file->store_string(rules->get_source());
	file->close();
	ERR_FAIL_COND_V_MSG(!is_written, ERR_FILE_CANT_WRITE, String("PCGRuleSet: ") + p_path + String(" could not be written. Is the disk full?"));
	const Error error = DirAccess::rename_absolute(partial, p_path);
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
