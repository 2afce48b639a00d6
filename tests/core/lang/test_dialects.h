#pragma once

#include <string>
#include <vector>

#include "core/io/rule_loader.h"
#include "core/lang/vm.h"

// Two small dialects for the tests of the language itself: what their operations do is written into a log.
namespace pcg::test {

class LogHost : public VmHost {
public:
	std::vector<std::string> log;
	Diagnostics diagnostics;
	std::vector<double> members = { 40.0, 38.0, 9.0, 70.0 }; // ages
	int focus = -1;
	bool runs_called_rules = true; // of the shape dialect: run_rule as a host would

	std::string text() const; // the log, joined by spaces
	Flow call_rule(Vm &vm, RuleId rule, std::span<const Value> args) override;
	void push_group(Vm &) override { log.emplace_back("["); }
	void pop_group(Vm &) override { log.emplace_back("]"); }
	void report(Diagnostic diagnostic) override { diagnostics.add(std::move(diagnostic)); }
};

// Dynamic locals, rule calls run, unknown names are errors: as PCG.
const Dialect &day_dialect();
// Lexical locals, rule calls by the host, unknown names are leaves: as CGA.
const Dialect &shape_dialect();

// A program of one text, as file "test.rules"; null with errors.
std::shared_ptr<const Program> program_of(const std::string &text, const Dialect &dialect, Diagnostics &diagnostics);

// Compiles, runs the rule `Start`, and gives the log, or what went wrong.
std::string run_day(const std::string &text, uint64_t seed = 1);
std::string run_shape(const std::string &text, uint64_t seed = 1);

// The ids and places of all diagnostics: "unknown-name 3:5; syntax 4:1".
std::string places_of(const Diagnostics &diagnostics);
std::string check_day(const std::string &text);
std::string check_shape(const std::string &text);

} // namespace pcg::test
