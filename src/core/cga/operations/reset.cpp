#include <string>

#include "core/cga/context.h"
#include "core/cga/functions/functions.h"
#include "core/cga/initial_shape.h"
#include "core/cga/operations/operations.h"

// resetGeometry, resetMaterial and setMaterial: back to the beginning, or all of a material at once (CGA reference: op_resetGeometry,
// op_resetMaterial, op_setMaterial).
namespace pcg::cga {

namespace {

// Attributes, look and projections stay.
Flow reset_geometry(Vm &vm, const Args &) {
	Context &context = Context::of(vm);
	Lot lot;
	Shape first;
	Diagnostics told_before;
	if (make_initial_shape(context.initial_shape(), context.builder, context.arena, lot, first, told_before)) {
		Shape &shape = context.shape;
		shape.geometry = first.geometry;
		shape.geometry_offset = first.geometry_offset;
		shape.geometry_scale = first.geometry_scale;
		shape.pivot = first.pivot;
		shape.position = first.position;
		shape.rotation = first.rotation;
		shape.size = first.size;
		shape.trim = nullptr;
	}
	return Flow::Next;
}

const Geometry *without_materials(const Geometry &geometry, Arena &arena) {
	GeometryFace *faces = arena.copy(geometry.faces, geometry.face_count);
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		faces[i].material = 0;
	}
	Geometry *plain = arena.make(geometry);
	plain->faces = faces;
	plain->is_instance = false;
	return plain;
}

Flow reset_material(Vm &vm, const Args &args) {
	enum : uint32_t { OfShape, OfGeometry, All };
	Context &context = Context::of(vm);
	const uint32_t target = args.count() > 0 ? args[0].word : uint32_t(OfShape);
	if (target != OfGeometry) {
		context.own_look() = Look();
	}
	if (target != OfShape && context.shape.geometry != nullptr) {
		context.shape.geometry = without_materials(*context.shape.geometry, context.arena);
	}
	return Flow::Next;
}

// The text as what the variable holds.
Value value_of(const Text &text, ValueType type) {
	return type == ValueType::Text ? Value::of(&text) : type == ValueType::Bool ? Value::of(text.view == "true") : Value::of(number_of(text.view));
}

Flow set_material(Vm &vm, const Args &args) {
	const Dialect &dialect = *vm.program().dialect;
	const ArrayData *pairs = args[0].is_array() ? args[0].array : nullptr;
	for (uint32_t i = 0; pairs != nullptr && i + 1 < pairs->size(); i += 2) {
		const Value &name = pairs->values[i], &value = pairs->values[i + 1];
		const int variable = name.is_text() ? dialect.find_variable("material." + std::string(name.text->view)) : -1;
		if (variable < 0 || !value.is_text() || !write_variable(vm, uint32_t(variable), value_of(*value.text, dialect.variables[size_t(variable)].type))) {
			vm.warn("cannot-set", "setMaterial takes texts in pairs: the name of a material attribute without \"material.\", and its value; others are left out");
		}
	}
	return Flow::Next;
}

} // namespace

void add_reset_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	operations.push_back({ "resetGeometry", {}, BlockKind::None, reset_geometry,
			"Geometry, scope and pivot become those of the initial shape again; trim planes go. Attributes and materials stay." });
	operations.push_back({ "resetMaterial", { { "target", Word, "shape geometry all", true } }, BlockKind::None, reset_material,
			"Everything of the material is as at the beginning: what rules have set (shape), what an inserted model brought (geometry), or both." });
	operations.push_back({ "setMaterial", { { "material", Array } }, BlockKind::None, set_material,
			"Sets attributes of the material from an array of texts: names without \"material.\" and values in turn." });
}

} // namespace pcg::cga
