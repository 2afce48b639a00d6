#pragma once

#include <vector>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "godot/nodes/city_link.h"

namespace pcg {

// One lot of a city with what grew on it. Its geometry is the child "Geometry"; what has meaning are further children.
class PCGLot : public godot::Node3D {
	GDCLASS(PCGLot, godot::Node3D)

public:
	void set_lot_id(int p_id);
	int get_lot_id() const { return _link.id(); }
	void set_block_id(int p_id) { _block_id = p_id; }
	int get_block_id() const { return _block_id; }
	void set_type(const godot::String &p_type) { _type = p_type; }
	godot::String get_type() const { return _type; }
	void set_polygon(const godot::PackedVector3Array &p_polygon) { _polygon = p_polygon; }
	godot::PackedVector3Array get_polygon() const { return _polygon; }
	void set_holes(const godot::TypedArray<godot::PackedVector3Array> &p_holes) { _holes = p_holes; }
	godot::TypedArray<godot::PackedVector3Array> get_holes() const { return _holes; }

	// Other lots that stand on the same ground, and how many square metres of it; the city says so.
	struct Overlap {
		uint64_t object = 0;
		double area = 0.0;

		friend bool operator==(const Overlap &, const Overlap &) = default;
	};
	void set_overlaps(std::vector<Overlap> overlaps);
	godot::TypedArray<PCGLot> get_overlapping_lots() const;
	// "Lot12 (house)", for messages.
	godot::String title() const;
	godot::PackedStringArray _get_configuration_warnings() const override;

	CityLink &link() { return _link; }

protected:
	static void _bind_methods();
	void _notification(int p_what) { _link.notify(this, p_what); }

private:
	CityLink _link{ CityLink::Kind::Lot };
	int _block_id = -1;
	godot::String _type;
	godot::PackedVector3Array _polygon;
	godot::TypedArray<godot::PackedVector3Array> _holes;
	std::vector<Overlap> _overlaps;
};

} // namespace pcg
