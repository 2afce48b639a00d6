#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"
#include "core/lang/dialect.h"
#include "core/lang/opcode.h"
#include "core/lang/program.h"

using namespace pcg;

// The rule files of tests/rules/cga are the manual by example: each operation that is built has three or more of them.
namespace {

std::set<std::string_view> operations_of(const Program &program) {
	std::set<std::string_view> names;
	for (const Instruction &instruction : program.code) {
		if (instruction.code == OpCode::CallOperation || instruction.code == OpCode::CallBlock) {
			names.insert(program.dialect->operations[instruction.extra].name);
		}
	}
	return names;
}

bool is_built(const OperationSpec &operation) { return !operation.help.starts_with("Not built"); }

} // namespace

TEST_CASE("every operation of the shape grammar has three rule files that use it") {
	std::map<std::string_view, int> files;
	for (const OperationSpec &operation : cga::cga_dialect().operations) {
		if (is_built(operation)) {
			files[operation.name] = 0;
		}
	}
	std::error_code error;
	for (const auto &entry : std::filesystem::directory_iterator("tests/rules/cga", error)) {
		Diagnostics diagnostics;
		const auto program = entry.path().extension() == ".cga" ? load_program(entry.path().string(), cga::cga_dialect(), diagnostics) : nullptr;
		for (const std::string_view name : program != nullptr ? operations_of(*program) : std::set<std::string_view>()) {
			if (const auto found = files.find(name); found != files.end()) {
				++found->second;
			}
		}
	}
	for (const auto &[name, count] : files) {
		INFO("the operation `" << std::string(name) << "` is in " << count << " files");
		CHECK(count >= 3);
	}
}
