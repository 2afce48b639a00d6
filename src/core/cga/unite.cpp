#include "core/cga/unite.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/cga/clip.h"
#include "core/cga/flat_face.h"
#include "core/geometry/overlay.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double smallest_piece = 1e-8; // twice its area: what is smaller comes of rounding

struct Box {
	glm::dvec3 low{ INFINITY }, high{ -INFINITY };
};

Box box_of(const Geometry &geometry, const GeometryFace &face) {
	Box box;
	for (const glm::dvec3 &point : geometry.outline(face)) {
		box.low = glm::min(box.low, point);
		box.high = glm::max(box.high, point);
	}
	return box;
}

Plane plane_of(const Geometry &geometry, const GeometryFace &face) {
	const auto outline = geometry.outline(face);
	const glm::dvec3 normal = loop_normal(outline);
	double sum = 0.0;
	for (const glm::dvec3 &point : outline) {
		sum += glm::dot(normal, point);
	}
	return { normal, sum / double(outline.size()) };
}

bool does_lie_in(const Plane &plane, std::span<const glm::dvec3> points, double margin) {
	return std::ranges::all_of(points, [&](glm::dvec3 point) { return std::abs(glm::dot(plane.normal, point) - plane.offset) <= margin; });
}

// Negative: its faces look inwards.
double volume_of(const Geometry &geometry) {
	double sum = 0.0;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			sum += glm::dot(geometry.loop(l)[0] - geometry.low, area_vector(geometry.loop(l)));
		}
	}
	return sum;
}

double size_of(const Loops2 &polygon) {
	double sum = 0.0;
	for (const Loop2 &loop : polygon) {
		sum += signed_area(loop);
	}
	return sum;
}

class Uniter {
public:
	Uniter(std::span<const Geometry *const> parts, GeometryBuilder &builder) : _parts(parts.begin(), parts.end()), _builder(builder) {
		glm::dvec3 size(0.0);
		for (const Geometry *part : _parts) {
			size = part != nullptr ? glm::max(size, glm::max(glm::abs(part->low), glm::abs(part->high))) : size;
		}
		_margin = 1e-9 * (size.x + size.y + size.z);
	}

	const Geometry *run(size_t index, Arena &arena) {
		const Geometry &part = *_parts[index];
		const bool is_turned = part.is_closed && volume_of(part) < 0.0;
		_builder.begin(part);
		bool is_changed = false;
		for (uint32_t f = 0; f < part.face_count; ++f) {
			if (part.outline(part.faces[f]).size() < 3 || !add_rest(index, f, is_turned)) {
				_builder.add_face(part, part.faces[f]);
			} else {
				is_changed = true;
			}
		}
		return is_changed ? _builder.finish(arena, part.is_closed) : &part;
	}

private:
	// False: nothing of the face is covered, and nothing is added.
	bool add_rest(size_t index, uint32_t f, bool is_turned) {
		const Geometry &part = *_parts[index];
		const FlatFace face(part, f);
		const Loops2 covered = covered_by_others(index, f, face, is_turned);
		if (covered.empty()) {
			return false;
		}
		Polygons2 rest = overlay(face.loops(), covered, OverlayKind::Difference);
		erase_if(rest, [](const Loops2 &polygon) { return size_of(polygon) < smallest_piece; });
		double size = 0.0;
		for (const Loops2 &polygon : rest) {
			size += size_of(polygon);
		}
		if (std::abs(size - size_of(face.loops())) < smallest_piece) {
			return false;
		}
		for (const Loops2 &polygon : rest) {
			face.add(_builder, polygon, face.face().tag);
		}
		return true;
	}

	Loops2 covered_by_others(size_t index, uint32_t f, const FlatFace &face, bool is_turned) {
		const Geometry &part = *_parts[index];
		const Plane plane = plane_of(part, part.faces[f]);
		const Plane outside = is_turned ? Plane{ -plane.normal, -plane.offset } : plane, inside = { -outside.normal, -outside.offset };
		const Box box = box_of(part, part.faces[f]);
		Loops2 covered;
		for (size_t i = 0; i < _parts.size(); ++i) {
			const Geometry *other = _parts[i];
			const bool do_meet = i != index && other != nullptr && glm::all(glm::lessThanEqual(box.low, other->high + _margin)) &&
					glm::all(glm::greaterThanEqual(box.high, other->low - _margin));
			if (!do_meet) {
				continue;
			}
			if (other->is_closed) {
				add_section(*other, outside, face, plane.normal, covered);
				if (i < index || !part.is_closed) {
					add_section(*other, inside, face, plane.normal, covered);
				}
			} else if (i < index && !part.is_closed) {
				add_faces_in(*other, plane, face, plane.normal, covered);
			}
		}
		return covered;
	}

	// What a plane cuts out of the body, seen a hair's breadth on its positive side.
	void add_section(const Geometry &body, const Plane &plane, const FlatFace &face, glm::dvec3 normal, Loops2 &covered) {
		const Arena::Mark mark = _scratch.mark();
		const Geometry *half = _clipper.clip(body, plane, _scratch);
		if (half != nullptr) {
			add_faces_in(*half, plane, face, normal, covered);
		}
		_scratch.release(mark);
	}

	void add_faces_in(const Geometry &other, const Plane &plane, const FlatFace &face, glm::dvec3 normal, Loops2 &covered) const {
		for (uint32_t f = 0; f < other.face_count; ++f) {
			const GeometryFace &source = other.faces[f];
			if (!does_lie_in(plane, other.outline(source), _margin)) {
				continue;
			}
			const bool is_reversed = glm::dot(face_normal(other, source), normal) < 0.0;
			for (uint32_t l = source.first_loop; l < source.first_loop + source.loop_count; ++l) {
				Loop2 &loop = covered.emplace_back();
				for (const glm::dvec3 &point : other.loop(l)) {
					loop.push_back(face.flat(point));
				}
				if (is_reversed) {
					std::ranges::reverse(loop);
				}
			}
		}
	}

	std::vector<const Geometry *> _parts; // as they were
	GeometryBuilder &_builder;
	Clipper _clipper;
	Arena _scratch;
	double _margin = 0.0;
};

} // namespace

void unite(std::span<const Geometry *> parts, GeometryBuilder &builder, Arena &arena) {
	Uniter uniter(parts, builder);
	for (size_t i = 0; i < parts.size(); ++i) {
		parts[i] = parts[i] != nullptr ? uniter.run(i, arena) : nullptr;
	}
}

double unite_cost(std::span<const Geometry *const> parts) {
	double sum = 0.0;
	for (size_t i = 0; i < parts.size(); ++i) {
		for (size_t j = 0; parts[i] != nullptr && j < i; ++j) {
			const bool do_meet = parts[j] != nullptr && glm::all(glm::lessThanEqual(parts[i]->low, parts[j]->high)) &&
					glm::all(glm::greaterThanEqual(parts[i]->high, parts[j]->low));
			sum += do_meet ? double(parts[i]->face_count) * double(parts[j]->face_count) : 0.0;
		}
	}
	return sum;
}

bool can_unite(const Geometry &part) {
	if (part.is_closed || part.face_count == 0) {
		return true;
	}
	const Plane plane = plane_of(part, part.faces[0]);
	const double margin = 1e-6 * (1.0 + glm::distance(part.low, part.high));
	return does_lie_in(plane, std::span(part.points, part.point_count), margin);
}

} // namespace pcg::cga
