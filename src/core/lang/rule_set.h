#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/lang/ast.h"
#include "core/lang/dialect.h"
#include "core/lang/source.h"

// A file with everything it imports, and what each name means where. CGA reference, section 1.7; PCG language, section 1.
namespace pcg {

struct ParsedFile {
	std::string path;
	std::shared_ptr<const Source> source;
	Ast ast;
};

// A file at one place in the tree of imports: the same file under two ids is two modules with attributes of their own.
struct Module {
	uint32_t file = 0; // in RuleSet::files
	uint32_t space = 0;
	uint32_t depth = 0; // imports without an id between this and the file that opened the space; the smallest wins
	std::string style; // empty: Default
};

struct Definition {
	enum class Kind : uint8_t { Rule, Attribute, Function } kind = Kind::Rule;
	uint32_t module = 0; // whose text it is; names in it mean what they mean there
	const AstItem *item = nullptr; // or, if it stands in an import's list:
	const AstOverride *override_item = nullptr;
	std::string name; // with the prefix of its space
	uint32_t offset = 0;
	uint32_t param_count = 0;
	uint32_t index = 0; // RuleId, attribute or function; given by the compiler
	uint32_t style_level = 0; // how far its style is from the chosen one: 0 that one, 1 what it extends ..
	bool is_default_style = true; // importing files may override it
	uint32_t inherits = no_node; // attribute whose value this one takes (definition of the importing file)
	uint32_t replaced = no_node; // the extension as its own file has it, where an import's list has another rule for it
	uint32_t own_module = 0; // that of `item`
};

// Names that see each other: a file and what it imports without an id.
struct Space {
	std::string prefix; // "", "day.", "day.walk."
	uint32_t parent = no_node;
	uint32_t start = no_node; // definition of the rule marked `start`
	bool is_missing = false; // a file of it could not be had: its names are unknown for a reason that was told
	std::map<std::string_view, uint32_t> imports; // id to space
	std::unordered_map<std::string_view, std::vector<uint32_t>> rules; // name to definitions, one for each number of parameters
	std::unordered_map<std::string_view, std::vector<uint32_t>> values; // attributes and functions
};

struct RuleSet {
	std::vector<std::unique_ptr<ParsedFile>> files; // the main file first
	std::vector<Module> modules;
	std::vector<Space> spaces; // the main file's first
	std::vector<Definition> definitions;

	// What `name`, perhaps with an import's id in front, means in `space`; no_node if nothing.
	uint32_t find_rule(uint32_t space, std::string_view name, size_t param_count) const;
	uint32_t find_value(uint32_t space, std::string_view name, size_t param_count) const;
	bool has_rule(uint32_t space, std::string_view name) const;
	bool has_value(uint32_t space, std::string_view name) const;
	// The space that the ids in front of the last dot lead to, and `name` without them; no_node if there is no such import.
	uint32_t enter_space(uint32_t space, std::string_view &name) const;
	// An import's list in `module` has another value or rule for the definition.
	void replace(uint32_t definition, uint32_t module, const AstOverride &by);
	// Whether `name` may be unknown only because of something that was diagnosed before.
	bool is_excused(uint32_t space, std::string_view name) const;
	const Source &source_of(const Definition &definition) const {
		return *files[modules[definition.module].file]->source;
	}
};

// Reads and parses everything. `style` is what the main file's rules and attributes are taken from (CGA reference: style); empty: Default. With errors the result may be incomplete; it is always safe to compile for more diagnostics.
RuleSet load_rule_set(const std::string &path, const Dialect &dialect, SourceProvider &provider, Diagnostics &diagnostics,
		std::string_view style = {});

} // namespace pcg
