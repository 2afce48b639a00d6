#include <doctest/doctest.h>

#include <algorithm>

#include "core/io/city_json.h"

using namespace pcg;

namespace {

std::string first_message(std::string_view text) {
	Diagnostics diagnostics;
	CHECK_FALSE(parse_city_json(text, "city.json", diagnostics).has_value());
	REQUIRE(diagnostics.error_count() > 0);
	CHECK(diagnostics.list()[0].file == "city.json");
	return diagnostics.list()[0].message;
}

constexpr std::string_view small_city = R"({
	"buildings": [
		{"id": 9007199254740993, "entrances": [
			{"type": "house", "position": [1, 0, -2.5], "facing": [0, 0, 2], "capacity": 4}, {"type": "shop", "position": [3, 0, 0]}]},
		{"id": -4, "entrances": [{"type": "school", "position": [50, 0, 0]}]}],
	"zones": [{"id": 1, "type": "park", "polygon": [[0, 0, 0], [9, 0, 0], [9, 0, -9]], "height": 3}],
	"objects": [{"id": 1, "type": "bench", "position": [5, 0, -1], "places": 2}]
})";

} // namespace

TEST_CASE("a city file becomes a city model with dense ids in the order of the file") {
	Diagnostics diagnostics;
	const std::optional<CityFile> file = parse_city_json(small_city, "city.json", diagnostics);
	REQUIRE(file.has_value());
	CHECK(diagnostics.is_empty());
	const CityModel &city = file->city;
	CHECK(city.buildings().size() == 2);
	CHECK(file->building_ids.number_of(0) == 9007199254740993);
	CHECK(file->building_ids.index_of(-4) == 1);
	CHECK(BuildingId(file->building_ids.index_of(5)) == BuildingId::Invalid);
	CHECK(city.capacity(BuildingId(0), city.types.find("house")) == 4);
	CHECK(city.entrances()[0].position == glm::vec3(1, 0, -2.5f));
	CHECK(city.entrances()[0].facing == glm::vec3(0, 0, 1));
	CHECK(city.zones()[0].polygon.size() == 3);
	CHECK(city.zones()[0].height == 3.0f);
	REQUIRE(city.objects()[0].places.size() == 2);
	// Two seats 0.6 m apart around the middle.
	CHECK(city.objects()[0].places[0].position.x == doctest::Approx(4.7));
	CHECK(city.objects()[0].places[1].position.x == doctest::Approx(5.3));
}

TEST_CASE("what is written reads back the same") {
	Diagnostics diagnostics;
	CityFile first = *parse_city_json(small_city, "city.json", diagnostics);
	CityObject bench;
	bench.type = first.city.types.add("bench");
	bench.position = { 0.1f, 0.0f, 0.0f };
	bench.places = { { { 0.1f, 0.5f, 0.3f }, { 1, 0, 0 } } };
	first.city.add_object(bench);
	const std::string text = city_to_json(first.city);
	const std::optional<CityFile> second = parse_city_json(text, "again.json", diagnostics);
	REQUIRE(second.has_value());
	CHECK(city_to_json(second->city) == text);
	CHECK(second->city.objects()[1].places[0].position == bench.places[0].position);
	CHECK(second->city.objects()[0].places.size() == 2);
	CHECK(text.find("0.1,") != std::string::npos);
}

TEST_CASE("removed records are not written") {
	Diagnostics diagnostics;
	CityFile file = *parse_city_json(small_city, "city.json", diagnostics);
	file.city.remove_building(BuildingId(0));
	file.city.remove_zone(ZoneId(0));
	const CityFile again = *parse_city_json(city_to_json(file.city), "again.json", diagnostics);
	CHECK(again.city.buildings().size() == 1);
	CHECK(again.building_ids.number_of(0) == 1);
	CHECK(again.city.zones().empty());
}

