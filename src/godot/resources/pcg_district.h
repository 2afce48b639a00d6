#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/rect2.hpp>

#include "core/city/land_use.h"

namespace pcg {

// A part of a city with shares of lot types of its own.
class PCGDistrict : public godot::Resource {
	GDCLASS(PCGDistrict, godot::Resource)

public:
	void set_area(const godot::Rect2 &p_area);
	godot::Rect2 get_area() const { return _area; }
	void set_weights(const godot::Dictionary &p_weights);
	godot::Dictionary get_weights() const { return _weights; }

	District to_core() const;

protected:
	static void _bind_methods();

private:
	godot::Rect2 _area = godot::Rect2(0, 0, 1, 1);
	godot::Dictionary _weights;
};

} // namespace pcg
