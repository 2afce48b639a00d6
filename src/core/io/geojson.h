#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/city/footprint_layout.h"

// Footprints of buildings from GeoJSON (RFC 7946): a FeatureCollection or one Feature, of whose geometries each Polygon and each part of a
// MultiPolygon is one footprint, with its holes. Others, and features without one, are left out with a warning. Of `properties`:
// `height` in metres, a number or a text that begins with one ("12.5 m"), else `building:levels` at 3 m each; `use`, else `building` unless it is
// "yes", as the type of lot.
namespace pcg {

enum class MapUnits {
	Guess, // degrees if all coordinates could be longitude and latitude, and no outline is a degree wide; else metres
	Degrees, // WGS 84, as the RFC wants it; projected to metres around the middle of the map
	Metres, // x east, y north
};

// Nothing if there was an error; each says where in the file it is, with line, column and the feature's number, from 0.
std::optional<std::vector<Footprint>> parse_geojson(std::string_view text, const std::string &file, Diagnostics &diagnostics,
		MapUnits units = MapUnits::Guess);

} // namespace pcg
