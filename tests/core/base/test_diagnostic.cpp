#include <doctest/doctest.h>

#include "core/base/diagnostic.h"

using namespace pcg;

TEST_CASE("a diagnostic shows place, message, source line, caret and what to do") {
	const Diagnostic diagnostic{ Severity::Error, "unknown-name", "a.pcg", 3, 2, "there is no rule `Gp`", "did you mean `Go`?", "\tGp(1)" };
	CHECK(to_text(diagnostic) == "a.pcg:3:2: error: there is no rule `Gp` [unknown-name]\n    \tGp(1)\n    \t^\n    did you mean `Go`?");
}

TEST_CASE("a caret in a very long line shows the surroundings only") {
	Diagnostic diagnostic{ Severity::Error, "x", "f", 1, 5000001, "m", "", std::string(10'000'000, '(') };
	CHECK(to_text(diagnostic).size() < 500);
}

TEST_CASE("carets stand below characters, and no character is cut") {
	const Diagnostic short_line{ Severity::Error, "x", "f", 1, 4, "m", "", "ñé x" };
	CHECK(to_text(short_line).ends_with("\n    ñé x\n       ^"));
	std::string line;
	for (int i = 0; i < 300; ++i) {
		line += "ñ";
	}
	const std::string text = to_text(Diagnostic{ Severity::Error, "x", "f", 1, 201, "m", "", line });
	const size_t start = text.find("\n    ") + 5, end = text.find('\n', start);
	CHECK(text.substr(start, end - start) == line.substr(0, 320));
	CHECK(text.substr(end) == "\n    " + std::string(80, ' ') + "^");
}

TEST_CASE("diagnostics keep the first ones and count all, appending keeps the counts") {
	Diagnostics many(2);
	for (int i = 0; i < 5; ++i) {
		many.error("e", "message");
	}
	many.warning("w", "warning");
	Diagnostics all;
	all.append(many);
	CHECK(many.list().size() == 2);
	CHECK(all.error_count() == 5);
	CHECK(all.warning_count() == 1);
	CHECK(to_text(all).find("and 4 more") != std::string::npos);
}

TEST_CASE("the closest name forgives typing, case and a changed word") {
	const std::vector<std::string_view> names = { "VisitBuilding", "GoToPark", "SitInBench", "goToBuilding" };
	CHECK(closest_name("VisitPark", names) == "GoToPark");
	CHECK(closest_name("gotobuilding", names) == "goToBuilding");
	CHECK(closest_name("SitInBecnh", names) == "SitInBench");
	CHECK(closest_name("Quux", names).empty());
}

TEST_CASE("diagnostics are sorted by place within each file, and errors are kept when there is no room") {
	Diagnostics diagnostics(2);
	diagnostics.add({ Severity::Warning, "late", "b", 9, 1, "", "", "" });
	diagnostics.add({ Severity::Warning, "dropped", "b", 2, 1, "", "", "" });
	diagnostics.add({ Severity::Error, "early", "b", 3, 1, "", "", "" });
	diagnostics.sort();
	REQUIRE(diagnostics.list().size() == 2);
	CHECK(diagnostics.list()[0].id == "early");
	CHECK(diagnostics.list()[1].id == "late");
	CHECK(diagnostics.error_count() == 1);
	CHECK(diagnostics.warning_count() == 2);
}
