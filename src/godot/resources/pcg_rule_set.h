#pragma once

#include <memory>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "core/base/diagnostic.h"
#include "core/lang/program.h"
#include "core/lang/source.h"

namespace pcg {

// A compiled rule file. One with errors is still a resource: it carries its list of errors, and whoever needs its rules says so.
class PCGRuleSet : public godot::Resource {
	GDCLASS(PCGRuleSet, godot::Resource)

public:
	enum Dialect { DIALECT_CGA, DIALECT_AGENDA };

	// Always a rule set, whatever is wrong with the file.
	static godot::Ref<PCGRuleSet> from_file(const godot::String &p_path);
	// Functions and operations that rules may call from then on, in whatever is compiled later. False, with an engine error, if that cannot be.
	static bool add_function(const godot::String &p_name, const godot::Dictionary &p_parameters, int p_result, const godot::Callable &p_function);
	static bool add_operation(const godot::String &p_name, const godot::Dictionary &p_parameters, const godot::Callable &p_operation);
	void read_file(const godot::String &p_path);
	void reload();

	// pcg_rule_set_language.cpp
	// Compiles `p_text` as though it stood in that file already; what it imports is read.
	static godot::Ref<PCGRuleSet> from_text(const godot::String &p_path, const godot::String &p_text);
	static godot::TypedArray<godot::Dictionary> get_builtins(Dialect p_dialect);
	static godot::PackedStringArray get_keywords();
	godot::TypedArray<godot::Dictionary> get_definitions() const;

	void set_source(const godot::String &p_source);
	godot::String get_source() const { return _source; }
	void set_dialect(Dialect p_dialect);
	Dialect get_dialect() const { return _dialect; }
	godot::String get_file() const;

	bool has_errors() const { return _diagnostics.has_errors(); }
	godot::TypedArray<godot::Dictionary> get_diagnostics() const;
	godot::String get_diagnostics_text() const;
	godot::PackedStringArray get_rules() const;
	godot::PackedStringArray get_start_rules() const;
	godot::TypedArray<godot::Dictionary> get_attributes() const;

	// Null after errors. Immutable: threads may keep it.
	const std::shared_ptr<const Program> &program() const { return _program; }
	const Diagnostics &diagnostics() const { return _diagnostics; }

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &p_property) const;

private:
	static void bind_language();
	void take_path(const godot::String &p_path);
	void compile();
	void compile_file(SourceProvider &files);

	godot::String _file; // empty: `_source` is compiled
	godot::String _source;
	Dialect _dialect = DIALECT_CGA;
	std::shared_ptr<const Program> _program;
	Diagnostics _diagnostics;
};

} // namespace pcg

VARIANT_ENUM_CAST(pcg::PCGRuleSet::Dialect);
