#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/city/city.h"

// What a host keeps of a city that it shows by its own means: everything but models, surfaces and meaning.
namespace pcg {

// Layout, free ground, and which records of the model came with each lot.
std::string city_bytes(const City &city);

// Of the seed and the lots: of what a city is generated from, whatever is edited afterwards. Never 0.
uint64_t fingerprint_of(const Layout &layout);

// Nothing, after one error, if the bytes are damaged or of another version. Lots have no models, and the model has its origin and no records.
std::optional<City> city_from_bytes(std::string_view bytes, Diagnostics &diagnostics);

} // namespace pcg
