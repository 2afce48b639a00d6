// The part of PCGAgentView that deals with scenes: who has one, where it stands, who moved it.
#include <cmath>

#include <godot_cpp/classes/navigation_server3d.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include "godot/convert.h"
#include "godot/convert_looks.h"
#include "godot/nodes/pcg_agent_view.h"

using namespace godot;

namespace pcg {

namespace {

constexpr double fastest_steering = 3.0; // times real time; beyond it avoidance comes too late, and people glide along their paths
constexpr float fastest_walk = 1.7f; // times the natural speed
constexpr float was_pushed = 0.01f; // metres
constexpr float same_velocity = 0.1f; // m/s

NavigationAgent3D *find_steering(Node *root) {
	for (int i = 0; i < root->get_child_count(); ++i) {
		NavigationAgent3D *steering = Object::cast_to<NavigationAgent3D>(root->get_child(i));
		if (steering && steering->get_avoidance_enabled()) {
			return steering;
		}
	}
	return nullptr;
}

// Godot's nodes look along -z.
Transform3D frame_of(const Body &body) {
	const Vector3 back = to_godot(-body.facing);
	return Transform3D(Basis(Vector3(back.z, 0, -back.x), Vector3(0, 1, 0), back), to_godot(body.position));
}

} // namespace

bool PCGAgentView::may_steer(double scale) const { return scale > 0.0 && scale <= fastest_steering; }

// Before the crowd moves on: where scenes are that moved, or were moved, since the last picture.
void PCGAgentView::take_moves(double seconds) {
	const Basis to_local = get_global_transform().basis.inverse();
	for (const Agent &agent : _agents) {
		const uint32_t slot = _crowd->slot_of(agent.person);
		if (slot == Crowd::no_slot) {
			continue;
		}
		const Vector3 position = agent.root->get_position();
		const bool is_steered = _crowd->body(slot).moves_itself && !agent.link->get_moves_itself() && agent.steering;
		if (is_steered) {
			_crowd->move_agent(slot, from_godot(position + to_local.xform(agent.link->safe_velocity()) * seconds));
		} else if (position.distance_squared_to(agent.frame.origin) > was_pushed * was_pushed) {
			_crowd->move_agent(slot, from_godot(position));
		}
	}
}

void PCGAgentView::move_scenes(double scale) {
	for (size_t i = _agents.size(); i-- > 0;) {
		const uint32_t slot = _crowd->slot_of(_agents[i].person);
		if (slot == Crowd::no_slot || !_crowd->body(slot).has_scene) { // also one who went in and came out again meanwhile
			remove_scene(i);
		}
	}
	for (const uint32_t slot : _crowd->new_agents()) {
		add_scene(slot);
	}
	const Basis basis = get_global_transform().basis;
	NavigationServer3D *server = NavigationServer3D::get_singleton();
	for (Agent &agent : _agents) {
		const uint32_t slot = _crowd->slot_of(agent.person);
		const Body &body = _crowd->body(slot);
		place_scene(agent, body);
		const bool is_steered = agent.steering && may_steer(scale);
		const Vector3 wish = basis.xform(to_godot(body.velocity)) * scale;
		agent.link->set_velocity(wish);
		const float fastest = body.natural_speed * fastest_walk * float(scale);
		if (is_steered && std::abs(fastest - agent.fastest) > 0.1f * fastest) {
			server->agent_set_max_speed(agent.steering->get_rid(), fastest); // else it would leap aside where people come out of one door
			agent.fastest = fastest;
		}
		if (is_steered && wish.distance_squared_to(agent.wish) > same_velocity * same_velocity) {
			server->agent_set_velocity(agent.steering->get_rid(), wish); // the node passes velocities on only where it has a target, too
			agent.wish = wish;
		}
		_crowd->set_scene(slot, is_steered || agent.link->get_moves_itself(), agent.link->get_shows_figure());
	}
}

// A scene that moves itself is left where it is, unless it was stuck or everybody was put elsewhere.
void PCGAgentView::place_scene(Agent &agent, const Body &body) {
	agent.link->set_pose(body.shown_pose);
	if (agent.link->get_moves_itself() && !body.was_placed) {
		agent.frame.origin = agent.root->get_position();
		return;
	}
	const Transform3D frame = frame_of(body);
	if (frame != agent.frame) {
		agent.root->set_transform(frame);
		agent.frame = frame;
	}
}

void PCGAgentView::add_scene(uint32_t slot) {
	PCGAgent *link = _pool.take();
	if (!link) {
		_crowd->lose_scene(slot);
		return;
	}
	const Body &body = _crowd->body(slot);
	Agent agent;
	agent.person = body.person;
	agent.link = link;
	agent.root = link->root();
	agent.steering = find_steering(agent.root);
	agent.frame = frame_of(body);
	agent.root->set_transform(agent.frame);
	add_child(agent.root);
	if (agent.steering) {
		const godot::Callable answer = callable_mp(link, &PCGAgent::set_safe_velocity);
		if (!agent.steering->is_connected("velocity_computed", answer)) {
			agent.steering->connect("velocity_computed", answer);
		}
		NavigationServer3D::get_singleton()->agent_set_velocity(agent.steering->get_rid(), Vector3());
	}
	_agents.push_back(agent);
	_crowd->set_scene(slot, false, link->get_shows_figure());
	link->assign(int(index_of(body.person)), to_godot(_crowd->population(), body.person, body.looks), [this, link] { lose_scene(link); });
}

// Back to the pool.
void PCGAgentView::remove_scene(size_t index) {
	const Agent agent = _agents[index];
	_agents[index] = _agents.back();
	_agents.pop_back();
	const uint32_t slot = _crowd->slot_of(agent.person);
	if (slot != Crowd::no_slot && _crowd->body(slot).has_scene) {
		_crowd->lose_scene(slot);
	}
	agent.link->release();
	remove_child(agent.root);
	_pool.give_back(agent.link);
}

// The game freed it, or took it for itself.
void PCGAgentView::lose_scene(PCGAgent *link) {
	for (size_t i = 0; i < _agents.size(); ++i) {
		if (_agents[i].link == link) {
			const uint32_t slot = _crowd ? _crowd->slot_of(_agents[i].person) : Crowd::no_slot;
			_agents[i] = _agents.back();
			_agents.pop_back();
			if (slot != Crowd::no_slot) {
				_crowd->lose_scene(slot);
			}
			return;
		}
	}
}

// When this node leaves the tree its scenes leave it first, and are lost; nobody would ever take them again.
void PCGAgentView::free_lost_scenes() {
	for (int i = get_child_count() - 1; i >= 0; --i) {
		Node *root = get_child(i);
		for (int j = 0; j < root->get_child_count(); ++j) {
			if (Object::cast_to<PCGAgent>(root->get_child(j))) {
				root->queue_free();
			}
		}
	}
}

} // namespace pcg
