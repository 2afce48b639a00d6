#pragma once

#include <godot_cpp/variant/dictionary.hpp>

#include "core/figure/looks.h"

namespace pcg {

// Keys: name, gender, age_group, age, height, hair_color, skin_color, clothes_color; see PCGAgent.looks. Colours are linear.
godot::Dictionary to_godot(const Population &population, PersonId id, const Looks &looks);

} // namespace pcg
