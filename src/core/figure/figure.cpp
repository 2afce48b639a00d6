#include "core/figure/figure.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

constexpr int sides = 8;

// One cross-section of a limb: an ellipse around (x, y, z) with half widths across (x) and along the view (z).
struct Ring {
	glm::vec3 center;
	float half_width;
	float half_depth;
};

// Proportions of an adult of height 1, scaled afterwards; a child's head is larger and its legs are shorter.
struct Build {
	float height;
	float head; // factor of the adult's head
	float legs; // factor of the adult's leg length
	float shoulders; // half width
	float hips; // half width
	float stoop; // how far the chest leans forward, metres at height 1
	bool has_long_hair;
};

Build build_of(bool is_woman, FigureAge age) {
	switch (age) {
		case FigureAge::Child: return { is_woman ? 1.25f : 1.27f, 1.32f, 0.92f, 0.105f, 0.088f, 0.0f, is_woman };
		case FigureAge::Elder: return { is_woman ? 1.60f : 1.72f, 1.02f, 0.98f, is_woman ? 0.107f : 0.122f, is_woman ? 0.104f : 0.098f, 0.035f, false };
		case FigureAge::Adult: break;
	}
	return { is_woman ? 1.66f : 1.78f, 1.0f, 1.0f, is_woman ? 0.107f : 0.128f, is_woman ? 0.102f : 0.094f, 0.0f, is_woman };
}

class Sculptor {
public:
	explicit Sculptor(Figure &figure) : _figure(figure) {}

	// A closed tube through the rings, from below to above.
	void tube(const std::vector<Ring> &rings, FigureRegion region, FigureLimb limb) {
		const uint32_t first = uint32_t(_figure.vertices.size());
		for (size_t r = 0; r < rings.size(); ++r) {
			add_ring(rings, r, region, limb);
		}
		for (uint32_t r = 0; r + 1 < rings.size(); ++r) {
			for (uint32_t s = 0; s < sides; ++s) {
				const uint32_t a = first + r * sides + s, b = first + r * sides + (s + 1) % sides;
				quad(a, b, b + sides, a + sides);
			}
		}
		cap(rings.front(), first, glm::vec3(0, -1, 0), region, limb);
		cap(rings.back(), first + uint32_t(rings.size() - 1) * sides, glm::vec3(0, 1, 0), region, limb);
	}

private:
	void add_ring(const std::vector<Ring> &rings, size_t r, FigureRegion region, FigureLimb limb) {
		const Ring &ring = rings[r], &below = rings[r > 0 ? r - 1 : r], &above = rings[r + 1 < rings.size() ? r + 1 : r];
		// The steeper the tube widens upwards, the more its side looks down.
		const float rise = above.center.y - below.center.y;
		const float widening = rise > 1e-5f ? (above.half_width - below.half_width) / rise : 0.0f;
		for (int s = 0; s < sides; ++s) {
			const float angle = 6.2831853f * (float(s) + 0.5f) / float(sides);
			const glm::vec3 around(std::cos(angle), 0.0f, -std::sin(angle));
			const glm::vec3 position = ring.center + around * glm::vec3(ring.half_width, 0.0f, ring.half_depth);
			const glm::vec3 outward(around.x * ring.half_depth, 0.0f, around.z * ring.half_width);
			const glm::vec3 normal = glm::normalize(glm::normalize(outward) - glm::vec3(0, widening, 0));
			_figure.vertices.push_back({ position, normal, region, limb });
		}
	}

	void cap(const Ring &ring, uint32_t first, glm::vec3 normal, FigureRegion region, FigureLimb limb) {
		const uint32_t start = uint32_t(_figure.vertices.size());
		for (uint32_t s = 0; s < sides; ++s) {
			_figure.vertices.push_back({ _figure.vertices[first + s].position, normal, region, limb });
		}
		_figure.vertices.push_back({ ring.center, normal, region, limb });
		for (uint32_t s = 0; s < sides; ++s) {
			const uint32_t a = start + s, b = start + (s + 1) % sides;
			if (normal.y > 0) {
				triangle(a, b, start + sides);
			} else {
				triangle(b, a, start + sides);
			}
		}
	}

	void triangle(uint32_t a, uint32_t b, uint32_t c) { _figure.indices.insert(_figure.indices.end(), { a, b, c }); }
	void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
		triangle(a, b, c);
		triangle(a, c, d);
	}

	Figure &_figure;
};

void add_head(Sculptor &sculptor, const Build &build, float neck) {
	const float size = 0.068f * build.head, z = -build.stoop * 1.3f;
	const float chin = neck + 0.018f, middle = chin + size, top = chin + 2.05f * size;
	sculptor.tube({ { { 0, neck - 0.03f, z }, 0.03f, 0.03f }, { { 0, chin + 0.01f, z }, 0.028f, 0.03f } }, FigureRegion::Skin, FigureLimb::Body);
	sculptor.tube({ { { 0, chin, z - 0.01f }, size * 0.42f, size * 0.5f }, { { 0, chin + size * 0.45f, z }, size * 0.68f, size * 0.8f },
						  { { 0, middle + size * 0.25f, z }, size * 0.76f, size * 0.92f }, { { 0, top - size * 0.3f, z }, size * 0.66f, size * 0.8f } },
			FigureRegion::Skin, FigureLimb::Body);
	// Hair: a cap that sits a little back, long hair falls to the shoulders behind.
	const float back = size * 0.22f;
	sculptor.tube({ { { 0, middle + size * 0.1f, z + back * 1.6f }, size * 0.8f, size * 0.72f }, { { 0, middle + size * 0.5f, z + back }, size * 0.84f, size * 0.86f },
						  { { 0, top - size * 0.25f, z + back * 0.5f }, size * 0.74f, size * 0.86f }, { { 0, top, z + back * 0.4f }, size * 0.36f, size * 0.42f } },
			FigureRegion::Hair, FigureLimb::Body);
	if (build.has_long_hair) {
		sculptor.tube({ { { 0, neck - 0.035f, z + size * 0.85f }, size * 0.55f, size * 0.25f }, { { 0, middle + size * 0.2f, z + size * 0.62f }, size * 0.78f, size * 0.45f } },
				FigureRegion::Hair, FigureLimb::Body);
	}
}

