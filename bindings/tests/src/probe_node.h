#pragma once

#include <godot_cpp/classes/node3d.hpp>

// Shows what a node class of an extension needs: properties, signals, methods, virtuals, notifications.
class ProbeNode : public godot::Node3D {
	GDCLASS(ProbeNode, godot::Node3D)

public:
	enum Mode { MODE_IDLE, MODE_BUSY };

	void set_speed(double p_speed);
	double get_speed() const { return _speed; }
	void set_mode(Mode p_mode) { _mode = p_mode; }
	Mode get_mode() const { return _mode; }
	godot::String describe(const godot::String &p_prefix, int p_times, bool p_loud) const;
	static int add(int p_a, int p_b) { return p_a + p_b; }
	int get_ready_count() const { return _ready_count; }
	int get_notifications() const { return _notifications; }

	void _ready() override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	double _speed = 1.5;
	Mode _mode = MODE_IDLE;
	int _ready_count = 0;
	int _notifications = 0;
};

VARIANT_ENUM_CAST(ProbeNode::Mode);
