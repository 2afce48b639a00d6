#pragma once

#include <string_view>

// A plain house in the middle of its lot, for benches that walk from door to door.
inline constexpr std::string_view house_rules = R"(
@StartRule
Lot --> split(z) { 3: NIL | ~1: Middle | 3: NIL }
Middle --> split(x) { 2: NIL | ~1: House | 2: NIL }
House --> extrude(5) comp(f) { front: Facade | all: Wall. }
Facade --> [ t('0.5, 0, 0) entrance("house", 4) ] Wall.
)";
