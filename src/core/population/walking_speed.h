#pragma once

#include "core/base/random.h"
#include "core/population/population.h"

// How fast people walk. Adults from 20 on: mean speeds by decade and gender of the meta-analysis R. W. Bohannon, A. W. Andrews: Normal
// walking speed, Physiotherapy 97 (2011), 182-189. Children of 3 to 7: D. H. Sutherland et al.: The Development of Mature Walking (1988),
// table of velocities by age; between 7 and 20 interpolated. Children under 3 are pushed or carried at an easy pace.
namespace pcg {

// Nobody drawn is slower: the pace at which a family can be sure to keep together.
constexpr float slowest_walking_speed = 0.75f;

// Metres per second, the mean of people like this.
float mean_walking_speed(Gender gender, float age);
// One person's: the mean and a deviation of up to a tenth of it.
float draw_walking_speed(Random &random, Gender gender, float age);

} // namespace pcg
