#include <algorithm>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "core/cga/append.h"
#include "core/cga/cleanup.h"
#include "core/cga/context.h"
#include "core/cga/junctions.h"
#include "core/cga/unite.h"

// Successors that become the current shape (CGA reference: op_inline), and what the interpreter asks for between them.
namespace pcg::cga {

Value *Context::copy_attributes(Vm &) {
	if (shape.attributes == nullptr) { // attributes are being evaluated: there is no shape yet
		return nullptr;
	}
	own_attributes();
	return shape.attributes;
}

std::string Context::tree_key() const {
	std::vector<uint32_t> way;
	for (const KeyNode *node = shape.key; node != nullptr; node = node->parent) {
		way.push_back(node->index);
	}
	std::string text = "0;";
	for (size_t i = way.size(); i-- > 0;) {
		text += std::to_string(way[i]) + ";";
	}
	return text;
}

void Context::reseed(uint64_t seed) {
	shape.seed = seed;
	_body.random = Random(seed, 0);
	_body.child_count = 0;
}

// Everything that waits, with its memory kept: the leaves are still needed.
void Context::run_now() {
	std::vector<Pending> waiting(_children.rbegin(), _children.rend());
	while (!waiting.empty()) {
		const Pending pending = waiting.back();
		waiting.pop_back();
		if (!run_rule(pending)) {
			return;
		}
		waiting.insert(waiting.end(), _children.rbegin(), _children.rend());
	}
}

Flow Context::run_inline(Chunk body, Merge strategy) {
	std::vector<Shape> leaves;
	std::vector<Shape> *const outer_collected = _collected;
	std::vector<Pending> outer_children = std::move(_children);
	const Shape outer = shape;
	const Body outer_body = _body;
	const uint32_t outer_count = _successor_count;
	_children.clear();
	_collected = &leaves;
	Flow flow = run_child(outer, body);
	if (flow == Flow::Next) {
		run_now();
	}
	_collected = outer_collected;
	_children = std::move(outer_children);
	_successor_count = outer_count;
	make_current(outer);
	_body = outer_body;
	++_body.child_count; // its random numbers are not used again
	if (vm.has_failed() || _is_stopped) {
		return Flow::Stop;
	}
	merge(leaves, strategy);
	return flow;
}

namespace {

constexpr double most_unite_cost = 1e7; // a second or two

const Geometry *moved(const Geometry &part, const Frame &to_target, Arena &arena) {
	const Geometry *const one = &part;
	Appender appender(arena, std::span(&one, 1));
	appender.add(part, to_target);
	return appender.finish();
}

// Its faces keep what the look makes of them, when their shape gets another.
const Geometry *with_look(const Geometry &part, const Look &look, MaterialTable &materials, Arena &arena) {
	GeometryFace *faces = arena.copy(part.faces, part.face_count);
	for (uint32_t i = 0; i < part.face_count; ++i) {
		const bool is_as_before = i > 0 && part.faces[i].material == part.faces[i - 1].material;
		faces[i].material = is_as_before ? faces[i - 1].material : materials.look_material(look, part.faces[i].material);
	}
	Geometry *result = arena.make(part);
	result->faces = faces;
	return result;
}

// What rules set until now says nothing of the faces that are there.
void forget_parts(Look &look, Arena &arena) {
	look.parts = 0;
	if (look.textures != nullptr) {
		TextureSlots *textures = arena.copy(look.textures, 1);
		for (TextureSlot &slot : textures->slots) {
			slot.is_placed = 0;
		}
		look.textures = textures;
	}
}

} // namespace

// One leaf is taken as it is; of several the geometry, each face with the material that its leaf had.
void Context::merge(std::span<const Shape> leaves, Merge strategy) {
	const Shape outer = shape;
	if (leaves.size() == 1) {
		make_current(leaves[0]);
		shape.seed = outer.seed;
		shape.depth = outer.depth;
		shape.key = outer.key;
		shape.tree = outer.tree;
		shape.object = outer.object;
		return;
	}
	const bool has_one_look = std::ranges::all_of(leaves, [&](const Shape &leaf) { return is_same(*leaf.look, *leaves[0].look); });
	std::vector<const Geometry *> parts = parts_of(leaves, !has_one_look);
	if (strategy == Merge::Unify) {
		unify(parts);
	}
	Appender appender(arena, parts);
	for (const Geometry *part : parts) {
		if (part != nullptr) {
			appender.add(*part, Frame());
		}
	}
	const Geometry *merged = appender.finish();
	if (!has_one_look) {
		forget_parts(own_look(), arena);
	} else if (!leaves.empty()) {
		shape.look = leaves[0].look;
	}
	if (merged == nullptr) {
		shape.geometry = nullptr;
		return;
	}
	set_geometry(shape, merged);
	if (strategy != Merge::Append) {
		connect_parts();
	}
}

std::vector<const Geometry *> Context::parts_of(std::span<const Shape> leaves, bool keeps_looks) {
	std::vector<const Geometry *> parts;
	for (const Shape &leaf : leaves) {
		parts.push_back(part_of(leaf, keeps_looks));
	}
	if (keeps_looks && model.materials().is_full()) {
		vm.warn("too-many-materials", "the parts of inline look different in more than 65,000 ways: what comes later looks like the shape itself",
				"give fewer parts colours of their own, or leave them out of the inline");
	}
	return parts;
}

// In the current shape's scope.
const Geometry *Context::part_of(const Shape &leaf, bool keeps_look) {
	const Geometry *geometry = baked(leaf, arena);
	const Frame target = shape.frame(), own = leaf.frame();
	const Frame to_target = { glm::transpose(target.axes) * own.axes, target.to_local(own.origin) };
	if (geometry == nullptr) {
		return nullptr;
	}
	return moved(keeps_look ? *with_look(*geometry, *leaf.look, model.materials(), arena) : *geometry, to_target, arena);
}

void Context::unify(std::span<const Geometry *> parts) {
	if (unite_cost(parts) > most_unite_cost) {
		vm.warn("too-large", "the parts of inline(unify) have too many faces: what lies inside of others stays", "unify simple bodies and insert models later");
		return;
	}
	if (!std::ranges::all_of(parts, [](const Geometry *part) { return part == nullptr || can_unite(*part); })) {
		vm.warn("not-closed", "a part of inline(unify) is neither flat nor closed: what lies inside of it stays", "unify bodies, such as what extrude makes");
	}
	unite(parts, builder, arena);
}

// Vertices in one place become one, and neighbours share their edges.
void Context::connect_parts() {
	const bool is_closed = shape.geometry->is_closed;
	clean_up(shape, {}, builder, arena);
	if (shape.geometry != nullptr) {
		Geometry *welded = arena.make(*shape.geometry);
		welded->is_closed = is_closed; // clean_up() did not see the neighbours that share parts of edges
		shape.geometry = with_junctions(*welded, 0.0, 180.0, builder, arena);
	}
}

} // namespace pcg::cga
