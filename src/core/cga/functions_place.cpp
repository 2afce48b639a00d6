#include <array>

#include <glm/matrix.hpp>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// Places and turns from one coordinate system to another (CGA reference, section 8.3).
namespace pcg::cga {

namespace {

// Word of the systems: scope pivot object world. In the derivation's coordinates.
Frame system_frame(const Context &context, uint32_t word) {
	switch (word) {
		case 0:
			return context.shape.frame();
		case 1:
			return *context.shape.pivot;
		case 2:
			return { context.lot().object_axes, glm::dvec3(0.0) };
		default:
			return { glm::dmat3(1.0), -context.lot().origin };
	}
}

glm::dvec3 converted(const Context &context, uint32_t from_word, uint32_t to_word, bool is_turn, glm::dvec3 value) {
	const Frame from = system_frame(context, from_word), to = system_frame(context, to_word);
	if (is_turn) {
		return euler_from_rotation(glm::transpose(to.axes) * from.axes * rotation_from_euler(value));
	}
	return from_word == to_word ? value : to.to_local(from.to_parent(value));
}

Value convert(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const glm::dvec3 value(context.finite(args[4]), context.finite(args[5]), context.finite(args[6]));
	return Value::of(converted(context, args[1].word, args[2].word, args[3].word == 1, value)[int(args[0].word)]);
}

Value convert_array(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	glm::dvec3 value(0.0);
	for (uint32_t i = 0; args[3].is_array() && i < 3 && i < args[3].array->size(); ++i) {
		value[int(i)] = context.finite(args[3].array->values[i]);
	}
	const glm::dvec3 result = converted(context, args[0].word, args[1].word, args[2].word == 1, value);
	const std::array<Value, 3> values = { Value::of(result.x), Value::of(result.y), Value::of(result.z) };
	return Value::of(vm.make_array(values));
}

// Nothing says where on the earth the world lies.
Value geo_coordinate(Vm &vm, const Args &args) {
	const Context &context = Context::of(vm);
	vm.warn("no-georeference", "the world has no place on the earth: getGeoCoord gives the world's x (X, lon) and -z (Y, lat) in metres");
	const glm::dvec3 place = context.lot().origin + context.shape.frame().origin;
	return Value::of(args[0].word % 2 == 0 ? place.x : -place.z);
}

} // namespace

void add_place_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec from = { "from", Word, "scope pivot object world" }, to = { "to", Word, "scope pivot object world" };
	const ParamSpec type = { "type", Word, "pos orient" };
	functions.push_back({ "convert", { { "coordinate", Word, "x y z" }, from, to, type, { "x", Number }, { "y", Number }, { "z", Number } }, ValueType::Number,
			convert, "One coordinate of a place (pos), or one angle of a turn (orient), brought from one coordinate system to another." });
	functions.push_back({ "convert", { from, to, type, { "coordinates", Any } }, ValueType::Array, convert_array,
			"All three, from and to an array." });
	functions.push_back({ "getGeoCoord", { { "coordinate", Word, "X Y lon lat" } }, ValueType::Number, geo_coordinate,
			"Accepted: without a georeference the world's x or -z of the scope's origin, with a warning." });
}

} // namespace pcg::cga
