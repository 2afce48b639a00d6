#include "godot/resources/pcg_lot_type.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

void PCGLotType::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_type", "type"), &PCGLotType::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &PCGLotType::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "type"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_weight", "weight"), &PCGLotType::set_weight);
	ClassDB::bind_method(D_METHOD("get_weight"), &PCGLotType::get_weight);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "weight", PROPERTY_HINT_RANGE, "0,100,0.1,or_greater"), "set_weight", "get_weight");
	ClassDB::bind_method(D_METHOD("set_weight_map", "map"), &PCGLotType::set_weight_map);
	ClassDB::bind_method(D_METHOD("get_weight_map"), &PCGLotType::get_weight_map);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "weight_map", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"), "set_weight_map", "get_weight_map");
	ClassDB::bind_method(D_METHOD("set_rules", "rules"), &PCGLotType::set_rules);
	ClassDB::bind_method(D_METHOD("get_rules"), &PCGLotType::get_rules);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "rules", PROPERTY_HINT_RESOURCE_TYPE, "PCGRuleSet"), "set_rules", "get_rules");
	ClassDB::bind_method(D_METHOD("set_start_rule", "rule"), &PCGLotType::set_start_rule);
	ClassDB::bind_method(D_METHOD("get_start_rule"), &PCGLotType::get_start_rule);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "start_rule"), "set_start_rule", "get_start_rule");
	ClassDB::bind_method(D_METHOD("set_attributes", "attributes"), &PCGLotType::set_attributes);
	ClassDB::bind_method(D_METHOD("get_attributes"), &PCGLotType::get_attributes);
	ADD_PROPERTY(PropertyInfo(Variant::DICTIONARY, "attributes"), "set_attributes", "get_attributes");
}

void PCGLotType::set_type(const String &p_type) {
	_type = p_type;
	emit_changed();
}

void PCGLotType::set_weight(double p_weight) {
	ERR_FAIL_COND_MSG(!(p_weight >= 0.0), "PCGLotType: a weight is 0 or more; it is relative to the weights of the other lot types.");
	_weight = p_weight;
	emit_changed();
}

void PCGLotType::set_weight_map(const Ref<Texture2D> &p_map) {
	_weight_map = p_map;
	emit_changed();
}

std::shared_ptr<const WeightMap> PCGLotType::weight_map(Diagnostics &diagnostics) const {
	if (_weight_map.is_null()) {
		return nullptr;
	}
	const Ref<Image> source = _weight_map->get_image();
	Ref<Image> image = source.is_valid() ? Ref<Image>(source->duplicate()) : source;
	if (image.is_null() || image->is_empty() || (image->is_compressed() && image->decompress() != OK)) {
		diagnostics.error("bad-land-use", "the weight map of lot type \"" + from_godot(_type) + "\" has no picture", "give it an image, or none; a NoiseTexture2D is drawn a little after it is made and then sends \"changed\": generate after that");
		return nullptr;
	}
	image->convert(Image::FORMAT_L8);
	const PackedByteArray pixels = image->get_data();
	WeightMap map{ uint32_t(image->get_width()), uint32_t(image->get_height()), {} };
	for (size_t i = 0; i < size_t(map.width) * map.height; ++i) { // smaller copies of the picture may follow
		map.values.push_back(float(pixels[int64_t(i)]) / 255.0f);
	}
	return std::make_shared<const WeightMap>(std::move(map));
}

void PCGLotType::set_rules(const Ref<PCGRuleSet> &p_rules) {
	const godot::Callable on_change = callable_mp(static_cast<Resource *>(this), &Resource::emit_changed);
	if (_rules.is_valid()) {
		_rules->disconnect("changed", on_change);
	}
	_rules = p_rules;
	if (_rules.is_valid()) {
		_rules->connect("changed", on_change);
	}
	emit_changed();
}

void PCGLotType::set_start_rule(const String &p_rule) {
	_start_rule = p_rule;
	emit_changed();
}

void PCGLotType::set_attributes(const Dictionary &p_attributes) {
	_attributes = p_attributes;
	emit_changed();
}

} // namespace pcg