TEST_CASE("a value of the wrong kind is named with its path in the file") {
	CHECK(first_message("[]").find("the whole file: expected an object") == 0);
	CHECK(first_message(R"({"buildings": 3})").find("buildings: expected a list") == 0);
	CHECK(first_message(R"({"buildings": [{"id": 1}]})").find("buildings[0]: `entrances` is missing") == 0);
	CHECK(first_message(R"({"buildings": [{"id": 1.5, "entrances": []}]})").find("buildings[0].id: expected a whole number") == 0);
	CHECK(first_message(R"({"buildings": [{"id": 99999999999999999999, "entrances": []}]})").find("buildings[0].id: ") == 0);
	CHECK(first_message(R"({"buildings": [{"id": 18446744073709551615, "entrances": []}]})").find("buildings[0].id: ") == 0);
	const char *two_numbers = R"({"buildings": [{"id": 1, "entrances": [{"type": "a", "position": [0, 0, 0]}, {"type": "a", "position": [1, 2]}]}]})";
	CHECK(first_message(two_numbers).find("buildings[0].entrances[1].position: expected three numbers") == 0);
	CHECK(first_message(R"({"objects": [{"id": 1, "type": "", "position": [0, 1e300, 0]}]})").find("objects[0].type: ") == 0);
	CHECK(first_message(R"({"objects": [{"id": 1, "type": "b", "position": [0, 1e300, 0]}]})").find("objects[0].position: ") == 0);
	CHECK(first_message(R"({"objects": [{"id": 1, "type": "b", "position": [0, 0, 0], "places": 0}]})").find("objects[0].places: ") == 0);
	CHECK(first_message(R"({"zones": [{"id": 1, "type": "b", "polygon": [[0, 0, 0]]}]})").find("zones[0].polygon: ") == 0);
	const char *twice = R"({"zones": [{"id": 1, "type": "b", "polygon": [[0,0,0],[1,0,0],[1,0,1]]}, {"id": 1, "type": "b", "polygon": [[0,0,0],[1,0,0],[1,0,1]]}]})";
	CHECK(first_message(twice).find("zones[1].id: the id 1 occurs twice") == 0);
}

TEST_CASE("a wrong value is told with its line and column, and what to do") {
	Diagnostics diagnostics;
	const std::string text = "{\n \"zones\": [],\n \"buildings\": [\n  {\"id\": 1, \"entrances\": []},\n  {\"entrances\": [], \"id\": 2.5}\n ]\n}";
	CHECK_FALSE(parse_city_json(text, "city.json", diagnostics).has_value());
	const auto found = std::ranges::find(diagnostics.list(), Severity::Error, &Diagnostic::severity);
	REQUIRE(found != diagnostics.list().end());
	const Diagnostic &wrong = *found;
	CHECK(wrong.message == "buildings[1].id: expected a whole number from -9223372036854775808 to 9223372036854775807");
	CHECK(wrong.line == 5);
	CHECK(wrong.column == 27);
	CHECK(wrong.source == "  {\"entrances\": [], \"id\": 2.5}");
	CHECK_FALSE(wrong.hint.empty());
	Diagnostics missing;
	CHECK_FALSE(parse_city_json("{\"objects\": [ {\"type\": \"b]\\\"}\", \"id\": 3} ]}", "city.json", missing).has_value());
	CHECK(missing.list()[0].message == "objects[0]: `position` is missing");
	CHECK(missing.list()[0].column == 15);
}

TEST_CASE("what the JSON library says is not shown") {
	for (const char *text : { "{\"a\": nul}", "{\"a\": 1", "[1 2]", "{\"a\": \"\x01\"}" }) {
		Diagnostics diagnostics;
		CHECK_FALSE(parse_city_json(text, "city.json", diagnostics).has_value());
		REQUIRE(diagnostics.error_count() == 1);
		const std::string message = diagnostics.list()[0].message;
		CHECK(message.starts_with("this is not JSON: "));
		CHECK(message.find("exception") == std::string::npos);
		CHECK(message.find("syntax error") == std::string::npos);
		CHECK_FALSE(diagnostics.list()[0].hint.empty());
	}
}

TEST_CASE("text that is not JSON is refused with line and column") {
	Diagnostics diagnostics;
	CHECK_FALSE(parse_city_json("{\n\t\"buildings\": [,]\n}", "city.json", diagnostics).has_value());
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.list()[0].line == 2);
	CHECK(diagnostics.list()[0].column == 16);
	CHECK(diagnostics.list()[0].source == "\t\"buildings\": [,]");
	for (std::string text : { std::string(), std::string("\0\xFF\xFE{", 4), std::string(200000, '['), std::string("{\"a\": \"\xC3\x28\"}") }) {
		Diagnostics others;
		CHECK_FALSE(parse_city_json(text, "city.json", others).has_value());
		CHECK(others.error_count() == 1);
	}
}

TEST_CASE("a misspelt key is a warning that names the one meant") {
	Diagnostics diagnostics;
	CHECK(parse_city_json(R"({"building": []})", "city.json", diagnostics).has_value());
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].hint == "did you mean `buildings`?");
}

TEST_CASE("a missing city file is an error that names it") {
	Diagnostics diagnostics;
	CHECK_FALSE(load_city_json("no/such/city.json", diagnostics).has_value());
	REQUIRE(diagnostics.error_count() == 1);
	CHECK(diagnostics.list()[0].file == "no/such/city.json");
}
