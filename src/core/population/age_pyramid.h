#pragma once

#include "core/base/random.h"
#include "core/population/population.h"

// How old people are. Source: United States, age structure by sex, 2020 estimate (The World Factbook, public domain): 0-14, 15-24,
// 25-54, 55-64 and 65 or over. Own processing: spread evenly over the years of each group; from 65 on declining in a straight line to
// nobody at 100.
namespace pcg {

constexpr int oldest_age = 99;

// An age in whole years, first <= age <= last, as frequent as in the pyramid. Bounds are brought into 0 .. oldest_age; `first` if last < first.
int draw_age(Random &random, Gender gender, int first, int last);
// Both genders taken together: how many of 1000 people are of this age.
double share_per_mille(int age);

} // namespace pcg
