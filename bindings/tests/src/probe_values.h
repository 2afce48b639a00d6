#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/typed_dictionary.hpp>

// Takes a value of every type and gives it back: once as itself, once by way of a C++ Variant.
class ProbeValues : public godot::RefCounted {
	GDCLASS(ProbeValues, godot::RefCounted)

public:
	template <class T> static T echo(const T &p_value) { return godot::Variant(p_value); }
	template <class T> static T echo_number(T p_value) { return godot::Variant(p_value); }
	godot::Variant echo_variant(const godot::Variant &p_value) const { return godot::Variant(p_value); }
	godot::Node *echo_node(godot::Node *p_node) { return p_node; }
	godot::Object *echo_object(godot::Object *p_object) { return p_object; }
	godot::Ref<godot::Resource> echo_resource(const godot::Ref<godot::Resource> &p_resource) { return p_resource; }
	godot::TypedArray<godot::Node> echo_nodes(const godot::TypedArray<godot::Node> &p_nodes) { return p_nodes; }
	godot::TypedArray<godot::Vector3> echo_points(const godot::TypedArray<godot::Vector3> &p_points) {
		return p_points;
	}
	godot::TypedDictionary<godot::String, int64_t>
	echo_counts(const godot::TypedDictionary<godot::String, int64_t> &p_counts) {
		return p_counts;
	}
	godot::TypedArray<int> make_numbers() const;
	// "null" for a Node that is not one.
	godot::String name_of(godot::Node *p_node) const {
		return p_node ? godot::String(p_node->get_name()) : godot::String("null");
	}

protected:
	static void _bind_methods();
};
