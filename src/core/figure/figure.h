#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

// The default body of a person: a low-poly figure made by code, so that no foreign asset is needed. It stands on y = 0 and looks along -z, as
// Godot's nodes do. Walking and sitting are done by the vertex shader from the limb of each vertex (addons/pcg/figure/figure.gdshader).
namespace pcg {

enum class FigureAge : uint8_t { Child, Adult, Elder };

// What colours a vertex: skin, hair and clothes differ by person, the rest follows.
enum class FigureRegion : uint8_t { Skin, Hair, Top, Trousers, Shoes };

// What moves a vertex. Legs have a knee; lower legs turn about the knee first, then with the upper leg about the hip.
enum class FigureLimb : uint8_t { Body, LeftThigh, LeftShin, RightThigh, RightShin, LeftArm, RightArm };

struct FigureVertex {
	glm::vec3 position{ 0.0f }; // metres
	glm::vec3 normal{ 0.0f, 1.0f, 0.0f }; // unit
	FigureRegion region = FigureRegion::Skin;
	FigureLimb limb = FigureLimb::Body;
};

struct Figure {
	std::vector<FigureVertex> vertices;
	std::vector<uint32_t> indices; // triangles, counter-clockwise seen from outside
	float height = 0.0f; // metres, about 1.25 for a child to 1.78 for a man
	float hip_height = 0.0f; // where thighs turn
	float knee_height = 0.0f;
	float shoulder_height = 0.0f;
};

// One of the six base figures: woman or man, child, adult or elder. Under 720 vertices.
Figure make_figure(bool is_woman, FigureAge age);

} // namespace pcg
