#include <cstddef>
#include <cstdlib>
#include <new>

#include <malloc.h>

#include "bench/cga_bench.h"

// Memory of derivations by face of the model, on one thread. A program of its own, because it counts every allocation, which takes time.
namespace {

size_t bytes_now = 0, bytes_most = 0; // on the heap

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
	const size_t before = bytes_now;
	bytes_most = bytes_now;
	const cga::DerivationResult model = deriver.derive(cga::InitialShape::rectangle(building.width, building.width, 1));
	const double result = double(bytes_of(model.mesh) + model.instances.size() * sizeof(cga::ModelInstance)), faces = double(model.face_count);
	const std::string name = std::string("cga_") + building.name;
	print(name + "_transient_bytes", (double(bytes_most - before) - result) / faces, "bytes/face", 100.0);
	print(name + "_result_bytes", result / faces, "bytes/face", 0.0);
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
