#pragma once

#include "core/city/city.h"

// The ground of a layout, made by code so that a city without any rules still shows where things lie.
namespace pcg {

// Flat, upwards. Lots lie a little lower than the ground that their own rules may make, zebra stripes a little higher than their street.
GroundModel make_ground(const Layout &layout);

} // namespace pcg
