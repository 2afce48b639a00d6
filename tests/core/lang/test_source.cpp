#include <doctest/doctest.h>

#include "core/lang/source.h"
#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("lines end as Unix, Windows and old Macs do") {
	const Source source("f", "a\nbc\r\nd\re");
	CHECK(source.line(1) == "a");
	CHECK(source.line(2) == "bc");
	CHECK(source.line(3) == "d");
	CHECK(source.line(4) == "e");
	CHECK(source.line(5) == "");
	CHECK(source.position(3).line == 2);
	CHECK(source.position(3).column == 2);
	CHECK(source.position(8).line == 4);
}

TEST_CASE("columns count characters, and excerpts are not cut inside of one") {
	const Source source("f", "a\nñ €x é\nb");
	CHECK(source.position(4).column == 2); // the space behind ñ, of two bytes
	CHECK(source.position(8).column == 4); // x, behind € of three
	CHECK(source.position(8).line == 2);
	CHECK(source.position(13).column == 1);
	std::string wide = "a";
	for (int i = 0; i < 1500; ++i) {
		wide += "é";
	}
	CHECK(Source("f", wide).excerpt(1, 1) == wide.substr(0, 1999));
}

TEST_CASE("imports are found beside the file that imports") {
	CHECK(resolve_import("rules/a/main.pcg", "day.pcg") == "rules/a/day.pcg");
	CHECK(resolve_import("rules/a/main.pcg", "../b/./day.pcg") == "rules/b/day.pcg");
	CHECK(resolve_import("main.pcg", "../day.pcg") == "../day.pcg");
	CHECK(resolve_import("main.pcg", "/x/../day.pcg") == "/day.pcg");
	CHECK(resolve_import("res://rules/main.pcg", "../x/day.pcg") == "res://x/day.pcg");
	CHECK(resolve_import("res://main.pcg", "../../day.pcg") == "res://day.pcg");
	CHECK(resolve_import("C:\\rules\\main.pcg", "sub\\day.pcg") == "C:/rules/sub/day.pcg");
	CHECK(resolve_import("a.pcg", "C:/b.pcg") == "C:/b.pcg");
}

TEST_CASE("bytes that are no rule text are refused with one message") {
	CHECK(check_day("") == "empty-file 0:0");
	CHECK(check_day(" \n\t\r\n") == "empty-file 0:0");
	CHECK(check_day(std::string("A --> log(1)\0x", 14)) == "binary-file 0:0");
	CHECK(check_day("\xFF\xFE" "A") == "not-utf-8 0:0");
}

TEST_CASE("a byte order mark and Windows line ends are fine; Latin-1 is read with a warning") {
	CHECK(run_day("\xEF\xBB\xBFStart --> log(\"\xC3\xA9\")\r\n") == "\xC3\xA9");
	CHECK(check_day("A -->\n log(\"caf\xE9\")") == "not-utf-8 2:10");
	CHECK(run_day("Start --> log(\"caf\xE9\")") == "caf\xC3\xA9");
}

TEST_CASE("a line with a comment only is a rule file without rules") { CHECK(check_day("// nothing yet") == ""); }
