#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/cga/selectors.h"
#include "core/cga/shape.h"

// Faces, edges and vertices of a shape (CGA reference: op_comp).
namespace pcg::cga {

enum class ComponentKind : uint8_t { Faces, Edges, Vertices, FaceEdges };

// One component, and where its points are: in scope coordinates.
struct ComponentInfo {
	Component component;
	uint32_t face = 0;
	glm::dvec3 from{ 0.0 }, to{ 0.0 }; // of edges; of vertices both are the place
};

// In order: faces as they are; edges and vertices face by face, shared ones once; FaceEdges face by face, all of them. `geometry` in scope
// coordinates, as baked() gives it.
std::vector<ComponentInfo> components_of(const Geometry &geometry, ComponentKind kind);

// The shape of faces (at least one): x along the first one's first edge, z its normal, the pivot at that edge's first point. With
// `keeps_axes` the scope stays as it is turned.
Shape face_shape(const Shape &parent, const Geometry &geometry, std::span<const uint32_t> faces, bool keeps_axes, GeometryBuilder &builder, Arena &arena);
// The shape of an edge or a vertex: x along the edge, z as the component faces.
Shape edge_shape(const Shape &parent, const ComponentInfo &info, Arena &arena);

// Numbers the sets of faces that hang together by edges, in order of their first face.
std::vector<uint32_t> connected_sets(const Geometry &geometry, std::span<const uint32_t> faces);

} // namespace pcg::cga
