#include "core/io/city_json.h"

#include <charconv>

#include <glm/geometric.hpp>

#include "core/io/atomic_file.h"
#include "core/io/json_reader.h"

namespace pcg {

namespace {

constexpr int64_t max_capacity = 1'000'000;
constexpr int64_t max_places = 10'000;
// Places that the file only counts stand side by side along x, this far apart: a seat's width.
constexpr float place_spacing = 0.6f;

glm::vec3 facing_or(const JsonValue &owner, glm::vec3 otherwise) {
	const std::optional<JsonValue> member = owner.member("facing");
	const std::optional<glm::vec3> facing = member ? member->point() : std::nullopt;
	if (!facing) {
		return otherwise;
	}
	if (glm::length(*facing) < 1e-6f) {
		member->error("expected a direction, not zero");
		return otherwise;
	}
	return glm::normalize(*facing);
}

void take_id(const JsonValue &owner, FileIds &ids) {
	const std::optional<JsonValue> member = owner.required("id");
	const std::optional<int64_t> number = member ? member->whole_number(INT64_MIN, INT64_MAX) : std::nullopt;
	if (number && !ids.add(*number)) {
		member->error("the id " + std::to_string(*number) + " occurs twice", "give each its own number");
	}
}

// Invalid after an error.
TypeId take_type(const JsonValue &owner, TypeTable &types) {
	const std::optional<JsonValue> member = owner.required("type");
	const std::optional<std::string> name = member ? member->text() : std::nullopt;
	return name ? types.add(*name) : TypeId::Invalid;
}

glm::vec3 take_position(const JsonValue &owner) {
	const std::optional<JsonValue> member = owner.required("position");
	return member ? member->point().value_or(glm::vec3(0.0f)) : glm::vec3(0.0f);
}

void read_entrance(const JsonValue &value, BuildingId building, CityModel &city) {
	if (!value.is_object()) {
		return;
	}
	value.allow_only({ "type", "position", "facing", "capacity" });
	Entrance entrance;
	entrance.building = building;
	entrance.type = take_type(value, city.types);
	entrance.position = take_position(value);
	entrance.facing = facing_or(value, entrance.facing);
	if (const std::optional<JsonValue> capacity = value.member("capacity")) {
		entrance.capacity = uint32_t(capacity->whole_number(0, max_capacity).value_or(0));
	}
	city.add_entrance(entrance);
}

void read_building(const JsonValue &value, CityFile &file) {
	if (!value.is_object()) {
		return;
	}
	value.allow_only({ "id", "entrances" });
	take_id(value, file.building_ids);
	const BuildingId building = file.city.add_building();
	const std::optional<JsonValue> member = value.required("entrances");
	const auto entrances = member ? member->elements() : std::nullopt;
	if (entrances && entrances->empty()) {
		member->warning("no-entrance", "a building without entrances cannot be entered", "give it an entrance or leave it out");
	}
	for (size_t i = 0; entrances && i < entrances->size(); ++i) {
		read_entrance((*entrances)[i], building, file.city);
	}
}

void read_zone(const JsonValue &value, CityFile &file) {
	if (!value.is_object()) {
		return;
	}
	value.allow_only({ "id", "type", "polygon", "height" });
	take_id(value, file.zone_ids);
	Zone zone;
	zone.type = take_type(value, file.city.types);
	const std::optional<JsonValue> polygon = value.required("polygon");
	const auto corners = polygon ? polygon->elements() : std::nullopt;
	if (corners && corners->size() < 3) {
		polygon->error("expected at least three corners");
	}
	for (size_t i = 0; corners && i < corners->size(); ++i) {
		zone.polygon.push_back((*corners)[i].point().value_or(glm::vec3(0.0f)));
	}
	if (const std::optional<JsonValue> height = value.member("height")) {
		zone.height = float(height->number(0.0, 1e5).value_or(0.0));
	}
	file.city.add_zone(std::move(zone));
}

std::vector<Place> counted_places(glm::vec3 position, size_t count) {
	std::vector<Place> places(count);
	for (size_t i = 0; i < count; ++i) {
		places[i].position = position;
		places[i].position.x += place_spacing * (float(i) - float(count - 1) / 2.0f);
	}
	return places;
}

std::vector<Place> read_places(const JsonValue &value, glm::vec3 position) {
	if (value.is_number()) {
		return counted_places(position, size_t(value.whole_number(1, max_places).value_or(1)));
	}
	std::vector<Place> places;
	const auto elements = value.elements();
	for (size_t i = 0; elements && i < elements->size(); ++i) {
		const JsonValue &element = (*elements)[i];
		if (element.is_object()) {
			element.allow_only({ "position", "facing" });
			places.push_back({ take_position(element), facing_or(element, { 0.0f, 0.0f, 1.0f }) });
		}
	}
	return places;
}

void read_object(const JsonValue &value, CityFile &file) {
	if (!value.is_object()) {
		return;
	}
	value.allow_only({ "id", "type", "position", "places" });
	take_id(value, file.object_ids);
	CityObject object;
	object.type = take_type(value, file.city.types);
	object.position = take_position(value);
	const std::optional<JsonValue> places = value.member("places");
	object.places = places ? read_places(*places, object.position) : counted_places(object.position, 1);
	file.city.add_object(std::move(object));
}

void read_list(const JsonValue &document, std::string_view key, CityFile &file, void (*read)(const JsonValue &, CityFile &)) {
	const std::optional<JsonValue> member = document.member(key);
	const auto elements = member ? member->elements() : std::nullopt;
	for (size_t i = 0; elements && i < elements->size(); ++i) {
		read((*elements)[i], file);
	}
}

// The double with the fewest digits that reads back as the same float: 0.1, not 0.10000000149011612.
double shortest(float value) {
	char digits[32];
	const std::to_chars_result end = std::to_chars(digits, digits + sizeof(digits), value);
	double result = 0.0;
	std::from_chars(digits, end.ptr, result);
	return result;
}

nlohmann::ordered_json to_json(glm::vec3 point) { return { shortest(point.x), shortest(point.y), shortest(point.z) }; }

bool are_as_counted(const CityObject &object) {
	const std::vector<Place> counted = counted_places(object.position, object.places.size());
	for (size_t i = 0; i < counted.size(); ++i) {
		if (counted[i].position != object.places[i].position || counted[i].facing != object.places[i].facing) {
			return false;
		}
	}
	return true;
}

nlohmann::ordered_json buildings_to_json(const CityModel &city) {
	nlohmann::ordered_json list = nlohmann::ordered_json::array();
	for (size_t i = 0; i < city.buildings().size(); ++i) {
		if (city.buildings()[i].is_removed) {
			continue;
		}
		nlohmann::ordered_json entrances = nlohmann::ordered_json::array();
		for (EntranceId id : city.buildings()[i].entrances) {
			const Entrance &entrance = city.entrance(id);
			entrances.push_back({ { "type", city.types.name(entrance.type) }, { "position", to_json(entrance.position) },
					{ "facing", to_json(entrance.facing) }, { "capacity", entrance.capacity } });
		}
		list.push_back({ { "id", i }, { "entrances", std::move(entrances) } });
	}
	return list;
}

nlohmann::ordered_json zones_to_json(const CityModel &city) {
	nlohmann::ordered_json list = nlohmann::ordered_json::array();
	for (size_t i = 0; i < city.zones().size(); ++i) {
		const Zone &zone = city.zones()[i];
		if (zone.is_removed) {
			continue;
		}
		nlohmann::ordered_json polygon = nlohmann::ordered_json::array();
		for (const glm::vec3 &corner : zone.polygon) {
			polygon.push_back(to_json(corner));
		}
		list.push_back({ { "id", i }, { "type", city.types.name(zone.type) }, { "polygon", std::move(polygon) },
				{ "height", shortest(zone.height) } });
	}
	return list;
}

nlohmann::ordered_json places_to_json(const CityObject &object) {
	if (are_as_counted(object)) {
		return object.places.size();
	}
	nlohmann::ordered_json places = nlohmann::ordered_json::array();
	for (const Place &place : object.places) {
		places.push_back({ { "position", to_json(place.position) }, { "facing", to_json(place.facing) } });
	}
	return places;
}

nlohmann::ordered_json objects_to_json(const CityModel &city) {
	nlohmann::ordered_json list = nlohmann::ordered_json::array();
	for (size_t i = 0; i < city.objects().size(); ++i) {
		const CityObject &object = city.objects()[i];
		if (!object.is_removed) {
			list.push_back({ { "id", i }, { "type", city.types.name(object.type) }, { "position", to_json(object.position) },
					{ "places", places_to_json(object) } });
		}
	}
	return list;
}

} // namespace

std::optional<CityFile> parse_city_json(std::string_view text, const std::string &file, Diagnostics &diagnostics) {
	const size_t errors_before = diagnostics.error_count();
	const std::optional<nlohmann::json> document = parse_json(text, file, diagnostics);
	if (!document) {
		return std::nullopt;
	}
	const JsonValue root(*document, "", file, text, diagnostics);
	CityFile city;
	if (root.is_object()) {
		root.allow_only({ "buildings", "zones", "objects" });
		read_list(root, "buildings", city, read_building);
		read_list(root, "zones", city, read_zone);
		read_list(root, "objects", city, read_object);
		if (diagnostics.error_count() == errors_before) {
			return city;
		}
	}
	return std::nullopt;
}

std::optional<CityFile> load_city_json(const std::string &path, Diagnostics &diagnostics) {
	const Result<std::string> text = read_file(path);
	if (!text) {
		diagnostics.add(text.diagnostic());
		return std::nullopt;
	}
	return parse_city_json(*text, path, diagnostics);
}

std::string city_to_json(const CityModel &city) {
	nlohmann::ordered_json document;
	document["buildings"] = buildings_to_json(city);
	document["zones"] = zones_to_json(city);
	document["objects"] = objects_to_json(city);
	return document.dump(1, '\t', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace pcg
