#pragma once

#include <godot_cpp/classes/node3d.hpp>

// What a node class of an extension needs: properties, signals, methods, virtuals, notifications, dynamic properties.
class ProbeNode : public godot::Node3D {
	GDCLASS(ProbeNode, godot::Node3D)

public:
	enum Mode { MODE_IDLE, MODE_BUSY };
	enum Parts { PART_ARM = 1, PART_LEG = 2 };
	enum { LIMIT = 7 };

	void set_speed(double p_speed);
	double get_speed() const { return _speed; }
	void set_mode(Mode p_mode) { _mode = p_mode; }
	Mode get_mode() const { return _mode; }
	void set_parts(godot::BitField<ProbeNode::Parts> p_parts) { _parts = p_parts; }
	godot::BitField<ProbeNode::Parts> get_parts() const { return _parts; }
	void set_slot(int p_index, int p_value);
	int get_slot(int p_index) const;
	godot::String describe(const godot::String &p_prefix, int p_times, bool p_loud) const;
	static int add(int p_a, int p_b) { return p_a + p_b; }
	int get_ready_count() const { return _ready_count; }
	godot::PackedStringArray get_heard() const { return _heard; }
	double get_processed() const { return _processed; }
	// One engine object of ours is alive for each.
	static int get_alive() { return _alive; }

	void _ready() override;
	void _process(double p_delta) override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	ProbeNode();
	~ProbeNode() override;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	bool _set(const godot::StringName &p_name, const godot::Variant &p_value);
	bool _get(const godot::StringName &p_name, godot::Variant &r_value) const;
	void _get_property_list(godot::List<godot::PropertyInfo> *p_list) const;
	bool _property_can_revert(const godot::StringName &p_name) const;
	bool _property_get_revert(const godot::StringName &p_name, godot::Variant &r_value) const;
	void _validate_property(godot::PropertyInfo &p_property) const;
	godot::String _to_string() const;

	godot::PackedStringArray _heard;

private:
	double _speed = 1.5;
	double _processed = 0;
	Mode _mode = MODE_IDLE;
	godot::BitField<Parts> _parts = 0;
	int _slots[2] = {0, 0};
	godot::Variant _dynamic;
	int _ready_count = 0;
	static int _alive;
};

VARIANT_ENUM_CAST(ProbeNode::Mode);
VARIANT_BITFIELD_CAST(ProbeNode::Parts);

// A class of ours on top of a class of ours.
class ProbeChild : public ProbeNode {
	GDCLASS(ProbeChild, ProbeNode)

public:
	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);
};

class ProbeShape : public godot::RefCounted {
	GDCLASS(ProbeShape, godot::RefCounted)

public:
	virtual double area() const = 0;

protected:
	static void _bind_methods();
};

class ProbeCircle : public ProbeShape {
	GDCLASS(ProbeCircle, ProbeShape)

public:
	double area() const override { return 3.0; }

protected:
	static void _bind_methods() {}
};

class ProbeRuntimeNode : public godot::Node {
	GDCLASS(ProbeRuntimeNode, godot::Node)

protected:
	static void _bind_methods() {}
};
