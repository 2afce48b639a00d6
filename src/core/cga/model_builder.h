#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/cga/derivation.h"
#include "core/cga/instance_table.h"
#include "core/cga/level_order.h"
#include "core/cga/material_table.h"
#include "core/cga/shape.h"
#include "core/geometry/shared_mesh.h"
#include "core/lang/value.h"

namespace pcg::cga {

// Collects what a derivation makes, in world coordinates.
class ModelBuilder {
public:
	void begin(const Lot &lot, bool counts_vertices = false);
	DerivationResult take();
	DerivationResult &result() { return _result; }

	// The faces of a leaf, to the lot's mesh or to its object's; a model from a file becomes an instance where it can.
	void add_leaf(const Shape &shape);
	// `geometry` is a model from a file, turned by `turn`. It lives as long as this.
	void add_model(const Geometry &geometry, const glm::dmat3 &turn, SharedMesh &shown);
	// Index of the new object, whose frame stands in the middle of the floor of the shape's scope.
	int32_t begin_object(std::string_view tag, const Shape &shape);
	void add_entrance(std::string_view type, const Shape &shape, double capacity);
	// A scope flat in one axis is raised along it by `flat_height`.
	void add_zone(std::string_view type, const Shape &shape, double flat_height);
	// False: the shape belongs to no object.
	bool add_place(const Shape &shape);
	MaterialTable &materials() { return _materials; }
	// `depth` of the shape that says it.
	void add_report(const Text &key, const Value &value, uint32_t depth); // a number, a truth value or a text
	void add_print(std::string line, uint32_t depth); // the first ten thousand are kept

private:
	// Of the mesh of the last model: the next one is likely to be as large.
	struct MeshSize {
		size_t positions = 0, loops = 0, faces = 0;
		std::array<size_t, uv_set_count> uvs = {};
	};
	// Where the last report of a text of the program stands, if the model has one.
	struct ReportPlace {
		uint64_t model = 0;
		size_t index = 0;
	};

	static MeshSize size_of(const Mesh &mesh);
	Frame target_frame(const Shape &shape) const;
	uint32_t count_vertices(const Geometry &geometry);
	bool add_face(Mesh &mesh, const Geometry &geometry, const GeometryFace &face, uint32_t material);
	template <typename MaterialOf> void add_faces(Mesh &mesh, const Shape &shape, const Frame &to_target, MaterialOf material_of);
	Mesh make_shown(const Geometry &geometry, const glm::dmat3 &turn);
	void add_corner_data(Mesh &mesh, const Shape &shape, const GeometryFace &face, const Frame &to_target);
	ModelReport &find_report(const Text &key, ValueType type);
	// `low` and `high` bound the object in its frame.
	void add_default_places(ModelObject &object, const Frame &frame, glm::dvec3 low, glm::dvec3 high);
	glm::vec3 to_world(glm::dvec3 point) const { return glm::vec3(point + _lot.origin); }

	Lot _lot;
	DerivationResult _result;
	std::vector<Frame> _object_frames; // in the derivation's coordinates
	MaterialTable _materials;
	InstanceTable _instances;
	std::vector<glm::dvec3> _points; // of the present leaf, in the coordinates of its mesh
	std::vector<glm::vec3> _shown_points; // the same
	MeshSize _expected;
	uint64_t _model = 0; // counts them
	bool _counts_vertices = false;
	std::unordered_map<const Geometry *, uint32_t> _vertices_of; // models from files, in this derivation
	std::vector<ReportPlace> _report_places; // by symbol
	LevelOrder _report_order, _print_order;
};

} // namespace pcg::cga
