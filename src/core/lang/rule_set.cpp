#include "core/lang/rule_set.h"

#include <algorithm>

#include "core/lang/parser.h"
#include "core/lang/rule_lookup.h"
#include "core/lang/styles.h"

namespace pcg {

namespace {

constexpr size_t max_modules = 2000; // imports of imports of imports, each twice, would be billions

class Loader {
public:
	Loader(const Dialect &dialect, SourceProvider &provider, Diagnostics &diagnostics)
			: _dialect(dialect), _provider(provider), _diagnostics(diagnostics) {}

	RuleSet run(const std::string &path, std::string_view style);

private:
	uint32_t read(const std::string &path, const ParsedFile *importer, const AstImport *import);
	void report_missing(const std::string &path, const Diagnostic &why, const ParsedFile *importer, const AstImport *import);
	bool is_cycle(const std::string &path, const ParsedFile &importer, const AstImport &import);
	void load_module(uint32_t file, uint32_t space, uint32_t depth, const std::string &style);
	void load_import(uint32_t module, const AstImport &import);
	uint32_t open_space(const Module &importer, const AstImport &import);
	void define_items(uint32_t module);
	void define_overrides(uint32_t module, const AstImport &import, uint32_t space);
	void inherit_attributes(uint32_t module, const AstImport &import, uint32_t space);
	void define(Definition definition, uint32_t space, std::string_view name);
	bool wins(const Definition &definition, const Definition &older, uint32_t space, std::string_view name);
	void note_start(uint32_t space, uint32_t definition);
	void report_duplicate(const Definition &definition, const Definition &older, std::string_view name);
	std::string style_of(const Module &importer, const AstImport &import, uint32_t imported);
	void define_for_imports(uint32_t module);
	Definition::Kind kind_of(const AstItem &item) const;
	bool may_replace(const ParsedFile &file, uint32_t space, std::string_view name, const AstItem &item);
	void report_constant(const ParsedFile &file, uint32_t offset, std::string_view name);
	bool is_strict() const { return _dialect.is_strict(); }

