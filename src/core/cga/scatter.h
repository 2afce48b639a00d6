#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/cga/geometry.h"

// Random places on and in a geometry (CGA reference: op_scatter).
namespace pcg::cga {

struct ScatterPoint {
	glm::dvec3 position{ 0.0 };
	glm::dvec3 normal{ 0.0, 1.0, 0.0 }; // of the surface there
};

// A normal distribution about a point, by axis. Drawn again where it misses, a limited number of times.
struct Bell {
	glm::dvec3 mean{ 0.0 }, deviation{ 0.0 };
};

class Scatter {
public:
	explicit Scatter(const Geometry &geometry);

	bool has_surface() const { return !_triangles.empty(); }
	// Every part of the surface is as likely as its area.
	ScatterPoint on_surface(Random &random) const;
	// The point of the surface next to one of the distribution.
	ScatterPoint on_surface(Random &random, const Bell &bell) const;
	// Of a closed surface; on the surface if none is found inside.
	ScatterPoint in_volume(Random &random) const;
	ScatterPoint in_volume(Random &random, const Bell &bell) const;

	// In the box from the origin to `size`, which may be negative.
	static glm::dvec3 in_box(Random &random, glm::dvec3 size);
	static glm::dvec3 in_box(Random &random, glm::dvec3 size, const Bell &bell);

private:
	struct Triangle {
		glm::dvec3 a, b, c;
		glm::dvec3 normal;
		double area_before; // of all triangles before this one
	};
	bool is_inside(glm::dvec3 point) const;
	ScatterPoint nearest(glm::dvec3 point, bool &is_above) const;

	std::vector<Triangle> _triangles;
	double _area = 0.0;
	glm::dvec3 _low{ 0.0 }, _high{ 0.0 };
};

} // namespace pcg::cga
