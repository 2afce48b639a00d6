#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include <glm/geometric.hpp>

#include "core/figure/figure.h"

using namespace pcg;

TEST_CASE("all six figures stand on the ground, are as tall as they say and look alike on both sides") {
	for (const bool is_woman : { false, true }) {
		for (const FigureAge age : { FigureAge::Child, FigureAge::Adult, FigureAge::Elder }) {
			const Figure figure = make_figure(is_woman, age);
			float low = 10.0f, high = -10.0f, sum_x = 0.0f;
			for (const FigureVertex &vertex : figure.vertices) {
				low = std::min(low, vertex.position.y);
				high = std::max(high, vertex.position.y);
				sum_x += vertex.position.x;
				CHECK(glm::length(vertex.normal) == doctest::Approx(1.0f).epsilon(1e-4));
			}
			CHECK(low == doctest::Approx(0.0f));
			CHECK(high == doctest::Approx(figure.height).epsilon(0.02));
			CHECK(sum_x == doctest::Approx(0.0f).epsilon(1e-3));
			CHECK(figure.vertices.size() < 720);
			CHECK(figure.knee_height < figure.hip_height);
			CHECK(figure.hip_height < figure.shoulder_height);
		}
	}
}

TEST_CASE("triangles of a figure face outwards: each agrees with its vertices' normals") {
	const Figure figure = make_figure(true, FigureAge::Adult);
	for (size_t i = 0; i < figure.indices.size(); i += 3) {
		const FigureVertex &a = figure.vertices[figure.indices[i]], &b = figure.vertices[figure.indices[i + 1]], &c = figure.vertices[figure.indices[i + 2]];
		const glm::vec3 normal = glm::cross(b.position - a.position, c.position - a.position);
		if (glm::length(normal) > 1e-7f) {
			CHECK(glm::dot(normal, a.normal + b.normal + c.normal) > 0.0f);
		}
	}
}

TEST_CASE("thighs and shins overlap at the knee, so that a bent leg shows no gap") {
	const Figure figure = make_figure(false, FigureAge::Adult);
	std::map<FigureLimb, float> lowest, highest;
	for (const FigureVertex &vertex : figure.vertices) {
		const auto [low, is_new] = lowest.try_emplace(vertex.limb, vertex.position.y);
		low->second = std::min(low->second, vertex.position.y);
		auto high = highest.try_emplace(vertex.limb, vertex.position.y).first;
		high->second = std::max(high->second, vertex.position.y);
	}
	CHECK(lowest[FigureLimb::LeftThigh] < figure.knee_height);
	CHECK(highest[FigureLimb::LeftShin] > figure.knee_height);
	CHECK(highest[FigureLimb::RightThigh] == doctest::Approx(figure.hip_height));
}
