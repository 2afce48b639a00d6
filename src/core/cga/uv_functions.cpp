#include "core/cga/uv.h"

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// geometry.du geometry.uMin geometry.hasUVs .. (CGA reference, section 8.3).
namespace pcg::cga {

namespace {

int set_argument(Vm &vm, const Args &args) {
	return args.count() > 0 ? uv_set_of(Context::of(vm), args[0]) : 0;
}

UvRange range_of(Vm &vm, const Args &args) {
	const int set = set_argument(vm, args);
	const Geometry *geometry = Context::of(vm).shape.geometry;
	return set >= 0 && geometry != nullptr ? uv_range(*geometry, size_t(set)) : UvRange();
}

// Second argument: in the texture, or in metres on the surface.
template <int axis> Value extent(Vm &vm, const Args &args) {
	const double size = range_of(vm, args).size()[axis];
	const bool is_in_metres = args[1].word == 1;
	return Value::of(is_in_metres && size > 0.0 ? size * uv_stretch(Context::of(vm).shape, size_t(set_argument(vm, args)))[axis] : size);
}

template <int axis> Value lowest(Vm &vm, const Args &args) { return Value::of(range_of(vm, args).low[axis]); }
template <int axis> Value highest(Vm &vm, const Args &args) { return Value::of(range_of(vm, args).high[axis]); }
Value has_uvs(Vm &vm, const Args &args) { return Value::of(!range_of(vm, args).is_empty); }

} // namespace

void add_uv_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec set = { "uvSet", Number }, space = { "space", Word, "uvSpace unitSpace" }, any_set = { "uvSet", Number, {}, true };
	const ValueType number = ValueType::Number;
	functions.push_back({ "geometry.du", { set, space }, number, extent<0>, "Extent of a set of texture coordinates along u: in the texture, or in metres on the surface." });
	functions.push_back({ "geometry.dv", { set, space }, number, extent<1>, "The same along v." });
	functions.push_back({ "geometry.uMin", { any_set }, number, lowest<0>, "Least u of a set of texture coordinates (set 0 if nothing is said)." });
	functions.push_back({ "geometry.uMax", { any_set }, number, highest<0>, "Greatest u." });
	functions.push_back({ "geometry.vMin", { any_set }, number, lowest<1>, "Least v." });
	functions.push_back({ "geometry.vMax", { any_set }, number, highest<1>, "Greatest v." });
	functions.push_back({ "geometry.hasUVs", { any_set }, ValueType::Bool, has_uvs, "Whether any corner has texture coordinates in the set." });
}

} // namespace pcg::cga
