#include "core/semantics/city_query.h"

#include <cmath>

namespace pcg {

namespace {

double cross(double ax, double az, double bx, double bz) { return ax * bz - az * bx; }

glm::vec3 nearest_on_segment(glm::vec3 a, glm::vec3 b, glm::vec3 point) {
	const double dx = double(b.x) - a.x, dz = double(b.z) - a.z;
	const double length_squared = dx * dx + dz * dz;
	double t = length_squared > 0.0 ? ((double(point.x) - a.x) * dx + (double(point.z) - a.z) * dz) / length_squared : 0.0;
	t = t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
	return a + (b - a) * float(t);
}

double squared_distance(glm::vec3 a, glm::vec3 b) {
	const double dx = double(a.x) - b.x, dz = double(a.z) - b.z;
	return dx * dx + dz * dz;
}

// Sum of the cross products of the fan around the first corner: twice the area, its sign the winding.
double doubled_area(const std::vector<glm::vec3> &polygon) {
	double sum = 0.0;
	for (size_t i = 1; i + 1 < polygon.size(); ++i) {
		const glm::vec3 a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
		sum += cross(a.x, a.z, b.x, b.z);
	}
	return sum;
}

} // namespace

bool contains(const Zone &zone, glm::vec3 point) {
	const std::vector<glm::vec3> &polygon = zone.polygon;
	bool is_inside = false;
	for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
		const glm::vec3 a = polygon[i], b = polygon[j];
		if (squared_distance(nearest_on_segment(a, b, point), point) < 1e-12) {
			return polygon.size() >= 3;
		}
		if ((a.z > point.z) != (b.z > point.z) &&
				point.x < (double(b.x) - a.x) * (double(point.z) - a.z) / (double(b.z) - a.z) + a.x) {
			is_inside = !is_inside;
		}
	}
	return is_inside;
}

glm::vec3 nearest_point(const Zone &zone, glm::vec3 point) {
	const std::vector<glm::vec3> &polygon = zone.polygon;
	if (polygon.empty() || contains(zone, point)) {
		return point;
	}
	glm::vec3 best = polygon[0];
	for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
		const glm::vec3 candidate = nearest_on_segment(polygon[j], polygon[i], point);
		if (squared_distance(candidate, point) < squared_distance(best, point)) {
			best = candidate;
		}
	}
	return best;
}

glm::vec3 centroid(const Zone &zone) {
	const std::vector<glm::vec3> &polygon = zone.polygon;
	glm::vec3 mean{ 0.0f };
	for (const glm::vec3 &corner : polygon) {
		mean += corner / float(polygon.size());
	}
	const double doubled = doubled_area(polygon);
	if (std::abs(doubled) < 1e-9) {
		return mean;
	}
	double x = 0.0, z = 0.0;
	for (size_t i = 1; i + 1 < polygon.size(); ++i) {
		const glm::vec3 a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
		const double weight = cross(a.x, a.z, b.x, b.z) / (3.0 * doubled);
		x += (double(a.x) + b.x) * weight;
		z += (double(a.z) + b.z) * weight;
	}
	return { float(polygon[0].x + x), mean.y, float(polygon[0].z + z) };
}

double area(const Zone &zone) { return std::abs(doubled_area(zone.polygon)) / 2.0; }

} // namespace pcg
