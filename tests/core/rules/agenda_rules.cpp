#include <doctest/doctest.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "core/base/day_names.h"
#include "tests/core/agenda/agenda_fixture.h"
#include "tests/core/rules/lived_day.h"
#include "tests/core/rules/rule_file.h"

using namespace pcg;

// Runs tests/rules/agenda/*.pcg; their README tells the format.
namespace {

struct ExpectedDay {
	uint32_t person = 0;
	std::string form; // walks, lived; empty: the agenda
	std::string when;
	std::string what;
};

struct RuleTest {
	AgendaFixture fixture;
	MemorySourceProvider files;
	std::vector<ExpectedDay> days;
	std::vector<std::string> messages; // "12 warning no-building", sorted
};

// "w40@1.5"
void add_person(AgendaFixture &fixture, const std::string &text) {
	const size_t at = text.find('@');
	const float age = std::strtof(text.substr(1, at - 1).c_str(), nullptr);
	const float speed = at == std::string::npos ? 1.0f : std::strtof(text.c_str() + at + 1, nullptr);
	fixture.add_person(age, text[0] == 'w' ? Gender::Woman : Gender::Man, speed);
}

// "bench 10 2"
void add_object(AgendaFixture &fixture, std::istringstream &words) {
	std::string type;
	CityObject object;
	int places = 1;
	words >> type >> object.position.x >> places;
	object.type = fixture.city.types.add(type);
	for (int i = 0; i < places && !words.fail(); ++i) {
		object.places.push_back({ object.position + glm::vec3(float(i), 0.0f, 0.0f), { 0.0f, 0.0f, 1.0f } });
	}
	fixture.city.add_object(object);
}

// "park 100": ten metres square, entered from the west.
void add_zone(AgendaFixture &fixture, std::istringstream &words) {
	std::string type;
	float x = 0.0f;
	words >> type >> x;
	Zone zone;
	zone.type = fixture.city.types.add(type);
	zone.polygon = { { x, 0.0f, -5.0f }, { x, 0.0f, 5.0f }, { x + 10.0f, 0.0f, 5.0f }, { x + 10.0f, 0.0f, -5.0f } };
	fixture.city.add_zone(zone);
}

void read_directive(RuleTest &test, const std::string &line) {
	std::istringstream words(line);
	std::string word;
	words >> word;
	if (word == "zone") {
		add_zone(test.fixture, words);
	} else if (word == "building") {
		float x = 0.0f;
		words >> word >> x;
		test.fixture.add_building(word, x);
	} else if (word == "object") {
		add_object(test.fixture, words);
	} else if (word == "household") {
		uint32_t home = 0;
		words >> home >> word; // with the colon behind it
		test.fixture.add_household(BuildingId(home));
		while (words >> word) {
			if (word != ":") {
				add_person(test.fixture, word);
			}
		}
	} else if (word == "seed") {
		words >> test.fixture.options.seed;
	}
}

void read_expectation(RuleTest &test, const std::string &text, size_t line) {
	std::istringstream words(text);
	std::string first, second;
	words >> first >> second;
	if (first == "error" || first == "warning") {
		std::string at;
		size_t other_line = line;
		words >> at >> other_line; // "at 9:2"
		test.messages.push_back(std::to_string(at == "at" ? other_line : line) + " " + first + " " + second);
		return;
	}
	const size_t colon = text.find(':');
	REQUIRE(colon != std::string::npos);
	std::string form;
	if (second == "walks" || second == "lived") {
		form = second;
		words >> second;
	}
	second.erase(std::remove(second.begin(), second.end(), ':'), second.end());
	REQUIRE((second == "pool" || second == "all" || weekday_named(second)));
	test.days.push_back({ uint32_t(std::stoul(first)), form, second, trimmed(text.substr(colon + 1)) });
}

void read_test(RuleTest &test, const std::string &path) {
	read_rule_file(path, test.files, [&](const RuleFileLine &line) {
		if (line.remark.starts_with("expect ")) {
			read_expectation(test, line.remark.substr(7), line.number);
		} else if (line.is_whole_line) {
			read_directive(test, line.remark);
		}
	});
	std::sort(test.messages.begin(), test.messages.end());
}

std::string pool_of(const AgendaFixture &fixture, PersonId id) {
	std::ostringstream text;
	for (const FloatingTask &task : fixture.agendas.floating_tasks_of(id)) {
		text << (text.str().empty() ? "" : "; ") << fixture.program->rules[index_of(task.rule)].name << " " << task.duration_ms / 1000.0 << " "
			 << task.priority;
	}
	return text.str();
}

void check_day(const AgendaFixture &fixture, const ExpectedDay &expected) {
	INFO("person " << expected.person << " " << expected.when);
	const PersonId id = PersonId(expected.person);
	REQUIRE(expected.person < fixture.population.persons.size());
	if (expected.when == "pool") {
		CHECK(pool_of(fixture, id) == expected.what);
		return;
	}
	for (int day = 0; day < 7; ++day) {
		if (expected.when != "all" && expected.when != short_day_name(size_t(day))) {
			continue;
		}
		const std::string found = expected.form == "walks" ? fixture.walks_of(id, day)
				: expected.form == "lived"				   ? lived_day(fixture, id, day)
														   : fixture.day_of(id, day);
		CHECK(found == expected.what);
		if (found != expected.what) {
			return; // the other days are hardly better
		}
	}
}

void run_test(const std::string &path) {
	INFO(path);
	RuleTest test;
	read_test(test, path);
	AgendaFixture &fixture = test.fixture;
	fixture.use(load_program(path, pcg_dialect(), test.files, fixture.diagnostics));
	std::vector<std::string> messages;
	for (const Diagnostic &diagnostic : fixture.diagnostics.list()) {
		messages.push_back(std::to_string(diagnostic.line) + (diagnostic.severity == Severity::Error ? " error " : " warning ") + std::string(diagnostic.id));
	}
	std::sort(messages.begin(), messages.end());
	INFO(to_text(fixture.diagnostics));
	CHECK(messages == test.messages);
	if (fixture.program) {
		for (const ExpectedDay &expected : test.days) {
			check_day(fixture, expected);
		}
	}
	CHECK((!test.days.empty() || !test.messages.empty()));
}

} // namespace

TEST_CASE("the agenda language by example") {
	std::vector<std::string> paths;
	std::error_code error;
	for (const auto &entry : std::filesystem::directory_iterator("tests/rules/agenda", error)) {
		if (entry.path().extension() == ".pcg") {
			paths.push_back(entry.path().generic_string());
		}
	}
	std::sort(paths.begin(), paths.end());
	REQUIRE(paths.size() > 10);
	for (const std::string &path : paths) {
		run_test(path);
	}
}