	const Dialect &_dialect;
	SourceProvider &_provider;
	Diagnostics &_diagnostics;
	RuleSet _set;
	std::map<std::string, uint32_t> _files; // by path; no_node: could not be read, was reported
	std::vector<std::string> _stack; // files that are being loaded, the main file first
};

void Loader::report_missing(const std::string &path, const Diagnostic &why, const ParsedFile *importer, const AstImport *import) {
	if (importer == nullptr) {
		Diagnostic diagnostic = why;
		diagnostic.file = path;
		_diagnostics.add(std::move(diagnostic));
		return;
	}
	_diagnostics.add(importer->source->diagnostic(is_strict() ? Severity::Error : Severity::Warning, "missing-import", import->path_offset,
			"cannot import `" + path + "`: " + why.message,
			is_strict() ? "paths count from the folder of the importing file" : "what it defines is left out"));
}

// The number of the parsed file, no_node if it cannot be had.
uint32_t Loader::read(const std::string &path, const ParsedFile *importer, const AstImport *import) {
	const auto known = _files.find(path);
	if (known != _files.end()) {
		return known->second;
	}
	Result<std::string> bytes = _provider.read(path);
	if (!bytes) {
		report_missing(path, bytes.diagnostic(), importer, import);
		return _files[path] = no_node;
	}
	if (!decode_rule_text(path, *bytes, _diagnostics)) {
		return _files[path] = no_node;
	}
	auto file = std::make_unique<ParsedFile>();
	file->path = path;
	file->source = std::make_shared<const Source>(path, std::move(*bytes));
	file->ast = parse(*file->source, _dialect, _diagnostics);
	_set.files.push_back(std::move(file));
	return _files[path] = uint32_t(_set.files.size() - 1);
}

bool Loader::is_cycle(const std::string &path, const ParsedFile &importer, const AstImport &import) {
	const auto begin = std::find(_stack.begin(), _stack.end(), path);
	if (begin == _stack.end()) {
		return false;
	}
	std::string cycle;
	for (auto i = begin; i != _stack.end(); ++i) {
		cycle += *i + " -> ";
	}
	_diagnostics.add(importer.source->diagnostic(Severity::Error, "import-cycle", import.path_offset,
			importer.path == path ? "the file imports itself: " + cycle + path : "files import each other: " + cycle + path,
			"put what both need into a third file"));
	return true;
}

void Loader::load_module(uint32_t file, uint32_t space, uint32_t depth, const std::string &style) {
	const uint32_t module = uint32_t(_set.modules.size());
	_set.modules.push_back({ file, space, depth, style });
	_stack.push_back(_set.files[file]->path);
	_set.spaces[space].is_missing |= _set.files[file]->ast.is_abandoned;
	define_items(module);
	for (const AstImport &import : _set.files[file]->ast.imports) {
		load_import(module, import);
	}
	_stack.pop_back();
	define_for_imports(module);
}

// Rules and values that this file defines for an import: b.Mass --> ..
void Loader::define_for_imports(uint32_t module) {
	const ParsedFile &file = *_set.files[_set.modules[module].file];
	for (const AstItem &item : file.ast.items) {
		std::string_view name = item.name;
		const bool is_default = item.style == no_node || file.ast.styles[item.style].name == "Default";
		if (name.find('.') == std::string_view::npos || !is_default) {
			continue;
		}
		const uint32_t target = _set.enter_space(_set.modules[module].space, name);
		if (target == no_node) {
			_diagnostics.add(file.source->diagnostic(is_strict() ? Severity::Error : Severity::Warning, "unknown-import", item.offset,
					"`" + std::string(item.name) + "` belongs to an import that does not exist"));
			continue;
		}
		if (!is_strict() || may_replace(file, target, name, item)) {
			define({ kind_of(item), module, &item, nullptr, {}, item.offset, uint32_t(item.params.size()) }, target, name);
		}
	}
}

Definition::Kind Loader::kind_of(const AstItem &item) const {
	const bool is_plain_function = item.kind == AstItem::Kind::Plain && _dialect.locals == Dialect::Locals::Lexical;
	return item.kind == AstItem::Kind::Rule ? Definition::Kind::Rule
			: item.has_params || is_plain_function ? Definition::Kind::Function
												   : Definition::Kind::Attribute;
}

// What an import does not have nobody there asks for, and its constants are its own.
bool Loader::may_replace(const ParsedFile &file, uint32_t space, std::string_view name, const AstItem &item) {
	const Space &imported = _set.spaces[space];
	const auto &known = item.kind == AstItem::Kind::Rule ? imported.rules : imported.values;
	const uint32_t found = find_overload(_set, find_list(known, name), item.params.size());
	if (found != no_node && _set.definitions[found].item->kind != AstItem::Kind::Constant) {
		return true;
	}
	if (found != no_node) {
		report_constant(file, item.offset, item.name);
	} else if (!_set.is_excused(space, name)) {
		_diagnostics.add(file.source->diagnostic(Severity::Error, "unknown-name", item.offset,
				"the import has no " + std::string(item.kind == AstItem::Kind::Rule ? "rule" : "value") + " `" + std::string(item.name) + "` to replace",
				nearest(known, imported.prefix, name)));
	}
	return false;
}

void Loader::report_constant(const ParsedFile &file, uint32_t offset, std::string_view name) {
	_diagnostics.add(file.source->diagnostic(Severity::Error, "read-only", offset, "`" + std::string(name) + "` is const in the imported file and keeps its value",
			"declare it there with attr"));
}

// import id (S) : a list limits what the host may choose. There is one choice for the main file: where the list names it too, that is taken,
// else the first.
std::string Loader::style_of(const Module &importer, const AstImport &import, uint32_t imported) {
	if (import.styles.empty()) {
		return {};
	}
	const std::vector<AstStyle> &styles = _set.files[imported]->ast.styles;
	std::string chosen;
	for (const std::string_view style : import.styles) {
		if (!has_style(styles, style)) {
			_diagnostics.add(_set.files[importer.file]->source->diagnostic(Severity::Warning, "unknown-style", import.offset,
					"`" + import.path + "` has no style `" + std::string(style) + "`", style_names(styles)));
		} else if (chosen.empty() || style == importer.style) {
			chosen = style;
		}
	}
	return chosen;
}

void Loader::load_import(uint32_t module, const AstImport &import) {
	const Module importer = _set.modules[module];
	const ParsedFile &file = *_set.files[importer.file];
	const std::string path = find_import(_provider, file.path, import.path);
	if (_stack.size() > max_nesting) {
		_diagnostics.add(file.source->diagnostic(Severity::Error, "too-many-imports", import.offset,
				"imports nested deeper than " + std::to_string(max_nesting) + " files"));
		return;
	}
	if (_set.modules.size() >= max_modules) {
		if (_set.modules.size() == max_modules) {
			_diagnostics.add(file.source->diagnostic(Severity::Error, "too-many-imports", import.offset,
					"more than " + std::to_string(max_modules) + " imports in all"));
		}
		return;
	}
	const uint32_t space = import.id.empty() ? importer.space : open_space(importer, import);
	const uint32_t imported = is_cycle(path, file, import) ? no_node : read(path, &file, &import);
	if (imported == no_node) {
		_set.spaces[space].is_missing = true;
		return;
	}
	const bool is_loaded = std::any_of(_set.modules.begin(), _set.modules.end(),
			[&](const Module &other) { return other.file == imported && other.space == space; });
	if (!is_loaded) { // A file that two others import into one space is there once.
		load_module(imported, space, import.id.empty() ? importer.depth + 1 : 0, style_of(importer, import, imported));
	}
	define_overrides(module, import, space);
	if (!import.id.empty() && _dialect.locals == Dialect::Locals::Lexical) {
		inherit_attributes(module, import, space);
	}
}

// The space of an import with an id.
uint32_t Loader::open_space(const Module &importer, const AstImport &import) {
	const uint32_t space = uint32_t(_set.spaces.size());
	Space opened;
	opened.prefix = _set.spaces[importer.space].prefix + std::string(import.id) + ".";
	opened.parent = importer.space;
	_set.spaces.push_back(std::move(opened));
	if (!_set.spaces[importer.space].imports.emplace(import.id, space).second) {
		_diagnostics.add(_set.files[importer.file]->source->diagnostic(Severity::Error, "duplicate-name", import.offset,
				"two imports are called `" + std::string(import.id) + "`", "give one of them another name"));
	}
	return space;
}

void Loader::define_items(uint32_t module) {
	const Module here = _set.modules[module];
	const Ast &ast = _set.files[here.file]->ast;
	const std::vector<std::string_view> chain = style_chain(*_set.files[here.file], here.style, _diagnostics);
	for (const AstItem &item : ast.items) {
		const std::string_view style = item.style == no_node ? std::string_view("Default") : ast.styles[item.style].name;
		const auto level = std::find(chain.begin(), chain.end(), style);
		if (level == chain.end() || item.name.find('.') != std::string_view::npos) {
			continue;
		}
		Definition definition = { kind_of(item), module, &item, nullptr, {}, item.offset, uint32_t(item.params.size()) };
		definition.style_level = uint32_t(level - chain.begin());
		definition.is_default_style = style == "Default";
		definition.own_module = module;
		define(std::move(definition), here.space, item.name);
	}
}

void Loader::report_duplicate(const Definition &definition, const Definition &older, std::string_view name) {
	const Source &source = _set.source_of(definition);
	const Source &older_source = _set.source_of(older);
	const uint32_t line = older_source.position(older.offset).line;
	_diagnostics.add(source.diagnostic(Severity::Error, "duplicate-name", definition.offset,
			"`" + std::string(name) + "` is already defined in " + older_source.name() + ":" + std::to_string(line), "rename one of them"));
}

void Loader::define(Definition definition, uint32_t space_index, std::string_view name) {
	Space &space = _set.spaces[space_index];
	definition.name = space.prefix + std::string(name);
	auto &list = definition.kind == Definition::Kind::Rule ? space.rules[name] : space.values[name];
	for (uint32_t &known : list) {
		Definition &older = _set.definitions[known];
		const bool is_same = older.param_count == definition.param_count;
		const bool both_values = older.kind != definition.kind && (older.item == nullptr || !older.item->has_params || !definition.item->has_params);
		if (!is_same && !both_values) {
			continue;
		}
		if (wins(definition, older, space_index, name)) {
			if (older.kind == Definition::Kind::Attribute && definition.kind == older.kind) {
				older = std::move(definition); // hosts find one value of that name
				return;
			}
			_set.definitions.push_back(std::move(definition));
			known = uint32_t(_set.definitions.size() - 1);
			note_start(space_index, known);
		}
		return;
	}
	_set.definitions.push_back(std::move(definition));
	list.push_back(uint32_t(_set.definitions.size() - 1));
	note_start(space_index, list.back());
}

// Of two definitions of one name: files that import win, then the style that is nearer to the chosen one; the rest are mistakes.
bool Loader::wins(const Definition &definition, const Definition &older, uint32_t space_index, std::string_view name) {
	const uint32_t old_depth = _set.modules[older.module].depth, new_depth = _set.modules[definition.module].depth;
	const bool is_from_importer = _set.modules[definition.module].space != space_index;
	if (older.module == definition.module && older.style_level != definition.style_level) {
		return definition.style_level < older.style_level;
	}
	if (older.module == definition.module || (old_depth == new_depth && !is_from_importer)) {
		report_duplicate(definition, older, name);
		return false;
	}
	if (is_strict() && !is_from_importer) { // from an import of its own name may_replace() has looked
		const Definition &winner = new_depth < old_depth ? definition : older, &loser = new_depth < old_depth ? older : definition;
		if (loser.item->kind == AstItem::Kind::Constant) {
			report_constant(*_set.files[_set.modules[winner.module].file], winner.offset, name);
		}
	}
	return is_from_importer ? older.is_default_style : new_depth < old_depth;
}

// `start R --> ..` is also called by the name `start`.
void Loader::note_start(uint32_t space, uint32_t definition) {
	const Definition &marked = _set.definitions[definition];
	if (marked.kind != Definition::Kind::Rule || !marked.item->is_start) {
		return;
	}
	const uint32_t older = _set.spaces[space].start;
	if (older == no_node || _set.modules[marked.module].depth < _set.modules[_set.definitions[older].module].depth ||
			_set.definitions[older].name == marked.name) {
		_set.spaces[space].start = definition;
	}
}

// import b : "file" (a = 3, Mass --> Box)
void Loader::define_overrides(uint32_t module, const AstImport &import, uint32_t space) {
	for (const AstOverride &item : import.overrides) {
		if (item.is_protected()) {
			continue;
		}
		const ParsedFile &file = *_set.files[_set.modules[module].file];
		const bool is_rule = item.body != no_node;
		const auto &known = is_rule ? _set.spaces[space].rules : _set.spaces[space].values;
		const uint32_t target = find_overload(_set, find_list(known, item.name), is_rule ? item.params.size() : 0);
		if (target == no_node) {
			_diagnostics.add(file.source->diagnostic(is_strict() ? Severity::Error : Severity::Warning, "unknown-name", item.offset,
					"`" + import.path + "` has no " + (is_rule ? "rule `" : "attribute `") + std::string(item.name) + "`", nearest(known, {}, item.name)));
			continue;
		}
		if (is_strict() && _set.definitions[target].item->kind == AstItem::Kind::Constant) {
			report_constant(file, item.offset, item.name);
			continue;
		}
		if (_set.definitions[target].is_default_style) {
			_set.replace(target, module, item);
		}
	}
}

// An attribute of the importing file gives its value to the imported file's attribute of the same name, unless that is protected.
void Loader::inherit_attributes(uint32_t module, const AstImport &import, uint32_t space) {
	if (import.has_override_list && import.overrides.empty()) {
		return;
	}
	for (uint32_t i = 0; i < _set.definitions.size(); ++i) {
		Definition &imported = _set.definitions[i];
		if (imported.kind != Definition::Kind::Attribute || imported.override_item != nullptr || imported.inherits != no_node || !imported.is_default_style ||
				imported.item->kind != AstItem::Kind::Attribute || _set.modules[imported.module].space != space) {
			continue;
		}
		const bool is_listed = std::any_of(import.overrides.begin(), import.overrides.end(),
				[&](const AstOverride &item) { return item.name == imported.item->name; });
		const uint32_t own = find_overload(_set, find_list(_set.spaces[_set.modules[module].space].values, imported.item->name), 0);
		const bool is_attribute = own != no_node && _set.definitions[own].kind == Definition::Kind::Attribute &&
				(is_strict() || _set.definitions[own].item->kind == AstItem::Kind::Attribute); // CGA's constants stay in their file
		if (!is_listed && is_attribute) {
			imported.inherits = own;
		}
	}
}

RuleSet Loader::run(const std::string &path, std::string_view style) {
	_set.spaces.emplace_back();
	const uint32_t file = read(resolve_import({}, path), nullptr, nullptr);
	if (file != no_node) {
		require_style(*_set.files[file], style, _diagnostics);
		load_module(file, 0, 0, std::string(style));
	}
	return std::move(_set);
}

} // namespace

RuleSet load_rule_set(const std::string &path, const Dialect &dialect, SourceProvider &provider, Diagnostics &diagnostics,
		std::string_view style) {
	return Loader(dialect, provider, diagnostics).run(path, style);
}

} // namespace pcg
