#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <utility>

#include "bench/cga_bench.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/cga/instances.h"
#include "core/cga/neighborhood.h"

// Speed of derivations on one core, without reading and compiling the rules and without making triangles. One JSON object a line. `peer` is
// CityEngine's runtime on one core of a comparable machine: 9 to 11 thousand box lots and 140 to 190 thousand faces a second.
//
//   derive_bench [GROUP]              figures of all groups, or of one: boxes, operations, buildings, shipped, threads
//   derive_bench names                what can be derived by name
//   derive_bench derive NAME COUNT    derives it COUNT times and prints the faces of all: for profilers and for `./dev bench --instructions`
namespace {

using namespace pcg;
using namespace pcg::bench;

constexpr double peer_faces = 165'000.0, peer_lots = 10'000.0; // a second

// Of processor time, so that other programs on the machine do not count.
double seconds_of(const std::function<void()> &work) {
	const std::clock_t start = std::clock();
	work();
	return double(std::clock() - start) / CLOCKS_PER_SEC;
}

// At least 0.4 seconds of derivations; gives lots and faces a second.
std::pair<double, double> rates(const Program &program, double width) {
	cga::Deriver deriver(program, options());
	uint64_t lots = 0, faces = 0;
	double seconds = 0.0;
	for (uint64_t batch = 1; seconds < 0.4; batch *= 2) {
		lots = faces = 0;
		seconds = seconds_of([&] {
			for (; lots < batch; ++lots) {
				faces += deriver.derive(cga::InitialShape::rectangle(width, width, lots)).face_count;
			}
		});
	}
	return { double(lots) / seconds, double(faces) / seconds };
}

struct Case {
	const char *name;
	const char *text; // nullptr: the file of that name in bench/rules/
	double width = 100.0; // of the lot
};

constexpr Case boxes = { "boxes", "Lot --> extrude(10) comp(f) { bottom : NIL | top : Roof. | side : Wall. }", 20.0 };

// Rules whose faces are made by one operation.
constexpr Case operations[] = {
	{ "facade", "Lot --> extrude(60) comp(f) { side : Facade | all : Cap. }\n"
				"Facade --> split(y) { { ~3 : Floor }* }\n"
				"Floor --> split(x) { { ~2 : Tile }* }\n"
				"Tile --> split(x) { ~1 : Wall. | 1 : split(y) { 1 : Wall. | 1.2 : Window. | ~1 : Wall. } | ~1 : Wall. }\n" },
	{ "extrude", "Lot --> split(x) { ~1 : split(z) { ~1 : extrude(3) }* }*" },
	{ "comp", "Lot --> split(x) { ~1 : extrude(3) comp(f) { all : X. } }*" },
	{ "clip", "Lot --> primitiveDisk(32) split(x) { ~1 : split(z) { ~1 : X. }* }*" },
	{ "roof_hip", "Lot --> split(x) { ~10 : split(z) { ~8 : roofHip(30) }* }*" },
	{ "roof_gable", "Lot --> split(x) { ~10 : split(z) { ~8 : roofGable(30) }* }*" },
	{ "setback", "Lot --> split(x) { ~10 : split(z) { ~8 : setback(1) { all : X. | remainder : Y. } }* }*" },
	{ "offset", "Lot --> split(x) { ~10 : split(z) { ~8 : offset(-1) }* }*" },
	{ "shape_l", "Lot --> split(x) { ~10 : split(z) { ~8 : shapeL(2, 3) { shape : X. | remainder : Y. } }* }*" },
	{ "primitive_cube", "Lot --> split(x) { ~1 : split(z) { ~1 : s('1, 2, '1) primitiveCube() }* }*" },
	{ "insert", "Lot --> split(x) { ~1 : split(z) { ~1 : s('1, 2, '1) i(\"windows/frame.obj\") }* }*" },
	{ "texture", "Lot --> setupProjection(0, scope.xz, 4, 4) split(x) { ~1 : split(z) { ~1 : texture(\"facades/stone.png\") projectUV(0) X. }* }*" },
	{ "color", "Lot --> split(x) { ~1 : split(z) { ~1 : color(rand(), 0.5, 0.5) X. }* }*" },
	{ "occlusion", "Lot --> split(x) { ~10 : extrude(10 + split.index) comp(f) { side : split(y) { ~2 : Tile }* | all : NIL } }*\n"
				   "Tile --> case touches(intra) : X. else : Y." },
};

std::shared_ptr<const Program> program_of(const Case &named) {
	return named.text != nullptr ? compiled(named.text) : loaded(named.name);
}

std::vector<Case> all_cases() {
	std::vector<Case> cases(std::begin(operations), std::end(operations));
	cases.push_back(boxes);
	for (const Building &building : buildings) {
		cases.push_back({ building.name, nullptr, building.width });
	}
	return cases;
}

void bench_boxes() {
	if (const auto program = program_of(boxes)) {
		print("cga_box_lots", rates(*program, boxes.width).first, "lots/s", peer_lots);
	}
}

void bench_operations() {
	for (const Case &operation : operations) {
		if (const auto program = program_of(operation)) {
			print(std::string("cga_") + operation.name + "_faces", rates(*program, operation.width).second, "faces/s", peer_faces);
		}
	}
}

void bench_buildings() {
	for (const Building &building : buildings) {
		const auto program = loaded(building.name);
		if (!program) {
			continue;
		}
		const std::string name = std::string("cga_") + building.name;
		const cga::DerivationResult model = cga::derive(*program, cga::InitialShape::rectangle(building.width, building.width, 1), options());
		std::fputs(to_text(model.diagnostics).c_str(), stderr);
		print(name + "_faces", double(model.face_count), "faces", 47'000.0);
		const auto [lots, faces] = rates(*program, building.width);
		print(name + "_seconds", 1.0 / lots, "s", 0.3);
		print(name + "_faces_per_second", faces, "faces/s", peer_faces);
		// The same with every inserted model written out as faces.
		cga::Deriver deriver(*program, options());
		const cga::InitialShape lot = cga::InitialShape::rectangle(building.width, building.width, 1);
		print(name + "_written_out_seconds", seconds_of([&] { (void)cga::written_out(deriver.derive(lot)); }), "s", 0.3);
	}
}

// 300 lots, as many of each rule file that ships.
void bench_shipped() {
	std::vector<std::shared_ptr<const Program>> programs;
	std::error_code error;
	for (const auto &entry : std::filesystem::directory_iterator("rules/cga", error)) {
		Diagnostics diagnostics;
		auto program = entry.path().extension() == ".cga" ? load_program(entry.path().string(), cga::cga_dialect(), diagnostics) : nullptr;
		if (program && is_valid(program->start_rule)) {
			programs.push_back(std::move(program));
		}
	}
	uint64_t faces = 0;
	const double seconds = seconds_of([&] {
		for (size_t p = 0; p < programs.size(); ++p) {
			cga::Deriver deriver(*programs[p], options());
			for (size_t i = p; i < 300; i += programs.size()) {
				faces += deriver.derive(cga::InitialShape::rectangle(20.0, 24.0, i)).face_count;
			}
		}
	});
	print("cga_shipped_300_lots_seconds", seconds, "s", 0.5);
	print("cga_shipped_faces_per_second", double(faces) / seconds, "faces/s", peer_faces);
}

// On one thread and on two: how often faster by the clock, which needs a machine with two idle cores; and how much of the processor time of
// one thread both together need, which does not: twice its inverse is what idle cores would give. The least of seven turns counts.
// Models are given back outside of the measurement: whoever derives lots keeps them.
void bench_two_threads(const std::string &name, const std::function<std::vector<cga::DerivationResult>(unsigned threads)> &run) {
	double seconds[2] = { INFINITY, INFINITY }, work[2] = { INFINITY, INFINITY };
	for (int turn = 0; turn < 7; ++turn) {
		for (const unsigned threads : { 1u, 2u }) {
			std::vector<cga::DerivationResult> models;
			const auto start = std::chrono::steady_clock::now();
			const double spent = seconds_of([&] { models = run(threads); });
			const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
			work[threads - 1] = std::min(work[threads - 1], spent);
			seconds[threads - 1] = std::min(seconds[threads - 1], passed);
		}
	}
	print(name + "_two_threads_speedup", seconds[0] / seconds[1], "times", 1.0);
	print(name + "_two_threads_work", work[1] / work[0], "times", 1.0);
}

void bench_lots_on_threads(const std::string &name, const Program &program, double width, uint64_t count) {
	std::vector<cga::InitialShape> lots;
	for (uint64_t i = 0; i < count; ++i) {
		lots.push_back(cga::InitialShape::rectangle(width, width, i));
	}
	bench_two_threads(name, [&](unsigned threads) { return cga::derive_all(program, lots, options(), { threads, {}, nullptr }); });
}

// What the machine gives: arithmetic in registers alone.
void bench_ceiling() {
	std::array<uint64_t, 64> results = {};
	bench_two_threads("machine", [&](unsigned threads) {
		parallel_for(results.size(), { threads, {}, nullptr }, [&](size_t i) {
			uint64_t value = i;
			for (int step = 0; step < 200'000; ++step) {
				value = mix64(value);
			}
			results[i] = value;
		});
		return std::vector<cga::DerivationResult>();
	});
}

void bench_threads() {
	bench_ceiling();
	if (const auto program = program_of(boxes)) {
		bench_lots_on_threads("cga_box_lots", *program, boxes.width, 20'000);
	}
	if (const auto program = loaded("building")) {
		bench_lots_on_threads("cga_building", *program, 44.0, 10);
	}
}

int derive_case(const std::string &name, int count) {
	for (const Case &named : all_cases()) {
		const auto program = name == named.name ? program_of(named) : nullptr;
		if (program) {
			cga::Deriver deriver(*program, options());
			uint64_t faces = 0;
			for (int i = 0; i < count; ++i) {
				faces += deriver.derive(cga::InitialShape::rectangle(named.width, named.width, 1)).face_count;
			}
			std::printf("%llu\n", static_cast<unsigned long long>(faces));
			return 0;
		}
	}
	std::fprintf(stderr, "there is no case %s\n", name.c_str());
	return 1;
}

} // namespace

int main(int count, char **arguments) {
	const std::string only = count > 1 ? arguments[1] : "";
	if (only == "names") {
		for (const Case &named : all_cases()) {
			std::printf("%s\n", named.name);
		}
		return 0;
	}
	if (only == "derive" && count == 4) {
		return derive_case(arguments[2], std::atoi(arguments[3]));
	}
	const std::pair<const char *, void (*)()> groups[] = { { "boxes", bench_boxes }, { "operations", bench_operations }, { "buildings", bench_buildings },
		{ "shipped", bench_shipped }, { "threads", bench_threads } };
	for (const auto &[name, run] : groups) {
		if (only.empty() || only == name) {
			run();
		}
	}
	return 0;
}
