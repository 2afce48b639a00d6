#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/cga/shape.h"

// What the words of comp() select (CGA reference: op_comp; section 4.1).
namespace pcg::cga {

enum class SelectorKind : uint8_t {
	Unknown,
	All,
	Front,
	Back,
	Left,
	Right,
	Top,
	Bottom,
	Side,
	Vertical,
	Aslant,
	Horizontal,
	Nutant,
	Border,
	Inside,
	Eave,
	Hip,
	Valley,
	Ridge,
	NotFront, // noStreetSide of old files
};

enum class SelectorSystem : uint8_t { Scope, Object, World, Street };

struct Selector {
	SelectorKind kind = SelectorKind::Unknown;
	SelectorSystem system = SelectorSystem::Scope;
};

// Unknown for words that select nothing.
Selector selector_of(std::string_view word);

// Unknown: not an edge, or none that roofs have names for.
inline bool is_roof_edge(SelectorKind kind) {
	return kind >= SelectorKind::Eave && kind <= SelectorKind::Ridge;
}

// A face, edge or vertex as selectors see it.
struct Component {
	glm::dvec3 normal{ 0.0 }; // direction that it faces, in scope coordinates, unit
	bool is_border = false;
	SelectorKind roof_edge = SelectorKind::Unknown; // Eave, Hip, Valley or Ridge
};

// All plain words and those of the systems, for rules that use them within expressions.
std::span<const std::string_view> selector_words();

// The side of its scope that it looks to: Front, Back, Left, Right, Top or Bottom.
SelectorKind scope_side(const Component &component, const Shape &shape);
bool matches(Selector selector, const Component &component, const Shape &shape, const Lot &lot);

} // namespace pcg::cga
