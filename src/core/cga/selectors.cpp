#include "core/cga/selectors.h"

#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace pcg::cga {

namespace {

using enum SelectorKind;

constexpr std::array<std::pair<std::string_view, SelectorKind>, 19> plain_words = { {
		{ "all", All },
		{ "front", Front },
		{ "back", Back },
		{ "left", Left },
		{ "right", Right },
		{ "top", Top },
		{ "bottom", Bottom },
		{ "side", Side },
		{ "vertical", Vertical },
		{ "aslant", Aslant },
		{ "horizontal", Horizontal },
		{ "nutant", Nutant },
		{ "border", Border },
		{ "inside", Inside },
		{ "surface", All }, // of geometry.area
		{ "eave", Eave },
		{ "hip", Hip },
		{ "valley", Valley },
		{ "ridge", Ridge },
} };

constexpr std::array<std::pair<std::string_view, SelectorKind>, 7> world_words = { {
		{ "south", Front },
		{ "north", Back },
		{ "west", Left },
		{ "east", Right },
		{ "up", Top },
		{ "down", Bottom },
		{ "side", Side },
} };

template <size_t N> SelectorKind find(const std::array<std::pair<std::string_view, SelectorKind>, N> &words, std::string_view word) {
	for (const auto &[name, kind] : words) {
		if (name == word) {
			return kind;
		}
	}
	return Unknown;
}

// Which side of its box a direction looks to: the axis with the largest component; z before x before y where they are equal.
SelectorKind side_of(glm::dvec3 direction) {
	constexpr double margin = 1e-9;
	const glm::dvec3 size = glm::abs(direction);
	if (size.z >= size.x - margin && size.z >= size.y - margin) {
		return direction.z > 0.0 ? Front : Back;
	}
	if (size.x >= size.y - margin) {
		return direction.x > 0.0 ? Right : Left;
	}
	return direction.y > 0.0 ? Top : Bottom;
}

bool matches_slope(SelectorKind kind, double sine) {
	const double degrees = std::asin(glm::clamp(sine, -1.0, 1.0)) * 57.29577951308232;
	switch (kind) {
		case Vertical:
			return degrees > -11.25 && degrees <= 11.25;
		case Aslant:
			return degrees > 11.25 && degrees <= 78.75;
		case Nutant:
			return degrees > -78.75 && degrees <= -11.25;
		default: // Horizontal, and Side, which is everything else
			return (degrees > 78.75 || degrees <= -78.75) == (kind == Horizontal);
	}
}

// A negative size turns the scope's sides around.
glm::dvec3 in_scope(glm::dvec3 normal, const Shape &shape) {
	const bool is_turned = shape.size.x < 0.0 || shape.size.y < 0.0 || shape.size.z < 0.0;
	return is_turned ? glm::mix(normal, -normal, glm::lessThan(shape.size, glm::dvec3(0.0))) : normal;
}

glm::dvec3 in_system(glm::dvec3 normal, SelectorSystem system, const Shape &shape, const Lot &lot) {
	if (system == SelectorSystem::Scope) {
		return in_scope(normal, shape);
	}
	const glm::dvec3 direction = shape.frame().axes * normal;
	switch (system) {
		case SelectorSystem::Object:
			return glm::transpose(lot.object_axes) * direction;
		case SelectorSystem::Street:
			return glm::transpose(lot.street_axes) * direction;
		default:
			return direction;
	}
}

} // namespace

Selector selector_of(std::string_view word) {
	if (word == "streetSide") { // of old files
		return { Front, SelectorSystem::Street };
	}
	if (word == "noStreetSide") {
		return { NotFront, SelectorSystem::Street };
	}
	const size_t dot = word.find('.');
	if (dot == std::string_view::npos) {
		return { find(plain_words, word), SelectorSystem::Scope };
	}
	const std::string_view system = word.substr(0, dot), rest = word.substr(dot + 1);
	if (system == "world") {
		return { find(world_words, rest), SelectorSystem::World };
	}
	const SelectorKind kind = find(plain_words, rest);
	const bool is_side = kind >= Front && kind <= Side;
	if (is_side && (system == "object" || system == "street")) {
		return { kind, system == "object" ? SelectorSystem::Object : SelectorSystem::Street };
	}
	return {};
}

std::span<const std::string_view> selector_words() {
	static constexpr std::string_view words[] = { "all", "front", "back", "left", "right", "top", "bottom", "side", "vertical", "aslant", "horizontal", "nutant",
		"border", "inside", "eave", "hip", "valley", "ridge", "streetSide", "noStreetSide", "object.front", "object.back", "object.left", "object.right",
		"object.top", "object.bottom", "object.side", "street.front", "street.back", "street.left", "street.right", "street.side", "world.south",
		"world.north", "world.west", "world.east", "world.up", "world.down", "world.side" };
	return words;
}

SelectorKind scope_side(const Component &component, const Shape &shape) {
	return side_of(in_scope(component.normal, shape));
}

bool matches(Selector selector, const Component &component, const Shape &shape, const Lot &lot) {
	switch (selector.kind) {
		case Unknown:
			return false;
		case All:
			return true;
		case Border:
			return component.is_border;
		case Inside:
			return !component.is_border;
		case Eave:
		case Hip:
		case Valley:
		case Ridge:
			return component.roof_edge == selector.kind;
		case NotFront:
			return side_of(in_system(component.normal, selector.system, shape, lot)) != Front;
		case Vertical:
		case Aslant:
		case Nutant:
		case Horizontal:
			return matches_slope(selector.kind, in_system(component.normal, selector.system, shape, lot).y);
		case Side:
			if (selector.system == SelectorSystem::Scope) {
				return matches_slope(Side, in_system(component.normal, selector.system, shape, lot).y);
			} else {
				const SelectorKind side = side_of(in_system(component.normal, selector.system, shape, lot));
				return selector.system == SelectorSystem::Street ? side == Left || side == Right : side != Top && side != Bottom;
			}
		default:
			return side_of(in_system(component.normal, selector.system, shape, lot)) == selector.kind;
	}
}

} // namespace pcg::cga
