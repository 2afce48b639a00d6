#include "godot/resources/pcg_district.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

void PCGDistrict::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_area", "area"), &PCGDistrict::set_area);
	ClassDB::bind_method(D_METHOD("get_area"), &PCGDistrict::get_area);
	ADD_PROPERTY(PropertyInfo(Variant::RECT2, "area"), "set_area", "get_area");
	ClassDB::bind_method(D_METHOD("set_weights", "weights"), &PCGDistrict::set_weights);
	ClassDB::bind_method(D_METHOD("get_weights"), &PCGDistrict::get_weights);
	ADD_PROPERTY(PropertyInfo(Variant::DICTIONARY, "weights"), "set_weights", "get_weights");
}

void PCGDistrict::set_area(const Rect2 &p_area) {
	ERR_FAIL_COND_MSG(!(p_area.size.x > 0.0f && p_area.size.y > 0.0f), "PCGDistrict: an area has a width and a height above 0, as parts of the city.");
	_area = p_area;
	emit_changed();
}

void PCGDistrict::set_weights(const Dictionary &p_weights) {
	const Array weights = p_weights.values();
	for (int64_t i = 0; i < weights.size(); ++i) {
		const Variant::Type type = weights[i].get_type();
		ERR_FAIL_COND_MSG((type != Variant::INT && type != Variant::FLOAT) || !(double(weights[i]) >= 0.0),
				"PCGDistrict: weights are numbers that are 0 or more, by the name of the lot type.");
	}
	_weights = p_weights;
	emit_changed();
}

District PCGDistrict::to_core() const {
	District district;
	district.min = { _area.position.x, _area.position.y };
	district.max = { _area.position.x + _area.size.x, _area.position.y + _area.size.y };
	const Array names = _weights.keys();
	for (int64_t i = 0; i < names.size(); ++i) {
		district.uses.push_back({ from_godot(String(names[i])), double(_weights[names[i]]) });
	}
	return district;
}

} // namespace pcg