void add_trunk(Sculptor &sculptor, const Build &build, float hip, float shoulder) {
	const float waist = hip + (shoulder - hip) * 0.42f, chest = hip + (shoulder - hip) * 0.8f, lean = -build.stoop;
	sculptor.tube({ { { 0, hip - 0.045f, 0 }, build.hips * 0.88f, 0.062f }, { { 0, hip + 0.02f, 0 }, build.hips, 0.068f }, { { 0, hip + 0.06f, 0 }, build.hips * 0.95f, 0.064f } },
			FigureRegion::Trousers, FigureLimb::Body);
	sculptor.tube({ { { 0, hip + 0.03f, 0 }, build.hips * 1.03f, 0.07f }, { { 0, waist, lean * 0.4f }, build.hips * 0.84f, 0.06f },
						  { { 0, chest, lean * 0.9f }, build.shoulders * 0.92f, 0.072f }, { { 0, shoulder, lean }, build.shoulders * 0.86f, 0.058f },
						  { { 0, shoulder + 0.022f, lean * 1.2f }, 0.04f, 0.04f } },
			FigureRegion::Top, FigureLimb::Body);
}

void add_leg(Sculptor &sculptor, const Build &build, float side, float hip, float knee) {
	const FigureLimb thigh = side < 0 ? FigureLimb::LeftThigh : FigureLimb::RightThigh;
	const FigureLimb shin = side < 0 ? FigureLimb::LeftShin : FigureLimb::RightShin;
	const float x = side * build.hips * 0.52f;
	sculptor.tube({ { { x, knee - 0.012f, 0 }, 0.034f, 0.038f }, { { x, knee + 0.03f, 0 }, 0.037f, 0.042f }, { { x, hip, 0 }, 0.049f, 0.056f } }, FigureRegion::Trousers, thigh);
	sculptor.tube({ { { x, 0.045f, 0.008f }, 0.025f, 0.028f }, { { x, knee * 0.62f, 0.006f }, 0.033f, 0.037f }, { { x, knee + 0.015f, 0 }, 0.033f, 0.037f } },
			FigureRegion::Trousers, shin);
	sculptor.tube({ { { x, 0.0f, -0.026f }, 0.031f, 0.072f }, { { x, 0.025f, -0.022f }, 0.031f, 0.068f }, { { x, 0.05f, 0.004f }, 0.028f, 0.034f } }, FigureRegion::Shoes, shin);
}

void add_arm(Sculptor &sculptor, const Build &build, float side, float hip, float shoulder) {
	const FigureLimb limb = side < 0 ? FigureLimb::LeftArm : FigureLimb::RightArm;
	const float x = side * (build.shoulders * 0.86f + 0.026f), lean = -build.stoop, elbow = hip + (shoulder - hip) * 0.42f;
	sculptor.tube({ { { x * 1.1f, hip + 0.02f, lean - 0.012f }, 0.02f, 0.022f }, { { x * 1.08f, elbow, lean }, 0.024f, 0.027f }, { { x, shoulder - 0.02f, lean }, 0.031f, 0.034f },
						  { { x * 0.92f, shoulder + 0.008f, lean }, 0.02f, 0.022f } },
			FigureRegion::Top, limb);
	sculptor.tube({ { { x * 1.11f, hip - 0.055f, lean - 0.02f }, 0.012f, 0.018f }, { { x * 1.1f, hip - 0.02f, lean - 0.018f }, 0.02f, 0.026f }, { { x * 1.1f, hip + 0.03f, lean - 0.012f }, 0.017f, 0.019f } },
			FigureRegion::Skin, limb);
}

} // namespace

Figure make_figure(bool is_woman, FigureAge age) {
	Figure figure;
	const Build build = build_of(is_woman, age);
	// Fractions of the height; Drillis and Contini's body segment lengths (1966), hip 0.53 and knee 0.285.
	const float hip = 0.53f * build.legs, knee = 0.285f * build.legs;
	const float neck = 1.0f - 0.14f * build.head - 0.018f, shoulder = neck - 0.035f;
	Sculptor sculptor(figure);
	add_head(sculptor, build, neck);
	add_trunk(sculptor, build, hip, shoulder);
	for (const float side : { -1.0f, 1.0f }) {
		add_leg(sculptor, build, side, hip, knee);
		add_arm(sculptor, build, side, hip, shoulder);
	}
	for (FigureVertex &vertex : figure.vertices) {
		vertex.position *= build.height;
	}
	figure.height = build.height;
	figure.hip_height = hip * build.height;
	figure.knee_height = knee * build.height;
	figure.shoulder_height = shoulder * build.height;
	return figure;
}

} // namespace pcg
