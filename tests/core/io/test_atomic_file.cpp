#include <doctest/doctest.h>

#include <filesystem>

#include "core/io/atomic_file.h"

using namespace pcg;

namespace {

std::string scratch(const std::string &name) {
	const std::filesystem::path folder = std::filesystem::temp_directory_path() / "pcg_test_atomic_file";
	return (folder / name).string();
}

size_t count_files(const std::string &folder) {
	size_t count = 0;
	for ([[maybe_unused]] const auto &entry : std::filesystem::directory_iterator(folder)) {
		++count;
	}
	return count;
}

} // namespace

TEST_CASE("a written file reads back, in a folder made on the way, and nothing else is left there") {
	std::filesystem::remove_all(scratch("new"));
	Diagnostics diagnostics;
	const std::string bytes("two\nlines\0 and a zero", 21);
	CHECK(write_file(scratch("new/a.txt"), bytes, diagnostics));
	const Result<std::string> back = read_file(scratch("new/a.txt"));
	REQUIRE(back.is_ok());
	CHECK(*back == bytes);
	CHECK(count_files(scratch("new")) == 1);
	CHECK(diagnostics.is_empty());
}

TEST_CASE("a file that is not committed leaves the old one as it was") {
	Diagnostics diagnostics;
	REQUIRE(write_file(scratch("keep/a.txt"), "old", diagnostics));
	{
		AtomicFile file(scratch("keep/a.txt"));
		file.write("new, but");
	}
	CHECK(*read_file(scratch("keep/a.txt")) == "old");
	CHECK(count_files(scratch("keep")) == 1);
}

TEST_CASE("a place that cannot be written to is one error that names it") {
	std::filesystem::create_directories(scratch("folder"));
	for (const std::string &path : { scratch("folder"), std::string(), scratch("keep/a.txt/b.txt") }) {
		Diagnostics diagnostics;
		CHECK_FALSE(write_file(path, "x", diagnostics));
		REQUIRE(diagnostics.list().size() == 1);
		CHECK(diagnostics.list()[0].file == path);
		CHECK(diagnostics.list()[0].id == "cannot-write-file");
	}
}

TEST_CASE("a missing file, a folder and a file over the limit are errors that name it") {
	Diagnostics diagnostics;
	REQUIRE(write_file(scratch("big.txt"), "0123456789", diagnostics));
	CHECK(read_file(scratch("nowhere.txt")).diagnostic().id == "cannot-read-file");
	CHECK(read_file(scratch("")).diagnostic().id == "cannot-read-file");
	CHECK(read_file(scratch("big.txt"), 9).diagnostic().id == "file-too-large");
	CHECK(read_file(scratch("big.txt"), 10).is_ok());
}

TEST_CASE("a link is written through and a device is left alone") {
	Diagnostics diagnostics;
	REQUIRE(write_file(scratch("target.txt"), "old", diagnostics));
	std::error_code error;
	std::filesystem::remove(scratch("link.txt"), error);
	std::filesystem::create_symlink(std::filesystem::absolute(scratch("target.txt")), scratch("link.txt"), error);
	REQUIRE(!error);
	CHECK(write_file(scratch("link.txt"), "new", diagnostics));
	CHECK(std::filesystem::is_symlink(scratch("link.txt")));
	CHECK(*read_file(scratch("target.txt")) == "new");
	CHECK_FALSE(write_file("/dev/null", "x", diagnostics));
	CHECK(std::filesystem::is_character_file("/dev/null"));
}
