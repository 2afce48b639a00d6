#include <cstdio>
#include <cstdlib>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <malloc.h>

#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/cga/instances.h"
#include "core/cga/neighborhood.h"
#include "core/io/rule_loader.h"
#include "core/ports/asset_provider.h"

// Speed of derivations on one core, without reading and compiling the rules and without making triangles. One JSON object a line. `peer` is
// CityEngine's runtime on one core of a comparable machine: 9 to 11 thousand box lots and 140 to 190 thousand faces a second.
namespace {

size_t bytes_now = 0, bytes_most = 0; // on the heap; only counted where one thread runs

} // namespace

void *operator new(size_t size) {
	void *memory = std::malloc(size > 0 ? size : 1);
	if (memory == nullptr) {
		std::abort();
	}
	bytes_now += malloc_usable_size(memory);
	bytes_most = bytes_now > bytes_most ? bytes_now : bytes_most;
	return memory;
}
void operator delete(void *memory) noexcept {
	bytes_now -= memory != nullptr ? malloc_usable_size(memory) : 0;
	std::free(memory);
}
void operator delete(void *memory, size_t) noexcept {
	operator delete(memory);
}

namespace {

using namespace pcg;

// A window frame of four bars around a pane's place, 1 m wide and high, 0.1 m deep: 16 faces.
class FrameAsset final : public AssetProvider {
public:
	FrameAsset() {
		const auto corner = [](int i, double inset, double z) {
			const double low = inset, high = 1.0 - inset;
			return glm::vec3(i == 1 || i == 2 ? high : low, i >= 2 ? high : low, z);
		};
		for (int i = 0; i < 4; ++i) {
			const int n = (i + 1) % 4;
			add({ corner(i, 0.0, 0.1), corner(n, 0.0, 0.1), corner(n, 0.08, 0.1), corner(i, 0.08, 0.1) });
			add({ corner(i, 0.08, 0.1), corner(n, 0.08, 0.1), corner(n, 0.08, 0.0), corner(i, 0.08, 0.0) });
			add({ corner(n, 0.0, 0.1), corner(i, 0.0, 0.1), corner(i, 0.0, 0.0), corner(n, 0.0, 0.0) });
			add({ corner(n, 0.0, 0.0), corner(i, 0.0, 0.0), corner(i, 0.08, 0.0), corner(n, 0.08, 0.0) });
		}
		_asset.materials.emplace_back();
	}
	const Asset *find(std::string_view, std::string_view) const override { return &_asset; }
	std::string locate(std::string_view name, std::string_view) const override { return std::string(name); }

private:
	void add(const std::vector<glm::vec3> &points) {
		Mesh &mesh = _asset.mesh;
		mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
		mesh.faces.emplace_back();
		mesh.faces.back().first_loop = uint32_t(mesh.loop_ends.size());
		mesh.loop_ends.push_back(uint32_t(mesh.positions.size()));
	}

