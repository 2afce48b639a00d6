#include <doctest/doctest.h>

#include "core/lang/lexer.h"
#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

namespace {

std::string tokens_of(const std::string &text, bool has_time_units = false) {
	Diagnostics diagnostics;
	const Source source("test.rules", text);
	std::string joined;
	for (const Token &token : tokenize(source, has_time_units, diagnostics).tokens) {
		if (token.kind != TokenKind::End) {
			joined += (joined.empty() ? "" : " ") + text.substr(token.offset, token.length) +
					(token.kind == TokenKind::Number ? "=" + value_text(Value::of(token.number)) : "");
		}
	}
	return joined + (diagnostics.is_empty() ? "" : " | " + places_of(diagnostics));
}

} // namespace

TEST_CASE("numbers in every form that occurs") {
	CHECK(tokens_of("12 1.5 .5 1. 1e-10 2E3") == "12=12 1.5=1.5 .5=0.5 1.=1 1e-10=1e-10 2E3=2000");
	CHECK(tokens_of("1.==1") == "1=1 .== 1=1");
	CHECK(tokens_of("1e999") == "1e999=nan | number-range 1:1");
}

TEST_CASE("names hold dots and dollars; a dot at the end makes a leaf symbol") {
	CHECK(tokens_of("scope.sx imp.Rule a$b Wall. Wall.| Wall.// x") == "scope.sx imp.Rule a$b Wall. Wall. | Wall.");
	CHECK(tokens_of("a .+ b a.==b") == "a .+ b a .== b");
}

TEST_CASE("times have units from large to small") {
	CHECK(tokens_of("8h 5m30s 8h30m15s 0.5h", true) == "8h=28800 5m30s=330 8h30m15s=30615 0.5h=1800");
	CHECK(tokens_of("8x 5m3h 8h30 4hours", true).find("bad-unit 1:1; bad-unit 1:4; bad-unit 1:9; bad-unit 1:14") != std::string::npos);
	CHECK(tokens_of("1e309h 1e308h 1h" + std::string(400, '9') + "m 2h", true).ends_with("=nan 2h=7200 | number-range 1:1; number-range 1:8; number-range 1:15"));
}

TEST_CASE("comments of three kinds, and marks inside of text") {
	CHECK(tokens_of("a // b\nc # d\ne /* f\n g */ h \"# // /*\"") == "a c e h \"# // /*\"");
	CHECK(tokens_of("a /* b") == "a | open-comment 1:3");
}

TEST_CASE("arrows, signs and selectors") {
	CHECK(tokens_of("A-->B a->b a=:b c:=d e=f x<=y") == "A --> B a -> b a =: b c := d e = f x <= y");
	CHECK(tokens_of("a--b ...") == "a - - b ...");
}

TEST_CASE("text that is never closed is told once") {
	CHECK(tokens_of("a \"b\nc") == "a \"b\nc | open-string 1:3");
	CHECK(check_day("A --> log(\"b)\nB --> log(1)\n") == "open-string 1:11");
}

TEST_CASE("characters that no rule has are told where they stand") {
	CHECK(tokens_of("a \xE2\x80\x9C b") == "a b | unexpected-character 1:3");
	CHECK(tokens_of("a ? b") == "a b | unexpected-character 1:3");
}
