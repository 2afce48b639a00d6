#include <doctest/doctest.h>

#include "agenda_fixture.h"
#include "core/agenda/host_builtins.h"

using namespace pcg;

namespace {

HostFunction is_open() {
	HostFunction function;
	function.name = "isOpen";
	function.params = { { "building", HostType::Number }, { "time", HostType::Number, true } };
	function.result = HostType::Bool;
	function.call = [](HostCall &call) -> HostValue { return call.number(0) == 1.0 && (call.count() < 2 || call.number(1) < 20 * 3600.0); };
	function.help = "Whether the shop is open.";
	return function;
}

HostOperation visit() {
	HostOperation operation;
	operation.name = "visit";
	operation.params = { { "type", HostType::Text }, { "hour", HostType::Number } };
	operation.call = [](HostCall &call) {
		const TypeId type = call.context().city().types.find(call.text(0));
		const auto &buildings = call.context().city().buildings_of_type(type);
		if (buildings.empty()) {
			call.fail("there is nothing to visit");
			return;
		}
		call.insert(TaskKind::GoToBuilding, call.number(1) * 3600.0, (call.number(1) + 1.0) * 3600.0, index_of(buildings[0]));
	};
	return operation;
}

struct Game {
	AgendaFixture fixture;
	HostDialect host{ pcg_dialect() };

	Game() {
		fixture.add_building("house", 0);
		fixture.add_building("shop", 100);
		fixture.add_household(BuildingId(0));
		fixture.add_person(40);
		CHECK(host.add(is_open(), fixture.diagnostics));
		CHECK(host.add(visit(), fixture.diagnostics));
	}
	bool generate(const std::string &rules) {
		MemorySourceProvider provider;
		provider.add("game.pcg", rules);
		return fixture.use(load_program("game.pcg", host.dialect(), provider, fixture.diagnostics));
	}
};

} // namespace

TEST_CASE("rules call what the host added, and the days around the call hold for it") {
	Game game;
	REQUIRE(game.generate("@StartRule\nHousehold --> members { true: Day }\n"
						  "Day --> stayInside(0h, 24h, home) [ case isOpen(1, 10h) && !isOpen(0): days(\"sat\") { visit(\"shop\", 10) } ]"));
	CHECK(game.fixture.problems() == "");
	CHECK(game.fixture.day_of(PersonId(0), 0) == "00:00-24:00 stay 0");
	CHECK(game.fixture.day_of(PersonId(0), 5) == "00:00-10:00 stay 0; 10:00-11:00 go 1; 11:00-24:00 stay 0");
}

TEST_CASE("calls of what the host added are checked at load time") {
	Game game;
	CHECK_FALSE(game.generate("@StartRule\nHousehold -->\n\tvisit(\"shop\")\n\tvisit(10, 10)\n\tset(x, isOpen())\n\tset(y, isOpne(1))\n\tvisit(\"shop\", isOpen(1))"));
	CHECK(game.fixture.problems() == "wrong-argument-count type-mismatch wrong-argument-count unknown-name type-mismatch");
	CHECK(game.fixture.diagnostics.list()[3].hint == "did you mean `isOpen`?");
}

TEST_CASE("what the host added is a near name, also where a command belongs") {
	Game game;
	CHECK_FALSE(game.generate("@StartRule\nHousehold -->\n\tvisti(\"shop\", 10)\n\tisOpne(1)"));
	REQUIRE(game.fixture.problems() == "unknown-name unknown-name");
	CHECK(game.fixture.diagnostics.list()[0].hint == "did you mean `visit`?");
	CHECK(game.fixture.diagnostics.list()[1].hint == "did you mean `isOpen`? It gives a value: use it inside of an expression");
}

TEST_CASE("what the host says is told with household and place") {
	Game game;
	game.generate("@StartRule\nHousehold -->\n\tmembers { true: visit(\"museum\", 10) }");
	REQUIRE(game.fixture.problems() == "host-error");
	const Diagnostic &told = game.fixture.diagnostics.list()[0];
	CHECK(told.line == 3);
	CHECK(told.message == "household 0: there is nothing to visit");
}

TEST_CASE("an operation of the host needs a focused person to write for") {
	Game game;
	game.generate("@StartRule\nHousehold --> visit(\"shop\", 10)");
	CHECK(game.fixture.problems() == "no-focus");
}

TEST_CASE("a value of another type than was promised is an error, a text comes back as one") {
	Game game;
	HostFunction liar = is_open();
	liar.name = "lie";
	liar.call = [](HostCall &) -> HostValue { return 1.0; };
	HostFunction kind = is_open();
	kind.name = "kindOf";
	kind.result = HostType::Text;
	kind.call = [](HostCall &call) -> HostValue { return std::string(call.number(0) == 1.0 ? "shop" : "house"); };
	REQUIRE(game.host.add(liar, game.fixture.diagnostics));
	REQUIRE(game.host.add(kind, game.fixture.diagnostics));
	REQUIRE(game.generate("@StartRule\nHousehold --> members { true: stayInside(0, 1h, findBuilding(kindOf(1))) } [ case lie(1): Household ]"));
	CHECK(game.fixture.day_of(PersonId(0)) == "00:00-01:00 stay 1");
	CHECK(game.fixture.problems() == "host-error");
}

TEST_CASE("what cannot be registered is told") {
	Game game;
	const auto refused = [&](auto change) {
		HostFunction function = is_open();
		function.name = "other";
		change(function);
		Diagnostics diagnostics;
		CHECK_FALSE(game.host.add(function, diagnostics));
		REQUIRE(diagnostics.list().size() == 1);
		return std::string(diagnostics.list()[0].id);
	};
	CHECK(refused([](HostFunction &f) { f.name = "isOpen"; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.name = "home"; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.name = "is open"; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.name = ""; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.name = "9lives"; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.name = "case"; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.name = "style"; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.name = "set"; }) == "host-name");
	CHECK(refused([](HostFunction &f) { f.params[0].is_optional = true, f.params[1].is_optional = false; }) == "host-parameters");
	CHECK(refused([](HostFunction &f) { f.call = nullptr; }) == "host-call");
}