	Asset _asset;
};

const FrameAsset &frame_asset() {
	static const FrameAsset asset;
	return asset;
}

cga::DeriveOptions options() {
	cga::DeriveOptions result;
	result.assets = &frame_asset();
	return result;
}

// Of processor time, so that other programs on the machine do not count.
double seconds_of(const std::function<void()> &work) {
	const std::clock_t start = std::clock();
	work();
	return double(std::clock() - start) / CLOCKS_PER_SEC;
}

void print(const std::string &name, double value, const char *unit, double peer) {
	std::printf("{\"name\": \"%s\", \"value\": %.3f, \"unit\": \"%s\", \"peer\": %.1f, \"ratio\": %.3f}\n", name.c_str(), value, unit, peer,
			peer > 0.0 ? value / peer : 0.0);
}

std::shared_ptr<const Program> compiled(const std::string &text) {
	MemorySourceProvider provider;
	provider.add("bench.cga", text);
	Diagnostics diagnostics;
	auto program = load_program("bench.cga", cga::cga_dialect(), provider, diagnostics);
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return program;
}

// At least 0.4 seconds of derivations; gives lots and faces a second.
std::pair<double, double> rates(const Program &program, double width, double depth) {
	cga::Deriver deriver(program, options());
	uint64_t lots = 0, faces = 0;
	double seconds = 0.0;
	for (uint64_t batch = 1; seconds < 0.4; batch *= 2) {
		lots = faces = 0;
		seconds = seconds_of([&] {
			for (; lots < batch; ++lots) {
				faces += deriver.derive(cga::InitialShape::rectangle(width, depth, lots)).face_count;
			}
		});
	}
	return { double(lots) / seconds, double(faces) / seconds };
}

const char *const box_rules = "Lot --> extrude(10) comp(f) { bottom : NIL | top : Roof. | side : Wall. }";

void bench_boxes() {
	if (const auto program = compiled(box_rules)) {
		print("cga_box_lots", rates(*program, 20.0, 20.0).first, "lots/s", 10'000.0);
	}
}

// Real time, on one thread and on two.
void bench_threads() {
	const auto program = compiled(box_rules);
	std::vector<cga::InitialShape> lots;
	for (uint64_t i = 0; program && i < 100'000; ++i) {
		lots.push_back(cga::InitialShape::rectangle(20.0, 20.0, i));
	}
	double seconds[2] = {};
	for (unsigned threads : { 1u, 2u }) {
		const auto start = std::chrono::steady_clock::now();
		cga::derive_all(*program, lots, {}, { threads, {}, nullptr });
		seconds[threads - 1] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
	}
	print("cga_box_lots_two_threads_speedup", seconds[0] / seconds[1], "times", 1.0);
}

// By operation: rules whose faces are made by it.
void bench_operations() {
	const std::pair<const char *, const char *> cases[] = {
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
		{ "insert", "Lot --> split(x) { ~1 : split(z) { ~1 : s('1, 2, '1) i(\"frame.obj\") }* }*" },
		{ "texture", "Lot --> setupProjection(0, scope.xz, 4, 4) split(x) { ~1 : split(z) { ~1 : texture(\"a.jpg\") projectUV(0) X. }* }*" },
		{ "color", "Lot --> split(x) { ~1 : split(z) { ~1 : color(rand(), 0.5, 0.5) X. }* }*" },
		{ "occlusion", "Lot --> split(x) { ~10 : extrude(10 + split.index) comp(f) { side : split(y) { ~2 : Tile }* | all : NIL } }*\n"
					   "Tile --> case touches(intra) : X. else : Y." },
	};
	for (const auto &[name, text] : cases) {
		if (const auto program = compiled(text)) {
			print(std::string("cga_") + name + "_faces", rates(*program, 100.0, 100.0).second, "faces/s", 165'000.0);
		}
	}
}

// What a derivation needs beside its result, by face: arena, builders, the lists of waiting shapes, what growing lists leave behind.
void bench_memory(const std::string &name, const Program &program, double width) {
	cga::Deriver deriver(program, options());
	const size_t before = bytes_now;
	bytes_most = bytes_now;
	const cga::DerivationResult model = deriver.derive(cga::InitialShape::rectangle(width, width, 1));
	const size_t most = bytes_most;
	const size_t faces = model.face_count;
	const Mesh copy = model.mesh;
	size_t result = copy.positions.size() * sizeof(copy.positions[0]) + copy.loop_ends.size() * sizeof(copy.loop_ends[0]) + copy.faces.size() * sizeof(copy.faces[0]) +
			copy.normals.size() * sizeof(glm::vec3);
	for (const auto &uvs : copy.uvs) {
		result += uvs.size() * sizeof(glm::vec2);
	}
	result += model.instances.size() * sizeof(cga::ModelInstance);
	print(name + "_result_bytes", double(result) / double(faces), "bytes/face", 0.0);
	print(name + "_transient_bytes", (double(most - before) - double(result)) / double(faces), "bytes/face", 0.0);
}

void bench_tower() {
	Diagnostics diagnostics;
	const auto program = load_program("bench/rules/tower.cga", cga::cga_dialect(), diagnostics);
	std::fputs(to_text(diagnostics).c_str(), stderr);
	if (!program) {
		return;
	}
	const cga::DerivationResult model = cga::derive(*program, cga::InitialShape::rectangle(36.0, 36.0, 1), options());
	std::fputs(to_text(model.diagnostics).c_str(), stderr);
	print("cga_tower_faces", double(model.face_count), "faces", 47'000.0);
	const auto [lots, faces] = rates(*program, 36.0, 36.0);
	print("cga_tower_seconds", 1.0 / lots, "s", 0.3);
	print("cga_tower_faces_per_second", faces, "faces/s", 165'000.0);
	// The same with every inserted frame written out as faces.
	cga::Deriver deriver(*program, options());
	const double seconds = seconds_of([&] { (void)cga::written_out(deriver.derive(cga::InitialShape::rectangle(36.0, 36.0, 1))); });
	print("cga_tower_written_out_seconds", seconds, "s", 0.3);
	bench_memory("cga_tower", *program, 36.0);
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
	print("cga_shipped_faces_per_second", double(faces) / seconds, "faces/s", 165'000.0);
}

} // namespace

int main(int count, char **names) {
	const std::string only = count > 1 ? names[1] : "";
	const std::pair<const char *, void (*)()> benches[] = { { "boxes", bench_boxes }, { "threads", bench_threads }, { "operations", bench_operations },
		{ "tower", bench_tower }, { "shipped", bench_shipped } };
	for (const auto &[name, run] : benches) {
		if (only.empty() || only == name) {
			run();
		}
	}
	return 0;
}
