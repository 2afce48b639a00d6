#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/file_ids.h"
#include "core/semantics/city_model.h"

// A city's meaning as a JSON file, without geometry:
//   {"buildings": [{"id": 1, "entrances": [{"type": "house", "position": [x, y, z], "facing": [x, y, z], "capacity": 4}]}],
//    "zones":     [{"id": 1, "type": "park", "polygon": [[x, y, z], ..], "height": 3}],
//    "objects":   [{"id": 1, "type": "bench", "position": [x, y, z], "places": 2}]}
// Metres, y up, -z north. `facing`, `capacity`, `height` and the three lists may be missing. `places` is a count or a list of
// {"position": [x, y, z], "facing": [x, y, z]}. Ids are whole numbers, each once in its list, any size up to 64 bits; they become dense in the
// order of the file. Rules see the numbers of the file, unless a list has one below 0 or above 2^53: that list they count from 0.
namespace pcg {

struct CityFile {
	CityModel city;
	FileIds building_ids, zone_ids, object_ids;
};

// Nothing if there was an error. `file` is the name shown in diagnostics, which say where in the JSON ("buildings[3].entrances[0].type").
std::optional<CityFile> parse_city_json(std::string_view text, const std::string &file, Diagnostics &diagnostics);
std::optional<CityFile> load_city_json(const std::string &path, Diagnostics &diagnostics);

// Removed records are left out; the others keep their dense ids as numbers.
std::string city_to_json(const CityModel &city);

} // namespace pcg
