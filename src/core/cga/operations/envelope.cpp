#include "core/geometry/envelope.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/components.h"
#include "core/cga/context.h"
#include "core/cga/operations/operations.h"
#include "core/geometry/polygon.h"

// envelope(direction, maxHeight, height, angle ..) (CGA reference, section 5.5).
namespace pcg::cga {

namespace {

// Front, back, right, left; what is not given has no limit but the envelope's height.
struct EnvelopeArgs {
	double max_height = 0.0;
	std::array<EnvelopeSide, 4> sides;
	const ArrayData *heights = nullptr, *angles = nullptr; // instead, by edge
};

EnvelopeSide side_of(Context &context, const Value &height, const Value &angle) {
	return { std::max(0.0, context.finite(height)), context.finite(angle) };
}

// `first`: the argument behind the greatest height.
EnvelopeArgs read_args(Context &context, const Args &args, size_t first) {
	EnvelopeArgs result;
	result.max_height = context.finite(args[first - 1]);
	if (args.count() == first + 2 && args[first].type == ValueType::Array && args[first + 1].type == ValueType::Array) {
		result.heights = args[first].array;
		result.angles = args[first + 1].array;
		return result;
	}
	size_t sides = (args.count() - first) / 2;
	for (size_t i = 0; i < std::min<size_t>(sides, 4); ++i) {
		result.sides[i] = side_of(context, args[first + 2 * i], args[first + 2 * i + 1]);
	}
	if (sides == 3) { // both sides alike
		result.sides[3] = result.sides[2];
	}
	return result;
}

EnvelopeSide side_at(Context &context, const EnvelopeArgs &args, const ComponentInfo &edge, uint32_t index) {
	const auto element = [&](const ArrayData &array, double otherwise) {
		return Value::of(index < size_t(array.rows) * array.columns ? array.values[index].number : otherwise);
	};
	if (args.heights != nullptr) {
		return side_of(context, element(*args.heights, 0.0), element(*args.angles, 90.0));
	}
	static constexpr SelectorKind kinds[] = { SelectorKind::Front, SelectorKind::Back, SelectorKind::Right, SelectorKind::Left };
	for (size_t i = 0; i < 4; ++i) {
		if (matches({ kinds[i], SelectorSystem::Street }, edge.component, context.shape, context.lot())) {
			return args.sides[i];
		}
	}
	return {};
}

std::vector<EnvelopeSide> sides_of(Context &context, const EnvelopeArgs &args, const std::vector<ComponentInfo> &edges, uint32_t first, uint32_t count) {
	std::vector<EnvelopeSide> sides;
	for (uint32_t i = first; i < first + count; ++i) {
		sides.push_back(side_at(context, args, edges[i], i));
	}
	return sides;
}

// Into the plane across `frame`'s z; heights above it are given back.
struct Ground {
	Frame frame;
	Loops2 loops;
};

Ground ground_of(const Geometry &geometry, const GeometryFace &face, glm::dvec3 up) {
	const auto outline = geometry.outline(face);
	Ground ground{ { axes_from_z(up, outline[1] - outline[0]), outline[0] }, {} };
	double lowest = 0.0;
	for (uint32_t i = 0; i < face.loop_count; ++i) {
		ground.loops.emplace_back();
		for (const glm::dvec3 &point : geometry.loop(face.first_loop + i)) {
			const glm::dvec3 local = ground.frame.to_local(point);
			ground.loops.back().push_back({ local.x, local.y });
			lowest = std::min(lowest, local.z);
		}
	}
	ground.frame.origin += up * lowest;
	return ground;
}

void add_faces(GeometryBuilder &builder, const Envelope &envelope, const Frame &frame, uint16_t material) {
	for (const EnvelopeFace &face : envelope.faces) {
		for (const auto &loop : face.loops) {
			for (const glm::dvec3 &point : loop) {
				builder.add_point(frame.to_parent(point));
			}
			builder.end_loop();
		}
		builder.end_face(FaceTag::None, material);
	}
}

Flow build(Context &context, const EnvelopeArgs &args, bool is_world_up) {
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr) {
		return Flow::Next;
	}
	if (args.max_height <= 0.0) {
		context.vm.warn("not-positive", "the greatest height of an envelope must be above 0; the shape stays as it is");
		return Flow::Next;
	}
	const std::vector<ComponentInfo> edges = components_of(*geometry, ComponentKind::FaceEdges);
	const glm::dvec3 world_up = glm::transpose(context.shape.frame().axes) * glm::dvec3(0.0, 1.0, 0.0);
	GeometryBuilder builder;
	uint32_t first = 0;
	bool is_closed = true;
	for (uint32_t f = 0; f < geometry->face_count; ++f) {
		const GeometryFace &face = geometry->faces[f];
		const uint32_t count = geometry->face_point_count(face);
		const glm::dvec3 normal = face_normal(*geometry, face);
		const std::vector<EnvelopeSide> sides = sides_of(context, args, edges, first, count);
		first += count;
		if (geometry->outline(face).size() < 3) {
			continue;
		}
		const Ground ground = ground_of(*geometry, face, is_world_up && glm::dot(normal, world_up) > 1e-3 ? world_up : normal);
		const Envelope envelope = make_envelope(ground.loops, sides, args.max_height);
		is_closed &= envelope.is_closed;
		add_faces(builder, envelope, ground.frame, face.material);
	}
	if (!is_closed) {
		context.vm.warn("broken-outline", "the envelope over this face is not closed: its outline crosses itself");
	}
	if (const Geometry *result = builder.finish(context.arena, is_closed)) {
		const glm::dvec3 up = is_world_up ? world_up : face_normal(*geometry, geometry->faces[0]);
		set_geometry(context.shape, result);
		turn_scope(context.shape, axes_from_y(up, { 1.0, 0.0, 0.0 }), context.builder, context.arena);
	}
	return Flow::Next;
}

Flow envelope(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return build(context, read_args(context, args, 2), args[0].word == 1);
}

Flow envelope_of_old_files(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return build(context, read_args(context, args, 1), false);
}

} // namespace

void add_envelope_operations(Dialect &dialect) {
	using enum ParamKind;
	const std::vector<ParamSpec> params = { { "maxHeight", Number }, { "frontHeight", Any }, { "frontAngle", Any }, { "backHeight", Number, {}, true },
		{ "backAngle", Number, {}, true }, { "rightHeight", Number, {}, true }, { "rightAngle", Number, {}, true },
		{ "leftHeight", Number, {}, true }, { "leftAngle", Number, {}, true } };
	constexpr std::string_view help =
			"The volume that may be built over each face: walls as high as said for the side (metres), planes above them that lean inwards (degrees from "
			"the horizontal), a flat top at the greatest height. Sides are those of street.front and so on; three pairs are front, back and both "
			"sides; two arrays have a height and an angle for each edge.";
	std::vector<ParamSpec> with_direction = params;
	with_direction.insert(with_direction.begin(), { "direction", Word, "normal world.up" });
	dialect.operations.push_back({ "envelope", with_direction, BlockKind::None, envelope, help }); // first: its word tells the two apart
	dialect.operations.push_back({ "envelope", params, BlockKind::None, envelope_of_old_files, help });
}

} // namespace pcg::cga
