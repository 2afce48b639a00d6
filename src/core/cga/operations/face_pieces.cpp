#include "core/cga/operations/face_pieces.h"

namespace pcg::cga {

namespace {

void put(Shape &shape, const Geometry *geometry) {
	shape.geometry = geometry;
	shape.geometry_offset = glm::dvec3(0.0);
	shape.geometry_scale = glm::dvec3(1.0);
	refit(shape);
}

Flow run_piece_shape(Context &context, Context::Children &children, const Shape &parent, const BlockEntry &entry) {
	const Geometry *geometry = context.builder.finish(context.arena, false);
	if (geometry == nullptr) {
		return Flow::Next;
	}
	Shape child = parent;
	put(child, geometry);
	return children.run(child, entry.body);
}

} // namespace

SeenPieces seen(const FacePieces &pieces) {
	SeenPieces result;
	for (const FacePiece &piece : pieces) {
		result.push_back({ piece.face, &piece.polygon });
	}
	return result;
}

Flow run_pieces(Context &context, Context::Children &children, const Shape &parent, const BlockEntry &entry, std::span<const SeenPiece> pieces) {
	const bool is_one = entry.separator != BlockEntry::Separator::Each;
	for (size_t i = 0; i < pieces.size(); ++i) {
		if (i == 0 || !is_one) { // bodies use the builder too
			context.builder.begin(pieces[i].face->geometry());
		}
		pieces[i].face->add(context.builder, *pieces[i].polygon);
		const bool is_whole = !is_one || i + 1 == pieces.size();
		if (is_whole && run_piece_shape(context, children, parent, entry) != Flow::Next) {
			return Flow::Stop;
		}
	}
	return Flow::Next;
}

void replace_faces(Context &context, bool is_closed) {
	if (const Geometry *geometry = context.builder.finish(context.arena, is_closed)) {
		put(context.shape, geometry);
	}
}

bool is_word(Context &context, const BlockEntry &entry, std::string_view word) {
	return entry.word != no_symbol && context.vm.program().texts[entry.word].view == word;
}

SmallVector<FlatFace, 1> flat_faces(const Geometry &geometry, FlatFace::View view) {
	SmallVector<FlatFace, 1> faces;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		if (geometry.outline(geometry.faces[i]).size() >= 3) {
			faces.emplace_back(geometry, i, view);
		}
	}
	return faces;
}

double setback_distance(Context &context, const Value &value) {
	const double distance = context.finite(value);
	if (distance < 0.0) {
		context.vm.warn("negative-distance", "edges are set back inwards only; 0 is taken instead", "offset() with a positive distance moves all outwards");
		return 0.0;
	}
	return distance;
}

} // namespace pcg::cga
