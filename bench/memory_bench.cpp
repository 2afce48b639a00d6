#include <optional>

#include "bench/allocation_count.h"
#include "bench/cga_bench.h"
#include "bench/house_rules.h"
#include "core/city/city_generator.h"
#include "core/city/walkable.h"
#include "core/navigation/nav_mesh_paths.h"

// Memory of cities by building, and of derivations by face of the model, on one thread. A program of its own, because counting takes time.
namespace {

using namespace pcg;
using namespace pcg::bench;

size_t bytes_of(const Mesh &mesh) {
	size_t result = mesh.positions.size() * sizeof(mesh.positions[0]) + mesh.loop_ends.size() * sizeof(mesh.loop_ends[0]) +
			mesh.faces.size() * sizeof(mesh.faces[0]) + mesh.normals.size() * sizeof(mesh.normals[0]);
	for (const auto &uvs : mesh.uvs) {
		result += uvs.size() * sizeof(glm::vec2);
	}
	return result;
}

// What a derivation needs beside its result: arena, builders, the lists of waiting shapes, what growing lists leave behind; and, as this is the
// interpreter's first, the models that it reads.
void bench_memory(const bench::Building &building, const Program &program) {
	cga::Deriver deriver(program, options());
	const size_t before = heap.bytes;
	heap.most_bytes = before;
	const cga::DerivationResult model = deriver.derive(cga::InitialShape::rectangle(building.width, building.width, 1));
	const double result = double(bytes_of(model.mesh) + model.instances.size() * sizeof(cga::ModelInstance)), faces = double(model.face_count);
	const std::string name = std::string("cga_") + building.name;
	print(name + "_transient_bytes", (double(heap.most_bytes - before) - result) / faces, "bytes/face", 100.0);
	print(name + "_result_bytes", result / faces, "bytes/face");
}

// What 10,000 buildings take, on the ground that the core makes of a layout: all that stays between questions; beside it what each thread keeps that has
// asked for a way.
void bench_city() {
	constexpr double limit = 2000.0; // bytes a building
	Diagnostics diagnostics;
	MemorySourceProvider sources;
	sources.add("house.cga", std::string(house_rules));
	const RulesByType rules = { { "", { load_program("house.cga", cga::cga_dialect(), sources, diagnostics), {}, {} } } };
	const std::optional<City> city = generate_city(*make_layout(layout_for_lots(10'000), diagnostics), rules, {}, diagnostics);
	const double count = double(city->model.buildings().size());
	size_t before = heap.bytes;
	const CityModel model = city->model;
	const double of_model = double(heap.bytes - before) / count;
	before = heap.bytes;
	const NavMesh mesh = city_nav_mesh(*city);
	const double of_ground = double(heap.bytes - before) / count;
	before = heap.bytes;
	const NavMeshPaths paths(model, mesh);
	const double of_distances = double(heap.bytes - before) / count;
	print("city_model_bytes", of_model, "bytes/building");
	print("city_ground_bytes", of_ground, "bytes/building");
	print("city_doors_and_known_distances_bytes", of_distances, "bytes/building");
	print("city_bytes", of_model + of_ground + of_distances, "bytes/building", limit);
	before = heap.bytes;
	(void)paths.distance(BuildingId(0), BuildingId(1));
	print("city_search_bytes", double(heap.bytes - before) / count, "bytes/building");
}

} // namespace

int main() {
	bench_city();
	for (const bench::Building &building : buildings) {
		if (const auto program = loaded(building.name)) {
			bench_memory(building, *program);
		}
	}
	return 0;
}
