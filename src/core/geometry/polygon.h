#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/small_vector.h"

// Plain polygons in space: a loop of points, counter-clockwise seen from the side that it looks to.
namespace pcg {

// In a plane; most have few corners and no hole.
using Loop2 = SmallVector<glm::dvec2, 6>;
using Loops2 = SmallVector<Loop2, 1>; // of one polygon: the outline counter-clockwise, then holes clockwise
using Polygons2 = SmallVector<Loops2, 1>;

// Twice the area, in the direction of the normal (Newell's method): sound for concave and slightly warped loops.
glm::dvec3 area_vector(std::span<const glm::dvec3> loop);
// Unit; `fallback` for loops without area.
glm::dvec3 loop_normal(std::span<const glm::dvec3> loop, glm::dvec3 fallback = glm::dvec3(0.0, 1.0, 0.0));
// Twice the area; positive if counter-clockwise.
double signed_area(std::span<const glm::dvec2> loop);
// Sine of a thousandth of a degree: rule files see corners as straight up to it, because the places of files are rounded.
constexpr double straight_sine = 1.7453e-5;
// Inner corners up to the sine `straight` count as straight.
bool is_convex(std::span<const glm::dvec2> loop, double straight = 1e-12);
bool contains(std::span<const glm::dvec2> loop, glm::dvec2 point);

// Drops the coordinate along which `normal` is longest, so that loops around `normal` stay counter-clockwise.
glm::dvec2 flatten(glm::dvec3 point, glm::dvec3 normal);
// Columns x, y, z with y = `up` (unit) and x = `direction` made perpendicular to it; any perpendicular if that vanishes.
glm::dmat3 axes_from_y(glm::dvec3 up, glm::dvec3 direction);
// The same with z = `normal`.
glm::dmat3 axes_from_z(glm::dvec3 normal, glm::dvec3 direction);

// True if two edges that are not neighbours cross or touch. Cost grows with the square of the points.
bool is_self_intersecting(std::span<const glm::dvec2> loop);

} // namespace pcg
