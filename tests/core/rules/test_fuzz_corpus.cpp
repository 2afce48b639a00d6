#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "core/cga/dialect.h"
#include "core/city/drawn_blocks.h"
#include "core/io/atomic_file.h"
#include "core/io/city_json.h"
#include "core/io/geojson.h"
#include "core/io/household_csv.h"
#include "core/io/population_csv.h"
#include "core/sim/dialect.h"
#include "tests/core/agenda/agenda_fixture.h"

using namespace pcg;

// What fuzzing starts from, and whatever ever broke a reader, is read in every test run too: it ends, and an input that is refused says why.
namespace {

std::vector<std::string> files_below(const std::string &folder) {
	std::vector<std::string> paths;
	std::error_code error;
	for (const auto &entry : std::filesystem::directory_iterator(folder, error)) {
		paths.push_back(entry.path().generic_string());
	}
	std::sort(paths.begin(), paths.end());
	return paths;
}

std::shared_ptr<const Program> load(const std::string &text, const Dialect &dialect, Diagnostics &diagnostics) {
	MemorySourceProvider provider;
	provider.add("main", text);
	return load_program("main", dialect, provider, diagnostics);
}

} // namespace

TEST_CASE("rule files of the fuzz corpora are read or refused in both languages") {
	size_t count = 0;
	for (const char *target : { "lexer", "parser", "loader", "agenda_loader", "generator", "derivation" }) {
		for (const std::string &path : files_below("fuzz/corpus/" + std::string(target))) {
			INFO(path);
			const Result<std::string> text = read_file(path);
			REQUIRE(text.is_ok());
			for (const Dialect *dialect : { &pcg_dialect(), &cga::cga_dialect() }) {
				Diagnostics diagnostics;
				const bool is_read = load(*text, *dialect, diagnostics) != nullptr;
				CHECK(is_read != diagnostics.has_errors());
				++count;
			}
		}
	}
	CHECK(count > 60);
}

TEST_CASE("agendas of the fuzz corpus are written to the end") {
	for (const std::string &path : files_below("fuzz/corpus/generator")) {
		INFO(path);
		AgendaFixture fixture;
		fixture.add_building("house", 0);
		fixture.add_building("school", 200);
		fixture.add_building("shop", 300);
		fixture.add_household(BuildingId(0));
		fixture.add_person(40);
		fixture.add_person(6);
		const Result<std::string> text = read_file(path);
		REQUIRE(text.is_ok());
		fixture.use(load(*text, pcg_dialect(), fixture.diagnostics));
		CHECK((fixture.program == nullptr) == (fixture.agendas.first_task.empty()));
	}
}

TEST_CASE("tables of the fuzz corpus are read or refused") {
	FileIds buildings;
	buildings.add(1);
	buildings.add(7);
	for (const std::string &path : files_below("fuzz/corpus/tables")) {
		INFO(path);
		const Result<std::string> text = read_file(path);
		REQUIRE((text.is_ok() && !text->empty()));
		const std::string_view rest = std::string_view(*text).substr(1);
		Diagnostics diagnostics;
		switch (text->front()) {
			case 'h':
				CHECK(parse_household_table(rest, path, diagnostics).has_value());
				break;
			case 'p':
				CHECK(parse_population(rest, path, &buildings, diagnostics).has_value());
				break;
			default:
				CHECK(parse_city_json(rest, path, diagnostics).has_value() != diagnostics.has_errors());
		}
	}
}

TEST_CASE("maps of the fuzz corpus are laid out or refused") {
	size_t count = 0;
	for (const std::string &path : files_below("fuzz/corpus/geojson")) {
		INFO(path);
		const Result<std::string> text = read_file(path);
		REQUIRE(text.is_ok());
		Diagnostics diagnostics;
		const auto footprints = parse_geojson(*text, path, diagnostics);
		const bool is_laid_out = footprints && layout_of_footprints(*footprints, LayoutParameters(), diagnostics).has_value();
		CHECK(is_laid_out != diagnostics.has_errors());
		Diagnostics of_blocks;
		const bool is_divided = footprints && layout_of_blocks(*footprints, LayoutParameters(), of_blocks).has_value();
		CHECK(is_divided != (of_blocks.has_errors() || !footprints));
		++count;
	}
	CHECK(count > 1);
}
