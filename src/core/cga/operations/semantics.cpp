#include <algorithm>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// What the paper adds to CGA: entrance, zone, and where people use an object (paper, "Extensions to CGA"; CGA reference, section 1.8).
namespace pcg::cga {

namespace {

constexpr double default_zone_height = 3.0; // metres, of a flat scope

std::string_view text_of(const Value &value) {
	return value.is_text() ? value.text->view : std::string_view();
}

Flow entrance(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const double capacity = args.count() > 1 ? context.finite(args[1]) : 0.0;
	if (capacity < 0.0 || capacity > 1e9) {
		vm.warn("bad-capacity", "the capacity of an entrance is a number of persons, 0 or more");
	}
	context.model.add_entrance(text_of(args[0]), context.shape, std::clamp(capacity, 0.0, 1e9));
	return Flow::Next;
}

Flow zone(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const double height = args.count() > 1 ? context.finite(args[1]) : default_zone_height;
	if (!(height > 0.0)) {
		vm.warn("bad-zone-height", "the height of a zone is a positive number of metres; 3 is taken instead");
	}
	context.model.add_zone(text_of(args[0]), context.shape, height > 0.0 ? height : default_zone_height);
	return Flow::Next;
}

Flow place(Vm &vm, const Args &) {
	Context &context = Context::of(vm);
	if (!context.model.add_place(context.shape)) {
		vm.warn("place-without-object", "place() means nothing outside of an object", "write @Object(\"bench\") before the rule that makes the bench");
	}
	return Flow::Next;
}

} // namespace

void add_semantic_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	operations.push_back({ "entrance", { { "type", Text }, { "capacity", Number, {}, true } }, BlockKind::None, entrance,
			"An entrance of that type at the origin of the scope, facing its z; capacity = persons that live or work behind it." });
	operations.push_back({ "zone", { { "type", Text }, { "height", Number, {}, true } }, BlockKind::None, zone,
			"A zone of that type that spans the scope. A flat scope is raised along its normal by the height, 3 m if none is given." });
	operations.push_back({ "place", {}, BlockKind::None, place,
			"Where one person uses the object that this shape belongs to: at the origin of the scope, looking along its z." });
}

} // namespace pcg::cga
