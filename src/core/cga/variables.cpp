#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/utf8.h"
#include "core/cga/context.h"
#include "core/cga/material_variables.h"
#include "core/cga/operations/operations.h"

// What rules read of their shape (CGA reference: attr_scope, attr_pivot, attr_material, section 3).
namespace pcg::cga {

namespace {

using Writer = bool (*)(Context &context, double value);

struct Row {
	std::string_view name;
	ValueType type;
	VariableHandler read;
	Writer write; // of numbers; nullptr: read only
	std::string_view help;
};

Shape &shape_of(Vm &vm) {
	return Context::of(vm).shape;
}

template <int axis> Value read_position(Vm &vm) { return Value::of(shape_of(vm).position[axis]); }
template <int axis> Value read_rotation(Vm &vm) { return Value::of(euler_from_rotation(shape_of(vm).rotation)[axis]); }
template <int axis> Value read_size(Vm &vm) { return Value::of(shape_of(vm).size[axis]); }
template <int axis> bool write_position(Context &context, double value) {
	context.shape.position[axis] = value;
	return true;
}
template <int axis> bool write_rotation(Context &context, double value) {
	glm::dvec3 angles = euler_from_rotation(context.shape.rotation);
	angles[axis] = value;
	context.shape.rotation = rotation_from_euler(angles);
	return true;
}
template <int axis> bool write_size(Context &context, double value) {
	Shape &shape = context.shape;
	const double factor = shape.size[axis] != 0.0 ? value / shape.size[axis] : 1.0;
	shape.geometry_offset[axis] *= factor;
	shape.geometry_scale[axis] *= factor;
	shape.size[axis] = value;
	return true;
}

Frame pivot_in_object(Vm &vm) {
	const Context &context = Context::of(vm);
	const Frame object = { context.lot().object_axes, glm::dvec3(0.0) };
	const Frame &pivot = *context.shape.pivot;
	return { glm::transpose(object.axes) * pivot.axes, object.to_local(pivot.origin) };
}
template <int axis> Value read_pivot(Vm &vm) { return Value::of(pivot_in_object(vm).origin[axis]); }
template <int axis> Value read_pivot_turn(Vm &vm) { return Value::of(euler_from_rotation(pivot_in_object(vm).axes)[axis]); }
void set_pivot(Context &context, const Frame &in_object) {
	context.shape.pivot = context.arena.make(Frame{ context.lot().object_axes, glm::dvec3(0.0) } * in_object);
}
template <int axis> bool write_pivot(Context &context, double value) {
	Frame pivot = pivot_in_object(context.vm);
	pivot.origin[axis] = value;
	set_pivot(context, pivot);
	return true;
}
template <int axis> bool write_pivot_turn(Context &context, double value) {
	Frame pivot = pivot_in_object(context.vm);
	glm::dvec3 angles = euler_from_rotation(pivot.axes);
	angles[axis] = value;
	pivot.axes = rotation_from_euler(angles);
	set_pivot(context, pivot);
	return true;
}
template <int axis> Value read_origin_turn(Vm &vm) { return Value::of(euler_from_rotation(Context::of(vm).lot().object_axes)[axis]); }
template <int axis> Value read_origin(Vm &vm) { return Value::of(Context::of(vm).lot().origin[axis]); }

template <bool Shape::*member> Value read_flag(Vm &vm) { return Value::of(shape_of(vm).*member); }
template <bool Shape::*member> bool write_flag(Context &context, double value) {
	context.shape.*member = value != 0.0;
	return true;
}

template <uint32_t Shape::*member> Value read_index(Vm &vm) { return Value::of(double(shape_of(vm).*member)); }
Value read_comp_index(Vm &vm) { return Value::of(shape_of(vm).comp_total > 0 ? double(shape_of(vm).comp_index) : -1.0); }

// The expression in front of an entry's separator, as far as it stands on one line.
std::string_view selector_text(const Program &program, const BlockEntry &entry) {
	if (entry.place.file >= program.sources.size() || entry.place.column == 0) {
		return {};
	}
	std::string_view text = program.sources[entry.place.file]->line(entry.place.line);
	text.remove_prefix(byte_of_character(text, entry.place.column - 1));
	const auto is_comparison = [&](size_t i) {
		const bool follows = i > 0 && std::string_view("=<>!").find(text[i - 1]) != std::string_view::npos;
		return follows || (i + 1 < text.size() && text[i + 1] == '=');
	};
	size_t end = 0;
	for (bool is_quoted = false; end < text.size(); ++end) {
		is_quoted ^= text[end] == '"';
		if (!is_quoted && (text[end] == ':' || (text[end] == '=' && !is_comparison(end)))) {
			break;
		}
	}
	text = text.substr(0, end);
	return text.substr(0, text.find_last_not_of(" \t") + 1);
}

Value read_selector(Vm &vm) {
	const Shape &shape = shape_of(vm);
	if (shape.comp_selector != no_symbol) {
		return Value::of(&vm.program().texts[shape.comp_selector]);
	}
	return Value::of(vm.make_text(shape.comp_entry != no_symbol ? selector_text(vm.program(), vm.program().entries[shape.comp_entry]) : ""));
}
Value read_elevation(Vm &vm) {
	const Context &context = Context::of(vm);
	return Value::of(context.shape.frame().origin.y + context.lot().origin.y);
}
Value read_name(Vm &vm) { return Value::of(vm.make_text(Context::of(vm).initial_shape().name)); }
Value read_start_rule(Vm &vm) { return Value::of(vm.make_text(Context::of(vm).start_rule_name())); }
// As a number that fits a double exactly. Small whole numbers are seeds themselves, so that what was set is read again.
constexpr uint64_t small_seeds = uint64_t(1) << 31;
Value read_seed(Vm &vm) {
	const uint64_t seed = shape_of(vm).seed;
	return Value::of(double(seed < small_seeds ? seed : seed >> 33));
}
// Fits a double exactly and prints in 15 digits.
Value read_uid(Vm &vm) { return Value::of(double(derive_seed(shape_of(vm).seed, 0) >> 15)); }
bool write_seed(Context &context, double value) {
	const bool is_small = value >= 0.0 && value < double(small_seeds) && value == std::floor(value);
	context.reseed(is_small ? uint64_t(value) : derive_seed(uint64_t(int64_t(std::clamp(value * 1024.0, -9e15, 9e15))), 0));
	return true;
}

constexpr ValueType number = ValueType::Number;
constexpr ValueType text = ValueType::Text;

constexpr Row rows[] = {
	{ "scope.tx", number, read_position<0>, write_position<0>, "Place of the scope in its pivot, metres." },
	{ "scope.ty", number, read_position<1>, write_position<1>, "Place of the scope in its pivot, metres." },
	{ "scope.tz", number, read_position<2>, write_position<2>, "Place of the scope in its pivot, metres." },
	{ "scope.rx", number, read_rotation<0>, write_rotation<0>, "Turn of the scope in its pivot, degrees." },
	{ "scope.ry", number, read_rotation<1>, write_rotation<1>, "Turn of the scope in its pivot, degrees." },
	{ "scope.rz", number, read_rotation<2>, write_rotation<2>, "Turn of the scope in its pivot, degrees." },
	{ "scope.sx", number, read_size<0>, write_size<0>, "Size of the scope, metres." },
	{ "scope.sy", number, read_size<1>, write_size<1>, "Size of the scope, metres." },
	{ "scope.sz", number, read_size<2>, write_size<2>, "Size of the scope, metres." },
	{ "scope.elevation", number, read_elevation, nullptr, "Height of the scope's origin in the world, metres." },
	{ "pivot.px", number, read_pivot<0>, write_pivot<0>, "Place of the pivot in the object's system, metres." },
	{ "pivot.py", number, read_pivot<1>, write_pivot<1>, "Place of the pivot in the object's system, metres." },
	{ "pivot.pz", number, read_pivot<2>, write_pivot<2>, "Place of the pivot in the object's system, metres." },
	{ "pivot.ox", number, read_pivot_turn<0>, write_pivot_turn<0>, "Turn of the pivot in the object's system, degrees." },
	{ "pivot.oy", number, read_pivot_turn<1>, write_pivot_turn<1>, "Turn of the pivot in the object's system, degrees." },
	{ "pivot.oz", number, read_pivot_turn<2>, write_pivot_turn<2>, "Turn of the pivot in the object's system, degrees." },
	{ "initialShape.name", text, read_name, nullptr, "Name of the lot." },
	{ "initialShape.startRule", text, read_start_rule, nullptr, "The rule that the derivation began with." },
	{ "initialShape.origin.px", number, read_origin<0>, nullptr, "Place of the object's system in the world, metres." },
	{ "initialShape.origin.py", number, read_origin<1>, nullptr, "Place of the object's system in the world, metres." },
	{ "initialShape.origin.pz", number, read_origin<2>, nullptr, "Place of the object's system in the world, metres." },
	{ "initialShape.origin.ox", number, read_origin_turn<0>, nullptr, "Turn of the object's system in the world, degrees." },
	{ "initialShape.origin.oy", number, read_origin_turn<1>, nullptr, "Turn of the object's system in the world, degrees." },
	{ "initialShape.origin.oz", number, read_origin_turn<2>, nullptr, "Turn of the object's system in the world, degrees." },
	{ "initialShape.symbol", text, read_start_rule, nullptr, "Old name of initialShape.startRule." },
	{ "split.index", number, read_index<&Shape::split_index>, nullptr, "Number of this part in the last split, from 0." },
	{ "split.total", number, read_index<&Shape::split_total>, nullptr, "How many parts the last split made." },
	{ "comp.index", number, read_comp_index, nullptr, "Number of this component for its selector, from 0; -1 before the first comp()." },
	{ "comp.total", number, read_index<&Shape::comp_total>, nullptr, "How many components its selector took." },
	{ "comp.sel", text, read_selector, nullptr, "The selector that took this component." },
	{ "seedian", number, read_seed, write_seed, "The seed of this shape." },
	{ "uid", number, read_uid, nullptr, "A whole number that belongs to this shape." },
	{ "trim.horizontal", ValueType::Bool, read_flag<&Shape::trims_horizontally>, write_flag<&Shape::trims_horizontally>,
			"Whether inserted geometry is cut at edges less than 40 degrees from the floor of their face; off unless it is set." },
	{ "trim.vertical", ValueType::Bool, read_flag<&Shape::trims_vertically>, write_flag<&Shape::trims_vertically>,
			"Whether inserted geometry is cut at the other edges of its face; on unless it is set." },
};

} // namespace

void add_variables(Dialect &dialect) {
	for (const Row &row : rows) {
		dialect.variables.push_back({ row.name, row.type, row.read, row.help, row.write != nullptr });
	}
	add_material_variables(dialect);
}

bool write_variable(Vm &vm, uint32_t variable, const Value &value) {
	if (variable >= std::size(rows)) {
		return write_material_variable(vm, variable - uint32_t(std::size(rows)), value);
	}
	Context &context = Context::of(vm);
	const Row &row = rows[variable];
	const bool is_right_type = row.type == ValueType::Bool ? value.is_bool() : value.is_number();
	return is_right_type && row.write != nullptr && row.write(context, value.is_bool() ? double(value.boolean) : context.finite(value));
}

} // namespace pcg::cga
