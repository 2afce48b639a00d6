#include "core/cga/scope.h"

#include <algorithm>
#include <cmath>

namespace pcg::cga {

namespace {

constexpr double degree = 0.017453292519943295;

// Exact for multiples of 90 degrees: a wall turned four times is the same wall.
double sine(double degrees) {
	const double turned = std::abs(degrees) < 360.0 ? degrees : std::fmod(degrees, 360.0);
	if (turned == 0.0 || std::abs(turned) == 180.0) {
		return 0.0;
	}
	if (turned == 90.0 || turned == -270.0) {
		return 1.0;
	}
	return turned == -90.0 || turned == 270.0 ? -1.0 : std::sin(turned * degree);
}

double cosine(double degrees) {
	return sine(degrees + 90.0);
}

} // namespace

glm::dmat3 rotation_from_euler(glm::dvec3 degrees) {
	const double sa = sine(degrees.x), ca = cosine(degrees.x);
	const double sb = sine(degrees.y), cb = cosine(degrees.y);
	const double sg = sine(degrees.z), cg = cosine(degrees.z);
	return glm::dmat3(glm::dvec3(cb * cg, cb * sg, -sb), //
			glm::dvec3(sa * sb * cg - ca * sg, ca * cg + sa * sb * sg, sa * cb),
			glm::dvec3(sa * sg + ca * sb * cg, ca * sb * sg - sa * cg, ca * cb));
}

glm::dvec3 euler_from_rotation(const glm::dmat3 &turn) {
	const glm::dmat3 rotation = turn + glm::dmat3(0.0); // -0 becomes 0: a rule would print it, and half a turn would be -180
	const double r20 = rotation[0][2], r21 = rotation[1][2], r22 = rotation[2][2];
	const double r00 = rotation[0][0], r10 = rotation[0][1];
	const double about_y = std::asin(std::clamp(0.0 - r20, -1.0, 1.0));
	if (std::abs(r20) > 1.0 - 1e-12) { // y at 90 degrees: x and z turn about the same line, z is 0
		return glm::dvec3(std::atan2(r20 < 0.0 ? rotation[1][0] : 0.0 - rotation[1][0], rotation[1][1]), about_y, 0.0) / degree;
	}
	return glm::dvec3(std::atan2(r21, r22), about_y, std::atan2(r10, r00)) / degree;
}

} // namespace pcg::cga
