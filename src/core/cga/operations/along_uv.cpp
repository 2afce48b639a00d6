#include "core/cga/along_uv.h"

#include <string>

#include "core/cga/context.h"
#include "core/cga/operations/inserted.h"
#include "core/cga/operations/operations.h"
#include "core/cga/uv.h"

// insertAlongUV (CGA reference, section 5.6).
namespace pcg::cga {

namespace {

Flow insert_along(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	AlongUv settings;
	const int uv_set = uv_set_of(context, args[0]);
	if (uv_set < 0) {
		return Flow::Next;
	}
	settings.uv_set = size_t(uv_set);
	const Geometry *ground = baked(context.shape, context.arena);
	if (ground == nullptr || ground->uvs(settings.uv_set) == nullptr) {
		vm.warn("no-uvs", "there are no texture coordinates in set " + std::to_string(uv_set) + " to insert along",
				"projectUV() makes some; streets and assets bring their own");
		return Flow::Next;
	}
	settings.height = context.finite(args[2]);
	settings.direction = args.count() > 3 && args[3].word == 1 ? AlongUv::Direction::VertexNormal : AlongUv::Direction::ScopeY;
	settings.keeps_position = args.count() > 4 && args[4].word == 1;
	const std::string_view name = args[1].is_text() ? args[1].text->view : std::string_view();
	const AlongUvResult result = insert_along_uv(*ground, *inserted_geometry(vm, name, AssetStore::Up::Y), settings, context.clipper, context.arena);
	if (result.is_cut_short) {
		vm.warn("too-many-faces", "the asset would be repeated more often than " + std::to_string(settings.max_faces) + " faces allow; the rest is left out",
				"are the texture coordinates as they should be? tileUV() and normalizeUV() set how often it is repeated");
	}
	set_geometry(context.shape, result.geometry);
	return Flow::Next;
}

} // namespace

void add_along_uv_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "insertAlongUV",
			{ { "uvSet", Number }, { "file", Text }, { "height", Number }, { "direction", Word, "scope.y vertex.normal", true },
					{ "position", Word, "alignPosition keepPosition", true } },
			BlockKind::None, insert_along,
			"Bends a model along texture coordinates, once for each 1 x 1 of them: its x becomes u, its z -v, its y the height. Only triangles and quads are covered." });
}

} // namespace pcg::cga
