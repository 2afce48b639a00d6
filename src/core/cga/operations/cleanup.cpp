#include "core/cga/cleanup.h"
#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// cleanupGeometry, setNormals, softenNormals (CGA reference, section 6).
namespace pcg::cga {

namespace {

Flow clean(Vm &vm, const Args &args) {
	enum : uint32_t { All, Vertices, Edges, Faces };
	Context &context = Context::of(vm);
	const uint32_t what = args[0].word;
	const Cleanup cleanup = { what == All || what == Vertices, what == All || what == Edges, what == All || what == Faces, context.finite(args[1]) };
	clean_up(context.shape, cleanup, context.builder, context.arena);
	return Flow::Next;
}

Flow set_normals(Vm &vm, const Args &args) {
	enum : uint32_t { Soft, Hard, Auto, Conform };
	static constexpr double angles[] = { 180.0, 0.0, 30.0, 0.0 };
	Context &context = Context::of(vm);
	if (args[0].word == Conform) {
		conform_normals(context.shape, context.builder, context.arena);
	}
	soften_normals(context.shape, angles[args[0].word], context.arena);
	return Flow::Next;
}

Flow soften(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	soften_normals(context.shape, context.finite(args[0]), context.arena);
	return Flow::Next;
}

Flow reduce_vertices(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	reduce(context.shape, context.finite(args[0]), context.builder, context.arena);
	return Flow::Next;
}

} // namespace

void add_cleanup_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	operations.push_back({ "cleanupGeometry", { { "components", Word, "all vertices edges faces" }, { "tolerance", Number } }, BlockKind::None, clean,
			"Merges vertices and takes away those in straight lines (vertices), joins faces of one plane (edges), drops doubles and slivers (faces). Tolerance 0 is "
			"exact; 1 is one metre, 10 degrees, one square metre." });
	operations.push_back({ "setNormals", { { "mode", Word, "soft hard auto conform" } }, BlockKind::None, set_normals,
			"How edges are shaded: as if they were round (soft), as edges (hard), or soft below 30 degrees (auto); conform turns all faces to the outside." });
	operations.push_back({ "softenNormals", { { "angle", Number } }, BlockKind::None, soften, "Shades edges softly where faces meet at less than this angle." });
	operations.push_back({ "reduceGeometry", { { "share", Number } }, BlockKind::None, reduce_vertices,
			"Takes that share of the vertices away, 0 to 1, where the surface changes least." });
}

} // namespace pcg::cga
