#pragma once

#include <string>

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "core/base/diagnostic.h"

namespace pcg {

// A resource that is made of text: of a file's, or of text that is kept in the resource.
class PCGTextFile : public godot::Resource {
	GDCLASS(PCGTextFile, godot::Resource)

public:
	void set_file(const godot::String &p_file);
	godot::String get_file() const { return _file; }
	void set_source(const godot::String &p_source);
	godot::String get_source() const { return _source; }
	void reload();

	bool has_errors() const { return _diagnostics.has_errors(); }
	godot::TypedArray<godot::Dictionary> get_diagnostics() const;
	godot::String get_diagnostics_text() const;
	const Diagnostics &diagnostics() const { return _diagnostics; }

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &p_property) const;

	// Called with empty text where the file cannot be read, which is told already.
	virtual void read_text(const std::string &text, Diagnostics &diagnostics) = 0;
	// For messages: of the file, or what text without one is called.
	std::string name_or(const char *p_name) const;

private:
	godot::String _file; // empty: `_source` is the text
	godot::String _source;
	Diagnostics _diagnostics;
};

} // namespace pcg
