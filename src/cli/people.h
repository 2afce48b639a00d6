#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cli/args.h"
#include "cli/attributes.h"
#include "cli/file_names.h"
#include "core/base/diagnostic.h"
#include "core/io/city_json.h"
#include "core/io/population_csv.h"

namespace pcg::cli {

// Which city and which people a command is about: --city, and --households with --persons or --population, --seed, and --attr for their rules.
struct PeopleRequest {
	std::string city, households, people;
	uint32_t persons = 0;
	uint64_t seed = 1;
	std::vector<AttributeText> attributes;

	bool has_file_numbers() const { return !people.empty(); } // persons and households have numbers of their own
};

PeopleRequest read_people_request(Args &args);

// Notes a problem for each output that would overwrite an input or another output.
void check_people_outputs(Args &args, const PeopleRequest &request, const std::string &rules, std::span<const NamedFile> outputs);

// Drawn or read. False, with errors, if there is nobody.
bool make_people(const PeopleRequest &request, const CityFile &city, PopulationFile &people, Diagnostics &diagnostics);

// Of the files; they have to outlive it.
FileNumbers numbers_of(const PeopleRequest &request, const CityFile &city, const PopulationFile &people);

} // namespace pcg::cli
