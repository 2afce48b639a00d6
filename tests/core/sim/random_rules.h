#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"

// Rule sets that nobody thought up: all operations of both phases, in any order and nesting, with sizes that end. They load without an error.
namespace pcg::test {

class RuleWriter {
public:
	explicit RuleWriter(uint64_t seed) : _random(seed, 2) {}

	std::string write() {
		std::string text = "attr shift = " + time(0, 4) + "\nattr lazy = rand(0, 1)\nfloor2(x) = floor(x / 2)\n";
		text += "@StartRule\nHousehold -->\n" + (chance(0.8) ? std::string("\tmembers { true: stayInside(0h, 24h, home) }\n") : "");
		text += "\tset(place, findBuilding(" + building_type() + "))\n\tset(bench, -1)\n";
		for (size_t i = 1 + pick(4); i > 0; --i) {
			text += "\t" + household_command(2) + "\n";
		}
		for (size_t i = 0; i < day_rules; ++i) {
			text += "Day" + std::to_string(i) + "(n, t) -->\n\t" + sequence([&] { return day_command(2, i); }) + "\n";
		}
		for (size_t i = 0; i < stays; ++i) {
			text += "Stay" + std::to_string(i) + " -->\n\tset(n, " + std::to_string(pick(4)) + ")\n\t" + sequence([&] { return stay_command(2, i); }) + "\n";
		}
		return text;
	}

private:
	static constexpr size_t day_rules = 4, stays = 4;

	size_t pick(size_t count) { return _random.index(count); }
	bool chance(double share) { return _random.chance(share); }
	template <typename Make>
	std::string sequence(Make make) {
		std::string text;
		for (size_t i = 1 + pick(3); i > 0; --i) {
			text += make() + " ";
		}
		return text;
	}

	std::string time(size_t first_hour, size_t hours) {
		return std::to_string(first_hour + pick(hours)) + "h" + (chance(0.6) ? std::to_string(pick(60)) + "m" : "");
	}
	// Begin and end; now and then before midnight of the day before, past that of the day, or the wrong way round.
	std::string span() {
		if (chance(0.1)) {
			return "-" + time(1, 3) + ", " + time(0, 5);
		}
		const size_t start = pick(22);
		return time(start, 2) + (chance(0.3) ? " + rand(-5m, 5m), " : ", ") + time(start + (chance(0.95) ? 1 : 0), 6);
	}
	std::string building_type() {
		static const char *types[] = { "\"house\"", "\"school\"", "\"shop\"" };
		return types[pick(3)];
	}
	std::string building() {
		switch (pick(5)) {
			case 0: return "home";
			case 1: return "place";
			case 2: return "findNearestBuilding(" + building_type() + ", home)";
			default: return "findBuilding(" + building_type() + ")";
		}
	}
	std::string days() {
		static const char *sets[] = { "mon", "mon-fri", "sat,sun", "tue,thu-sat", "sun-mon" };
		return sets[pick(5)];
	}
	std::string predicate() {
		static const char *predicates[] = { "age < 18", "age >= 18", "gender", "p(0.5)", "person.id == chooseMember(true)", "age > 10 && !gender",
			"lazy < 0.5", "count(age < 18) > 1", "true" };
		return predicates[pick(9)];
	}
	// Of `members`, which also takes the number of a member.
	std::string member_condition() {
		static const char *choices[] = { "chooseMember(age >= 18)", "chooseMember(age)" };
		return chance(0.3) ? choices[pick(2)] : predicate();
	}

	std::string household_command(int depth) {
		const auto inner = [&] { return household_command(depth - 1); };
		switch (depth > 0 ? pick(8) : 4 + pick(4)) {
			case 0: return "days(\"" + days() + "\") { " + inner() + " }";
			case 1: return "[ case count(" + predicate() + ") > " + std::to_string(pick(3)) + ": " + inner() + " else: " + inner() + " ]";
			case 2: return "[ set(place, " + building() + ") " + inner() + " ]";
			case 3: return "[ 40%: " + inner() + " else: " + inner() + " ]";
			default: return members(depth);
		}
	}
	std::string members(int depth) {
		std::string text = "members { ";
		for (size_t i = 1 + pick(3), n = i; i > 0; --i) {
			text += (i == n ? "" : "| ") + member_condition() + ": " + sequence([&] { return day_command(depth, day_rules); });
		}
		return text + "}";
	}
	// Rules call rules of lower numbers only, so that all of them end.
	std::string day_command(int depth, size_t below) {
		const auto inner = [&] { return day_command(depth - 1, below); };
		switch (depth > 0 ? pick(14) : 6 + pick(6)) {
			case 0: return "days(\"" + days() + "\") { " + inner() + " }";
			case 1: return "[ set(place, " + building() + ") " + inner() + " ]";
			case 2: return "[ case age < " + std::to_string(10 + pick(60)) + ": " + inner() + " else: " + inner() + " ]";
			case 3: return "task(\"" + name() + "\") { " + inner() + " }";
			case 4: return (chance(0.5) ? "requires(\"" : "after(\"") + name() + "\") { " + inner() + " }";
			case 5:
			case 6: return "accompany(" + time(0, 24) + ", " + (chance(0.7) ? "age < 18" : "p(0.6)") + ")";
			case 7: return "goToBuilding(" + span() + ", " + building() + ")";
			case 8: return "stayInside(" + span() + ", " + building() + ")";
			case 9: return "delayedRule(" + span() + ", " + stay() + ")";
			case 10: return "floatingSlot(" + span() + ")";
			case 11: return "floatingTask(" + std::to_string(1 + pick(90)) + "m, " + stay() + (chance(0.5) ? ", " + std::to_string(pick(3)) + ")" : ")");
			default:
				return below == 0 ? "stayInside(" + span() + ", place)"
								  : "Day" + std::to_string(pick(below)) + "(" + std::to_string(pick(5)) + ", shift + rand(0, 1h))";
		}
	}
	std::string name() { return std::string(1, char('a' + pick(3))); }
	std::string stay() { return "Stay" + std::to_string(pick(stays)); }

	std::string stay_command(int depth, size_t below) {
		const auto inner = [&] { return stay_command(depth - 1, below); };
		switch (depth > 0 ? pick(13) : 3 + pick(8)) {
			case 0: return "[ case time > " + time(6, 14) + ": " + inner() + " else: " + inner() + " ]";
			case 1: return "[ case n > 0: set(n, n - 1) " + inner() + " else: wait(1m) ]";
			case 2: return "[ set(bench, findObject(\"bench\", 80)) case isValid(bench): goToObject(bench) " + inner() + " else: wait(10m) ]";
			case 3: return "wait(rand(0, 20m))";
			case 4: return "goToZone(\"park\")";
			case 5: return "goToBuilding(" + (chance(0.5) ? std::string("home") : "findBuilding(" + building_type() + ")") + ")";
			case 6: return "goToBuilding(findBuilding(" + building_type() + ")) stayInside(" + std::to_string(1 + pick(40)) + "m)";
			case 7: return "set(bench, findObject(\"bench\")) interact(bench, \"sit\") wait(5m)";
			case 8: return "set(bench, findObject(\"bench\")) goToObject(bench) wait(" + std::to_string(pick(900)) + ")";
			case 9: return "set(n, floor2(n))";
			case 10: return chance(0.3) ? "waitUntilNextTask()" : "wait(30m)";
			default: return below == 0 ? "wait(1m)" : "wait(1) Stay" + std::to_string(pick(below));
		}
	}

	Random _random;
};

} // namespace pcg::test
