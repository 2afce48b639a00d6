#include <doctest/doctest.h>

#include "core/io/asset_search.h"

using namespace pcg;

namespace {

using Paths = std::vector<std::string>;

// The workspace of the examples in CityEngine's page on fileSearch.
MemoryTree example() {
	MemoryTree files;
	for (const char *path : { "w/MyProject/rules/rule.cga", "w/MyProject/assets/textures/1.png", "w/MyProject/assets/textures/2.png", "w/MyProject/assets/textures/4.png",
				 "w/MyProject/assets/tower.png", "w/MyProject/assets/tower.obj", "w/OtherProject/assets/glass.png", "w/OtherProject/assets/brick.obj" }) {
		files.add(path, "x");
	}
	return files;
}

const std::string rule = "w/MyProject/rules/rule.cga";

} // namespace

TEST_CASE("searches find what the examples of fileSearch find") {
	const MemoryTree files = example();
	const AssetSearch search(files, {});
	const std::string own = "/MyProject/assets/", other = "/OtherProject/assets/";
	CHECK(search.search("*.png", rule) == Paths{ own + "textures/1.png", own + "textures/2.png", own + "textures/4.png", own + "tower.png", other + "glass.png" });
	CHECK(search.search("?.png", rule).empty());
	CHECK(search.search("*/?.png", rule) == Paths{ own + "textures/1.png", own + "textures/2.png", own + "textures/4.png" });
	CHECK(search.search("textures/*", rule) == Paths{ own + "textures/1.png", own + "textures/2.png", own + "textures/4.png" });
	CHECK(search.search("$[12].png", rule).empty());
	CHECK(search.search("$textures/[12].png", rule) == Paths{ own + "textures/1.png", own + "textures/2.png" });
	CHECK(search.search("$.*/[12].png", rule) == Paths{ own + "textures/1.png", own + "textures/2.png" });
	CHECK(search.search("$textures/[2-5].png", rule) == Paths{ own + "textures/2.png", own + "textures/4.png" });
	CHECK(search.search("$textures/[12].png|.*.obj", rule) == Paths{ own + "textures/1.png", own + "textures/2.png", own + "tower.obj", other + "brick.obj" });
	CHECK(search.search("Name=1.png", rule) == Paths{ own + "textures/1.png" });
	CHECK(search.search("Project=OtherProject Ext=obj", rule) == Paths{ other + "brick.obj" });
	CHECK(search.search("", rule).empty());
	CHECK(search.search("$(", rule).empty());
}

TEST_CASE("names are sought in assets, in the project, beside the rule file, and from the workspace") {
	MemoryTree files = example();
	files.add("w/MyProject/tower.obj", "x");
	files.add("w/MyProject/notes.txt", "x");
	files.add("w/MyProject/rules/near.obj", "x");
	files.add("more/far.obj", "x");
	const AssetSearch search(files, { "more" });
	CHECK(search.locate("tower.obj", rule) == "w/MyProject/assets/tower.obj");
	CHECK(search.locate("notes.txt", rule) == "w/MyProject/notes.txt");
	CHECK(search.locate("assets/tower.png", rule) == "w/MyProject/assets/tower.png");
	CHECK(search.locate("near.obj", rule) == "w/MyProject/rules/near.obj");
	CHECK(search.locate("textures\\1.png", rule) == "w/MyProject/assets/textures/1.png");
	CHECK(search.locate("/OtherProject/assets/brick.obj", rule) == "w/OtherProject/assets/brick.obj");
	CHECK(search.locate("far.obj", rule) == "more/far.obj");
	CHECK(search.locate("Textures/1.PNG", rule) == "w/MyProject/assets/textures/1.png"); // as on Windows
	CHECK(search.locate("brick.obj", rule).empty());
	CHECK(search.locate("textures", rule).empty());
	CHECK(search.locate("", rule).empty());
	CHECK(search.locate(std::string(5000, '/'), rule).empty());
}

TEST_CASE("an engine's project is the workspace of its own rules") {
	MemoryTree files;
	files.add("res://rules/a.cga", "x");
	files.add("res://assets/door.obj", "x");
	files.add("res://city/rules/b.cga", "x");
	const AssetSearch search(files, {});
	CHECK(search.locate("door.obj", "res://rules/a.cga") == "res://assets/door.obj");
	CHECK(search.locate("/assets/door.obj", "res://city/rules/b.cga") == "res://assets/door.obj");
	const Paths found = search.search("door*", "res://rules/a.cga");
	REQUIRE(found.size() == 1);
	CHECK(search.locate(found[0], "res://rules/a.cga") == "res://assets/door.obj");
}
