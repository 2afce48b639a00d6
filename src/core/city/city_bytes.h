#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/city/city.h"

// What a host keeps of a city that it shows by its own means: everything but models, surfaces and meaning.
namespace pcg {

// Layout, free ground, and which records of the model came with each lot.
std::string city_bytes(const City &city);

// Nothing, after one error, if the bytes are damaged or of another version. Lots have no models, and the model has no records.
std::optional<City> city_from_bytes(std::string_view bytes, Diagnostics &diagnostics);

} // namespace pcg
