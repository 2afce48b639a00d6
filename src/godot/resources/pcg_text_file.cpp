#include "godot/resources/pcg_text_file.h"

#include <godot_cpp/core/class_db.hpp>

#include "core/base/result.h"
#include "godot/convert.h"
#include "godot/ports/engine_files.h"

using namespace godot;

namespace pcg {

void PCGTextFile::_bind_methods() {
	ClassDB::bind_method(D_METHOD("reload"), &PCGTextFile::reload);
	ClassDB::bind_method(D_METHOD("has_errors"), &PCGTextFile::has_errors);
	ClassDB::bind_method(D_METHOD("get_diagnostics"), &PCGTextFile::get_diagnostics);
	ClassDB::bind_method(D_METHOD("get_diagnostics_text"), &PCGTextFile::get_diagnostics_text);
	ClassDB::bind_method(D_METHOD("set_file", "file"), &PCGTextFile::set_file);
	ClassDB::bind_method(D_METHOD("get_file"), &PCGTextFile::get_file);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "file", PROPERTY_HINT_FILE, "*.csv"), "set_file", "get_file");
	ClassDB::bind_method(D_METHOD("set_source", "source"), &PCGTextFile::set_source);
	ClassDB::bind_method(D_METHOD("get_source"), &PCGTextFile::get_source);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "source", PROPERTY_HINT_MULTILINE_TEXT), "set_source", "get_source");
}

// Text that comes from a file is neither edited nor stored here.
void PCGTextFile::_validate_property(PropertyInfo &p_property) const {
	if (!_file.is_empty() && p_property.name == StringName("source")) {
		p_property.usage = PROPERTY_USAGE_EDITOR | PROPERTY_USAGE_READ_ONLY;
	}
}

void PCGTextFile::set_file(const String &p_file) {
	_file = p_file;
	reload();
	notify_property_list_changed();
}

void PCGTextFile::set_source(const String &p_source) {
	_file = String();
	_source = p_source;
	reload();
}

void PCGTextFile::reload() {
	_diagnostics = Diagnostics();
	if (!_file.is_empty()) {
		const Result<std::string> text = read_engine_file(_file);
		_source = text ? to_godot(std::string_view(*text)) : String();
		if (!text) {
			_diagnostics.add(text.diagnostic());
		}
	}
	read_text(from_godot(_source), _diagnostics);
	emit_changed();
}

TypedArray<Dictionary> PCGTextFile::get_diagnostics() const { return to_godot(_diagnostics); }

String PCGTextFile::get_diagnostics_text() const { return to_godot(std::string_view(to_text(_diagnostics))).strip_edges(); }

std::string PCGTextFile::name_or(const char *p_name) const { return _file.is_empty() ? p_name : from_godot(_file); }

} // namespace pcg
