#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/cga/context.h"
#include "core/cga/material_variables.h"
#include "core/cga/operations/operations.h"

// color, texture and set (CGA reference, sections 7.1, 7.3 and 7.8).
namespace pcg::cga {

namespace {

Flow color_from_text(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	glm::vec4 color = context.shape.look->color;
	if (!args[0].is_text() || !context.read_color(*args[0].text, color)) {
		vm.warn("bad-color", "a colour is written \"#rrggbb\" or, with opacity, \"#rrggbbaa\"");
		return Flow::Next;
	}
	Look &look = context.own_look();
	look.color = color;
	look.mark(LookPart::Color);
	if (args[0].text->view.size() > 7) {
		look.mark(LookPart::Opacity);
	}
	return Flow::Next;
}

Flow color_from_numbers(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Look &look = context.own_look();
	for (int i = 0; i < int(args.count()); ++i) {
		look.color[i] = float(std::clamp(context.finite(args[size_t(i)]), 0.0, 1.0));
	}
	look.mark(LookPart::Color);
	if (args.count() > 3) {
		look.mark(LookPart::Opacity);
	}
	return Flow::Next;
}

Flow texture(Vm &vm, const Args &args) {
	if (args[0].is_text()) {
		set_color_texture(Context::of(vm), *args[0].text);
	}
	return Flow::Next;
}

Flow set(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	if (args[0].type == ValueType::Attribute) {
		context.own_attributes();
		context.shape.attributes[args[0].index] = args[1];
	} else if (args[0].type == ValueType::Variable && !write_variable(vm, args[0].index, args[1])) {
		vm.warn("cannot-set", "set() has no effect here: this cannot be set to such a value");
	}
	return Flow::Next;
}

} // namespace

void add_appearance_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	operations.push_back({ "color", { { "text", Text } }, BlockKind::None, color_from_text, "Sets the colour: \"#rrggbb\", or \"#rrggbbaa\" with opacity." });
	operations.push_back({ "color", { { "red", Number }, { "green", Number }, { "blue", Number }, { "opacity", Number, {}, true } }, BlockKind::None,
			color_from_numbers, "Sets the colour; all from 0 to 1." });
	operations.push_back({ "texture", { { "file", Text } }, BlockKind::None, texture,
			"Sets the picture of the colour map, and of the opacity map if it has an alpha channel. Texture coordinates come from projectUV() or the asset." });
	operations.push_back({ "set", { { "name", Target }, { "value", Any } }, BlockKind::None, set,
			"Sets an attribute of the rule file, of the material or of the scope, for this shape and those made of it." });
}

} // namespace pcg::cga
