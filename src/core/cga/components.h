#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/cga/selectors.h"
#include "core/cga/shape.h"

// Faces, edges and vertices of a shape (CGA reference: op_comp).
namespace pcg::cga {

enum class ComponentKind : uint8_t { Faces, Edges, Vertices, FaceEdges, FaceVertices, Groups, Materials, Holes };

// One component, and where its points are: in scope coordinates.
struct ComponentInfo {
	Component component;
	uint32_t face = 0; // of Groups and Materials the first one
	glm::dvec3 from{ 0.0 }, to{ 0.0 }; // of edges; of vertices both are the place
	uint32_t loop = 0; // of Holes
	bool runs_back = false; // as a roof's edge (Component::roof_edge) it runs from `to` to `from`
	std::vector<uint32_t> faces; // of Groups and Materials
};

// In order: faces as they are; edges and vertices face by face, shared ones once; FaceEdges and FaceVertices face by face, all of them; one
// group, which is everything; materials in order of their first face; holes face by face. `geometry` in scope coordinates, as baked() gives it.
std::vector<ComponentInfo> components_of(const Geometry &geometry, ComponentKind kind);

// Says of edges whether they are eaves, hips, valleys or ridges, and how these run: eaves counter-clockwise, the others upwards.
void name_roof_edges(const Geometry &geometry, std::vector<ComponentInfo> &edges);

// The shape of faces (at least one) of a shape and its scope: x along the first one's first edge, z its normal, the pivot at that edge's first
// point. With `keeps_axes` the scope stays as it is turned.
Shape face_shape(const Shape &parent, const Frame &scope, const Geometry &geometry, std::span<const uint32_t> faces, glm::dvec3 first_normal, bool keeps_axes,
		GeometryBuilder &builder, Arena &arena);
// The shape of edges or vertices (at least one): x along the first edge, z as it faces, the pivot at its first point.
Shape edge_shape(const Shape &parent, std::span<const ComponentInfo *const> infos, bool keeps_axes, bool is_roof_edge, GeometryBuilder &builder, Arena &arena);
// The shape of holes, filled.
Shape hole_shape(const Shape &parent, const Geometry &geometry, std::span<const ComponentInfo *const> holes, bool keeps_axes, GeometryBuilder &builder,
		Arena &arena);

// Numbers the sets of faces that hang together by edges, in order of their first face.
std::vector<uint32_t> connected_sets(const Geometry &geometry, std::span<const uint32_t> faces);
// The same for edges that share an end.
std::vector<uint32_t> connected_edges(std::span<const ComponentInfo> edges, std::span<const uint32_t> asked);

} // namespace pcg::cga
