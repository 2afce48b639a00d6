#pragma once

#include <memory>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

#include "core/city/land_use.h"
#include "godot/resources/pcg_rule_set.h"

namespace pcg {

// One kind of lot: its share of the city, and the rules that build it.
class PCGLotType : public godot::Resource {
	GDCLASS(PCGLotType, godot::Resource)

public:
	void set_type(const godot::String &p_type);
	godot::String get_type() const { return _type; }
	void set_weight(double p_weight);
	double get_weight() const { return _weight; }
	void set_weight_map(const godot::Ref<godot::Texture2D> &p_map);
	godot::Ref<godot::Texture2D> get_weight_map() const { return _weight_map; }
	// Null without a map, or, after a message, if it has no picture.
	std::shared_ptr<const WeightMap> weight_map(Diagnostics &diagnostics) const;
	void set_rules(const godot::Ref<PCGRuleSet> &p_rules);
	godot::Ref<PCGRuleSet> get_rules() const { return _rules; }
	void set_start_rule(const godot::String &p_rule);
	godot::String get_start_rule() const { return _start_rule; }
	void set_attributes(const godot::Dictionary &p_attributes);
	godot::Dictionary get_attributes() const { return _attributes; }

protected:
	static void _bind_methods();

private:
	godot::String _type;
	double _weight = 1.0;
	godot::Ref<godot::Texture2D> _weight_map;
	godot::Ref<PCGRuleSet> _rules;
	godot::String _start_rule;
	godot::Dictionary _attributes;
};

} // namespace pcg
