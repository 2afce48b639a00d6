#include "bench/allocation_count.h"
#include "bench/cga_bench.h"

// Memory of derivations by face of the model, on one thread. A program of its own, because counting takes time.
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
void bench_memory(const Building &building, const Program &program) {
	cga::Deriver deriver(program, options());
	const size_t before = heap.bytes;
	heap.most_bytes = before;
	const cga::DerivationResult model = deriver.derive(cga::InitialShape::rectangle(building.width, building.width, 1));
	const double result = double(bytes_of(model.mesh) + model.instances.size() * sizeof(cga::ModelInstance)), faces = double(model.face_count);
	const std::string name = std::string("cga_") + building.name;
	print(name + "_transient_bytes", (double(heap.most_bytes - before) - result) / faces, "bytes/face", 100.0);
	print(name + "_result_bytes", result / faces, "bytes/face");
}

} // namespace

int main() {
	for (const Building &building : buildings) {
		if (const auto program = loaded(building.name)) {
			bench_memory(building, *program);
		}
	}
	return 0;
}
