#pragma once

#include <string_view>
#include <vector>

#include "core/cga/context.h"
#include "core/cga/flat_face.h"

// What setback, shapeL and innerRectangle share: each face falls to polygons in its plane, which selectors pick.
namespace pcg::cga {

// Polygons of one kind over all faces, in order. `polygon` in the plane of `face`.
struct FacePiece {
	const FlatFace *face = nullptr;
	Loops2 polygon;
};
using FacePieces = SmallVector<FacePiece, 2>;

// The same, where the polygons lie with somebody else.
struct SeenPiece {
	const FlatFace *face = nullptr;
	const Loops2 *polygon = nullptr;
};
using SeenPieces = SmallVector<SeenPiece, 8>;
SeenPieces seen(const FacePieces &pieces);

// Runs the entry's body on each piece, or with `=` on all in one shape, made of `parent`. Scope and pivot keep their axes, the scope is refitted.
Flow run_pieces(Context &context, Context::Children &children, const Shape &parent, const BlockEntry &entry, std::span<const SeenPiece> pieces);

// The current shape gets the faces in Context::builder, in scope coordinates, and its scope is refitted. Without any it stays as it is.
void replace_faces(Context &context, bool is_closed = false);

// Whether the entry's selector is this word.
bool is_word(Context &context, const BlockEntry &entry, std::string_view word);

// Every face of the geometry, which is in scope coordinates.
SmallVector<FlatFace, 1> flat_faces(const Geometry &geometry, FlatFace::View view = FlatFace::View::Own);

// Distances as setback takes them: finite and not below 0, else 0 with a warning.
double setback_distance(Context &context, const Value &value);

} // namespace pcg::cga
