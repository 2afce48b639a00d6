#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <string>

#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"

// Speed of derivations on one core, without reading and compiling the rules and without making triangles. One JSON object a line. `peer` is
// CityEngine's runtime on one core of a comparable machine: 9 to 11 thousand box lots and 140 to 190 thousand faces a second.
namespace {

using namespace pcg;

// Of processor time, so that other programs on the machine do not count.
double seconds_of(const std::function<void()> &work) {
	const std::clock_t start = std::clock();
	work();
	return double(std::clock() - start) / CLOCKS_PER_SEC;
}

void print(const char *name, double value, const char *unit, double peer) {
	std::printf("{\"name\": \"%s\", \"value\": %.1f, \"unit\": \"%s\", \"peer\": %.1f, \"ratio\": %.3f}\n", name, value, unit, peer, peer > 0.0 ? value / peer : 0.0);
}

std::shared_ptr<const Program> compiled(const std::string &text) {
	MemorySourceProvider provider;
	provider.add("bench.cga", text);
	Diagnostics diagnostics;
	auto program = load_program("bench.cga", cga::cga_dialect(), provider, diagnostics);
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return program;
}

// At least half a second of derivations; gives lots and faces a second.
std::pair<double, double> rates(const Program &program, double width, double depth) {
	cga::Deriver deriver(program);
	uint64_t lots = 0, faces = 0;
	double seconds = 0.0;
	for (uint64_t batch = 16; seconds < 0.5; batch *= 2) {
		lots = faces = 0;
		seconds = seconds_of([&] {
			for (; lots < batch; ++lots) {
				faces += deriver.derive(cga::InitialShape::rectangle(width, depth, lots)).face_count;
			}
		});
	}
	return { double(lots) / seconds, double(faces) / seconds };
}

void bench_boxes() {
	if (const auto program = compiled("Lot --> extrude(10) comp(f) { bottom : NIL | top : Roof. | side : Wall. }")) {
		print("cga_box_lots", rates(*program, 20.0, 20.0).first, "lots/s", 10'000.0);
	}
}

// About 10 000 faces: floors, tiles, windows.
void bench_facades() {
	if (const auto program = compiled("Lot --> extrude(60) comp(f) { side : Facade | all : Cap. }\n"
									  "Facade --> split(y) { { ~3 : Floor }* }\n"
									  "Floor --> split(x) { { ~2 : Tile }* }\n"
									  "Tile --> split(x) { ~1 : Wall. | 1 : split(y) { 1 : Wall. | 1.2 : Window. | ~1 : Wall. } | ~1 : Wall. }\n")) {
		print("cga_facade_faces", rates(*program, 100.0, 100.0).second, "faces/s", 165'000.0);
	}
}

void bench_shipped(const std::string &name) {
	Diagnostics diagnostics;
	if (const auto program = load_program("rules/cga/" + name + ".cga", cga::cga_dialect(), diagnostics)) {
		const auto [lots, faces] = rates(*program, 20.0, 20.0);
		print(("cga_" + name + "_lots").c_str(), lots, "lots/s", 0.0);
		print(("cga_" + name + "_faces").c_str(), faces, "faces/s", 165'000.0);
	}
}

} // namespace

int main() {
	bench_boxes();
	bench_facades();
	for (const char *name : { "house", "apartment", "workplace" }) {
		bench_shipped(name);
	}
	return 0;
}
