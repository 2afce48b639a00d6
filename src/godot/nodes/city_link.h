#pragma once

#include <cstddef>
#include <cstdint>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace pcg {

class PCGCity;

// The tie between a node that means something (a lot, an entrance, a zone, an object) and the city that it belongs to: the PCGCity above it, else the one
// in the tree whose ground it stands on. Whatever happens to the node is noted there.
class CityLink {
public:
	enum class Kind : uint8_t { Lot, Entrance, Zone, Object };
	static constexpr size_t kind_count = size_t(Kind::Object) + 1;

	explicit CityLink(Kind kind) : _kind(kind) {}
	Kind kind() const { return _kind; }
	// Which record in the city's model is the node's, or which lot of its layout; -1 = none yet. Stored with the scene.
	int id() const { return _id; }
	void set_id(int id) { _id = id; }

	// For the node's _notification().
	void notify(godot::Node3D *node, int what);
	// A property that the model knows of was set.
	void note_change(godot::Node3D *node) const;
	// Of a node that has one; else null.
	static CityLink *of(godot::Node *node);
	// Null while the node belongs to none.
	PCGCity *city() const;
	// Again, because a city has come.
	void find_city(godot::Node3D *node);
	// For the node's _get_configuration_warnings().
	static void warn(const godot::Node3D *node, godot::PackedStringArray &warnings);

	// Nodes in the tree that belong to no city are in this group.
	static constexpr const char *lost_group = "pcg_without_city";

private:
	Kind _kind;
	int _id = -1;
	uint64_t _city = 0; // of the object
};

} // namespace pcg
