#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/diagnostic.h"
#include "core/cga/model_report.h"
#include "core/geometry/mesh.h"
#include "core/lang/attribute_override.h"

// From a lot to a model: runs a rule set on an initial shape. Units: metres, y up, -z north; everything here is in world coordinates
// unless it says otherwise.
namespace pcg {
class AssetProvider;
struct Program;
} // namespace pcg

namespace pcg::cga {

// What the start rule receives (CGA reference: attr_initialShape): one lot, footprint or street face, or several faces.
struct InitialShape {
	// Counter-clockwise seen from the side that it looks to: lots from above. The first edge is the lot's front: `street.front` without
	// street widths, `object.front`, x of its scope.
	struct Face {
		std::vector<glm::dvec3> outline;
		std::vector<std::vector<glm::dvec3>> holes;
		// Texture coordinates of set 0, one for each point of the outline and then of the holes; else empty. Streets bring u along and v across.
		std::vector<glm::dvec2> uvs = {};
	};

	std::vector<Face> faces;
	// Width in metres of the street at each edge of the first face's outline, 0 = none. Empty: not known.
	std::vector<float> street_widths;
	std::string name;
	std::string start_rule; // empty: the rule set's own
	std::vector<AttributeOverride> attributes; // what the host sets
	uint64_t seed = 0; // equal seed, equal model

	// One polygon.
	static InitialShape of(std::vector<glm::dvec3> outline, uint64_t seed = 0);
	// A rectangle at y = 0 from the origin to (width, -depth); its front edge lies on the x axis.
	static InitialShape rectangle(double width, double depth, uint64_t seed = 0);
};

// A run that meets a limit stops there with an error in its diagnostics; what it made until then is handed out.
struct DeriveLimits {
	uint32_t max_depth = 1024; // rule calls from the start rule to a leaf
	uint32_t max_shapes = 2'000'000;
	uint32_t max_repeats = 100'000; // parts of one split
	uint64_t max_faces = 20'000'000;
	uint64_t max_steps = 200'000'000; // interpreter steps
	// Of real time for one initial shape; 0 = as long as it takes. What comes out of a run that meets it depends on the machine.
	double max_seconds = 0.0;
};

struct DeriveOptions {
	DeriveLimits limits;
	const AssetProvider *assets = nullptr; // none: inserted files become boxes, with a warning
	const std::atomic<bool> *cancel = nullptr; // set by anybody to stop early: ends as at a limit, with the error "cancelled"
	// Metres from the bounding box of the initial shape: how far occlusion queries look for others (CGA reference: cga_context). Queries
	// by label (minimumDistance ..) look at all of them.
	double occlusion_distance = 1.0;
	bool counts_vertices = false; // for DerivationResult::vertex_count
};

// entrance(type [, capacity]): at the scope's origin, looking along its z.
struct ModelEntrance {
	std::string type;
	glm::vec3 position{ 0.0f };
	glm::vec3 facing{ 0.0f, 0.0f, 1.0f }; // unit, out of the building
	uint32_t capacity = 0; // 0 = not said
};

// zone(type): the prism that spans the scope. Ground outline, counter-clockwise from above.
struct ModelZone {
	std::string type;
	std::vector<glm::vec3> polygon;
	float height = 0.0f;
};

struct ModelPlace {
	glm::vec3 position{ 0.0f };
	glm::vec3 facing{ 0.0f, 0.0f, 1.0f }; // unit
};

// @Object("tag") before a rule: its production and all below it, apart from the lot's own mesh.
struct ModelObject {
	std::string tag;
	glm::mat4 frame{ 1.0f }; // object to world: a rotation and a position, the middle of the floor of its scope
	Mesh mesh; // in the object's frame, so that equal objects have equal meshes and can be moved by their frame alone; without its instances
	std::vector<ModelPlace> places; // at least one; in world coordinates
	int32_t parent = -1; // index of the object that it stands within; -1 = the lot itself
};

// A model from a file that stays as the file has it, but for its place and size.
struct ModelPrototype {
	std::shared_ptr<const Mesh> mesh; // in the file's coordinates; one for all lots that insert it
	std::vector<uint32_t> materials; // MeshFace::material in it to DerivationResult::materials
};

// One of the places where a prototype stands: its faces belong to the lot's mesh, or to an object's, as if they were written out there.
struct ModelInstance {
	uint32_t prototype = 0; // in DerivationResult::prototypes
	int32_t object = -1; // -1 = the lot itself
	// From the file's coordinates to those of that mesh: scaled (each axis for itself, not mirrored), turned, moved.
	glm::dmat3 axes{ 1.0 };
	glm::dvec3 origin{ 0.0 };
};

struct DerivationResult {
	Mesh mesh; // without the objects and the instances
	std::vector<Material> materials; // of all meshes
	std::vector<ModelPrototype> prototypes; // in order of their first use
	std::vector<ModelInstance> instances;
	std::vector<ModelEntrance> entrances;
	std::vector<ModelZone> zones;
	std::vector<ModelObject> objects;
	std::vector<ModelReport> reports; // one for each key and type of value, in order of their first use
	std::vector<std::string> prints;
	Diagnostics diagnostics;
	uint64_t shape_count = 0; // all, leaves included
	uint64_t leaf_count = 0;
	uint64_t face_count = 0; // of all meshes and instances
	uint64_t vertex_count = 0; // of the mesh and its instances, not of objects; those that faces of a leaf share count once. 0: not counted
};

class Occluders;

// What the derivation of one initial shape may ask about others (CGA reference: inter queries).
struct Neighbors {
	// One for each initial shape of the scene, in an order that stays the same; nullptr: not known.
	std::span<const std::shared_ptr<const Occluders>> all;
	size_t self = SIZE_MAX; // the asking shape's own, left out
};

// Never fails: bad input gives diagnostics and as much of a model as could be made. Safe to call from several threads with one program.
DerivationResult derive(const Program &program, const InitialShape &shape, const DeriveOptions &options = {});

// For many lots: keeps the interpreter and its memory between them. One per thread; the program outlives it.
class Deriver {
public:
	explicit Deriver(const Program &program, const DeriveOptions &options = {});
	~Deriver();
	Deriver(const Deriver &) = delete;
	Deriver &operator=(const Deriver &) = delete;

	DerivationResult derive(const InitialShape &shape, const Neighbors &neighbors = {});
	// What its neighbours see of it: a derivation in which queries about other initial shapes answer false, 0 or infinity.
	std::shared_ptr<const Occluders> occluders(const InitialShape &shape);

private:
	struct State;
	std::unique_ptr<State> _state;
};

} // namespace pcg::cga
