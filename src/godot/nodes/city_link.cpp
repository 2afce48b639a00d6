#include "godot/nodes/city_link.h"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "godot/nodes/pcg_city.h"
#include "godot/nodes/pcg_entrance.h"
#include "godot/nodes/pcg_lot.h"
#include "godot/nodes/pcg_object.h"
#include "godot/nodes/pcg_zone.h"

using namespace godot;

namespace pcg {

namespace {

PCGCity *city_above(Node *node) {
	for (Node *parent = node->get_parent(); parent != nullptr; parent = parent->get_parent()) {
		if (PCGCity *city = Object::cast_to<PCGCity>(parent)) {
			return city;
		}
	}
	return nullptr;
}

PCGCity *city_around(Node3D *node) {
	const TypedArray<Node> cities = node->get_tree()->get_nodes_in_group(PCGCity::group);
	for (int64_t i = 0; i < cities.size(); ++i) {
		PCGCity *city = Object::cast_to<PCGCity>(Object::cast_to<Node>(cities[i]));
		if (city && city->has_ground_at(node->get_global_transform().get_origin())) {
			return city;
		}
	}
	return nullptr;
}

} // namespace

CityLink *CityLink::of(Node *node) {
	if (PCGLot *lot = Object::cast_to<PCGLot>(node)) {
		return &lot->link();
	}
	if (PCGEntrance *entrance = Object::cast_to<PCGEntrance>(node)) {
		return &entrance->link();
	}
	if (PCGZone *zone = Object::cast_to<PCGZone>(node)) {
		return &zone->link();
	}
	PCGObject *object = Object::cast_to<PCGObject>(node);
	return object ? &object->link() : nullptr;
}

PCGCity *CityLink::city() const { return Object::cast_to<PCGCity>(ObjectDB::get_instance(_city)); }

void CityLink::find_city(Node3D *node) {
	PCGCity *found = city_above(node);
	found = found ? found : city_around(node);
	if (PCGCity *before = city(); before && before != found) {
		before->note_edit(node);
	}
	_city = found ? found->get_instance_id() : 0;
	if (found) {
		found->note_edit(node);
	}
	if (node->is_in_group(lost_group) != (found == nullptr)) {
		found ? node->remove_from_group(lost_group) : node->add_to_group(lost_group);
		node->update_configuration_warnings();
	}
}

void CityLink::notify(Node3D *node, int what) {
	switch (what) {
		case Node::NOTIFICATION_ENTER_TREE:
			node->set_notify_transform(true);
			find_city(node);
			break;
		case Node3D::NOTIFICATION_TRANSFORM_CHANGED: // perhaps onto the ground of a city
			node->is_in_group(lost_group) ? find_city(node) : note_change(node);
			break;
		case Node::NOTIFICATION_EXIT_TREE: note_change(node); break;
		default: break;
	}
}

void CityLink::warn(const Node3D *node, PackedStringArray &warnings) {
	if (node->is_in_group(lost_group)) {
		warnings.push_back("This node belongs to no city. Put it below a PCGCity, or where one has its ground.");
	}
}

void CityLink::note_change(Node3D *node) const {
	if (PCGCity *owner = city()) {
		owner->note_edit(node);
	}
}

} // namespace pcg
