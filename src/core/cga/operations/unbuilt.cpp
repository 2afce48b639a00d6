#include <string>
#include <utility>
#include <vector>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// What the reference documents and this dialect has not: component tags, edge attributes, solid unions, groups of models. No public rule file
// calls them, but files that do must derive: a warning, and they go on.
namespace pcg::cga {

namespace {

Flow boolean_operation(Vm &vm, const Args &) {
	vm.warn("not-supported", "union, subtract and intersect of volumes are not built; the shape stays as it is");
	return Flow::Next;
}

Flow tag(Vm &vm, const Args &) {
	vm.warn("not-supported", "components carry no tags here; the shape stays as it is", "select by direction, by index or by a condition instead");
	return Flow::Next;
}

Flow modify(Vm &vm, const Args &) {
	vm.warn("not-supported", "modify is not built; the shape stays as it is", "inline(recompose) comp(f) { .. | all : X. } does the same for faces");
	return Flow::Next;
}

template <ValueType type> Value nothing(Vm &vm, const Args &args) {
	vm.warn("not-supported", std::string(static_cast<const char *>(args.user)) + " is not built; it gives 0, false or nothing");
	return type == ValueType::Array ? Value::of(vm.make_array({}, 1, ValueType::Text))
			: type == ValueType::Text ? Value::of(vm.make_text({}))
			: type == ValueType::Bool ? Value::of(false)
									  : Value::of(0.0);
}

Value metadata(Vm &, const Args &args) { return args[2]; }

// Whose tags are meant.
const ParamSpec parts = { "components", ParamKind::Word, "all faces edges vertices", true };

constexpr std::string_view function_help = "Not built: gives 0, false or nothing, with a warning.";

template <ValueType type> void add_function(Dialect &dialect, const char *name, std::vector<ParamSpec> params) {
	dialect.functions.push_back({ name, std::move(params), type, nothing<type>, function_help, false, name });
}

void add_unbuilt_functions(Dialect &dialect) {
	using enum ParamKind;
	const ParamSpec name = { "name", Text }, file = { "file", Text }, part = { "part", Word, "g m" };
	add_function<ValueType::Number>(dialect, "edgeAttr.getFloat", { name });
	add_function<ValueType::Text>(dialect, "edgeAttr.getString", { name });
	add_function<ValueType::Bool>(dialect, "edgeAttr.getBool", { name });
	add_function<ValueType::Text>(dialect, "assetNamingInfo", { file, part });
	add_function<ValueType::Array>(dialect, "assetNamingInfos", { file, part });
	add_function<ValueType::Array>(dialect, "getMaterial", { { "source", Word, "used shape geometry" }, { "mode", Word, "changed all" } });
	add_function<ValueType::Array>(dialect, "readMaterial", { file });
	add_function<ValueType::Array>(dialect, "geometry.groups", {});
	add_function<ValueType::Array>(dialect, "geometry.materials", {});
	add_function<ValueType::Array>(dialect, "geometry.tags", { { "query", Text, {}, true }, parts });
	add_function<ValueType::Bool>(dialect, "geometry.hasTags", { { "query", Text, {}, true }, parts });
}

} // namespace

void add_unbuilt(Dialect &dialect) {
	using enum ParamKind;
	constexpr std::string_view help = "Not built: the shape stays as it is, with a warning.";
	auto &operations = dialect.operations;
	const ParamSpec components = { "components", Word, "auto faces edges vertices", true };
	for (const char *name : { "union", "subtract", "intersect" }) {
		operations.push_back({ name, { { "swapMode", Word, "noSwap swap", true } }, BlockKind::Bodies, boolean_operation, help });
		operations.back().takes_rule = true; // CGA reference: op_boolOp
	}
	operations.push_back({ "tag", { { "name", Text }, components }, BlockKind::None, tag, help });
	operations.push_back({ "deleteTags", { { "query", Text, {}, true }, parts }, BlockKind::None, tag, help });
	operations.push_back({ "setTagsFromEdgeAttrs", {}, BlockKind::None, tag, help });
	operations.push_back({ "modify", { { "kind", Word, "f e v fe fv g m h" }, { "axes", Word, "zUp noAlign", true } }, BlockKind::Selectors, modify, help });
	add_unbuilt_functions(dialect);
	dialect.functions.push_back({ "assetMetadata", { { "file", Text }, { "key", Text }, { "default", Any } }, ValueType::Void, metadata,
			"Accepted: what files say beside their geometry is not read, so it gives the default." });
}

} // namespace pcg::cga
