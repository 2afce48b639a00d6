#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/geometry/solid.h"

// A closed convex solid as what lies behind all of its planes. Most of what is asked about a solid lies in front of one of them, or in it: that is told
// here from a few products, some fifty times as fast as by relate(), which has to say the rest.
namespace pcg {

class ConvexBody {
public:
	enum class Relation : uint8_t {
		Apart, // neither inside nor overlapping nor touching
		Contact, // surfaces share an area, and nothing lies inside
		Unknown, // ask relate()
	};

	ConvexBody() = default;
	// Of a solid that is not convex, or has more than max_triangles, everything is unknown.
	explicit ConvexBody(const Solid &closed);

	// To anything with these corners; for `is_rectangle` they are those of one, in order. What it tells, relate() tells too.
	Relation relation_to(std::span<const glm::dvec3> corners, bool is_rectangle) const;

private:
	static constexpr size_t max_triangles = 64;
	struct Side {
		glm::dvec3 normal; // outwards
		double offset; // normal . p
	};
	struct Extent {
		double least, most;
	};

	static Extent heights(const Side &side, std::span<const glm::dvec3> points);
	Relation contact(size_t side, std::span<const glm::dvec3> rectangle) const;

	std::vector<Side> _sides;
	std::vector<glm::dvec3> _corners;
};

} // namespace pcg
