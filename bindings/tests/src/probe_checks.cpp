#include "probe_checks.h"
#include "probe_loader.h"
#include "probe_node.h"

#include <godot_cpp/classes/box_mesh.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/time.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/print_string.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

using namespace godot;

void ProbeChecks::check(bool p_true, const char *p_sentence) {
	if (p_true) {
		_passed++;
	} else {
		_failed.push_back(p_sentence);
	}
}

PackedStringArray ProbeChecks::run_objects() {
	_failed.clear();
	const int alive = ProbeNode::get_alive();
	ProbeNode *node = memnew(ProbeNode);
	check(ProbeNode::get_alive() == alive + 1, "memnew makes one object");
	check(node->get_class() == "ProbeNode", "memnew of our class makes an engine object of our class");
	check(Object::cast_to<Node3D>(node) == node, "a cast to an ancestor gives the same pointer");
	check(Object::cast_to<ProbeChild>(node) == nullptr, "a cast to a descendant that it is not gives null");
	check(Object::cast_to<Mesh>(static_cast<Object *>(node)) == nullptr, "a cast to a stranger gives null");
	check(Object::cast_to<Node>(static_cast<Object *>(nullptr)) == nullptr, "a cast of null gives null");
	check(ObjectDB::get_instance(node->get_instance_id()) == node, "the id leads back to the object");
	Node *plain = node->get_child(0, true);
	check(plain && plain->get_parent() == node, "a child made in the constructor knows its parent, our object");
	check(node->get_child(0, true) == plain, "the same engine object has the same wrapper");
	Node *nested = memnew(ProbeChild);
	nested->add_child(node);
	check(nested->get_node<ProbeNode>("probe") == node && nested->get_node<ProbeChild>("probe") == nullptr,
	      "get_node<T> casts");
	const uint64_t id = node->get_instance_id();
	memdelete(nested);
	check(ObjectDB::get_instance(id) == nullptr, "a freed object's id leads nowhere");
	check(ProbeNode::get_alive() == alive, "freeing a parent frees the children, each once");
	Variant kept = memnew(Node);
	check(kept.get_validated_object() != nullptr, "a Variant knows that its object is alive");
	memdelete(kept.operator Object *());
	check(kept.get_validated_object() == nullptr, "and that it is gone");
	return _failed;
}

PackedStringArray ProbeChecks::run_references() {
	_failed.clear();
	Ref<ProbeResource> first;
	check(first.is_null() && !first.is_valid(), "a new Ref is null");
	first.instantiate();
	check(first->get_reference_count() == 1, "instantiate gives one reference");
	Ref<ProbeResource> second = first;
	check(first->get_reference_count() == 2 && first == second, "a copy adds one");
	Ref<Resource> base = first;
	check(base->get_reference_count() == 3 && base.ptr() == first.ptr(), "a Ref of an ancestor adds one");
	Ref<ProbeResource> back = base;
	check(back == first, "and leads back by a cast");
	Ref<ProbeCircle> stranger = base;
	check(stranger.is_null(), "a Ref of a stranger is null");
	back.unref();
	base = Ref<Resource>();
	second = Ref<ProbeResource>(nullptr);
	check(first->get_reference_count() == 1, "all that went took theirs along");
	{
		Variant variant = first;
		Array array;
		array.push_back(first);
		check(first->get_reference_count() == 3, "a Variant and an Array hold one each");
		Ref<ProbeResource> out = array[0];
		check(out == first && variant == Variant(first), "and give the object back");
	}
	check(first->get_reference_count() == 1, "and let go");
	Ref<ProbeResource> moved = std::move(first);
	check(moved->get_reference_count() == 1 && first.is_null(), "moving counts nothing");
	Ref<ProbeResource> raw(memnew(ProbeResource));
	check(raw->get_reference_count() == 1, "a Ref of a new pointer takes its one reference over");
	Ref<ProbeShape> circle(memnew(ProbeCircle));
	check(circle->area() == 3.0, "a virtual function of C++ works through a Ref of an abstract class");
	Ref<BoxMesh> box;
	box.instantiate();
	check(box->get_class() == "BoxMesh" && box->get_reference_count() == 1, "an engine class can be instantiated too");
	return _failed;
}

PackedStringArray ProbeChecks::run_callables() {
	_failed.clear();
	Callable method = callable_mp(this, &ProbeChecks::on_called);
	method.call(7, "text");
	check(_called_with == 7 && _called_text == "text", "callable_mp calls the method");
	check(callable_mp(this, &ProbeChecks::on_asked).call(21) == Variant(42), "and returns its value");
	check(callable_mp_static(&ProbeChecks::on_static).call("hey") == Variant("hey!"), "callable_mp_static too");
	check(method == callable_mp(this, &ProbeChecks::on_called), "two Callables of one method are equal");
	check(method != callable_mp(this, &ProbeChecks::on_asked), "of two methods they are not");
	check(method.get_object() == this && method.is_valid(), "it knows its object");
	check(method.get_argument_count() == 2, "it knows its number of arguments");
	method.bind("bound").call(8);
	check(_called_with == 8 && _called_text == "bound", "bind adds arguments");
	Callable by_name(this, "get_passed");
	check(by_name.call().get_type() == Variant::INT, "a Callable by name works as well");
	ProbeNode *node = memnew(ProbeNode);
	node->connect("speed_changed", callable_mp(this, &ProbeChecks::on_called).bind("signalled").unbind(1));
	node->set_speed(9.0);
	check(_called_with == 9 && _called_text == "signalled", "a signal can be connected to it");
	Callable of_the_dead = callable_mp(static_cast<Node *>(node), &Node::get_child_count);
	memdelete(node);
	check(!of_the_dead.is_valid(), "a Callable of a freed object is not valid");
	return _failed;
}

PackedStringArray ProbeChecks::run_engine_calls() {
	_failed.clear();
	Engine *engine = Engine::get_singleton();
	check(engine && engine == Engine::get_singleton(), "a singleton has one wrapper");
	check(int(engine->get_version_info()["major"]) == 4, "a Dictionary comes back");
	check(OS::get_singleton()->has_feature("linux") || OS::get_singleton()->get_name() != "Linux", "a bool comes back");
	check(Time::get_singleton()->get_ticks_usec() > 0, "a number comes back");
	check(ProjectSettings::get_singleton()->get_setting("no/such", 5) == Variant(5),
	      "a default argument of type Variant");
	SceneTree *tree = Object::cast_to<SceneTree>(engine->get_main_loop());
	check(tree != nullptr, "an object comes back as its own class");
	Node *node = memnew(Node);
	check(node->call("get_child_count", true) == Variant(0), "call with arguments");
	node->set("name", "renamed");
	check(node->get_name() == StringName("renamed"), "set by name");
	check(node->has_method("queue_free") && !node->has_method("nothing"), "has_method");
	check(node->emit_signal("renamed") == ERR_UNAVAILABLE, "emit_signal gives an Error: here that nobody listens");
	memdelete(node);
	Ref<BoxMesh> box;
	box.instantiate();
	box->set_size(Vector3(1, 2, 3));
	check(box->get_aabb().size == Vector3(1, 2, 3), "math types cross by value");
	check(UtilityFunctions::maxi(3, 4) == 4 && UtilityFunctions::str("a", 1, true) == "a1true", "utility functions");
	return _failed;
}

void ProbeChecks::error_paths(const void *p_expected_null) {
	ERR_FAIL_NULL(p_expected_null);
	_called_with = -1;
}

int ProbeChecks::guarded(int p_expected_index) {
	ERR_FAIL_INDEX_V(p_expected_index, 3, -5);
	return p_expected_index;
}

PackedStringArray ProbeChecks::run_errors() {
	_failed.clear();
	_called_with = 0;
	error_paths(nullptr);
	check(_called_with == 0, "ERR_FAIL_NULL leaves the function");
	check(guarded(3) == -5 && guarded(2) == 2, "ERR_FAIL_INDEX_V returns its value only when out of bounds");
	int rounds = 0;
	for (int expected = 0; expected < 3; expected++) {
		ERR_CONTINUE_MSG(expected == 1, String("a String, [expected] ") + itos(expected));
		rounds++;
	}
	check(rounds == 2, "ERR_CONTINUE goes on with the loop");
	ERR_PRINT("[expected] an error");
	WARN_PRINT(vformat("[expected] a warning of %s", "C++"));
	WARN_PRINT_ONCE("[expected] once");
	return _failed;
}

void ProbeChecks::churn(int p_count) {
	for (int i = 0; i < p_count; i++) {
		Ref<ProbeResource> resource;
		resource.instantiate();
		resource->set_text(itos(i));
		Variant held = resource;
		ProbeNode *node = memnew(ProbeNode);
		node->set_meta("resource", held);
		Dictionary dictionary;
		dictionary["node"] = node;
		dictionary["callable"] = callable_mp(node, &ProbeNode::get_speed);
		memdelete(node);
	}
}

void ProbeChecks::on_called(int p_value, const String &p_text) {
	_called_with = p_value;
	_called_text = p_text;
}

void ProbeChecks::_bind_methods() {
#define BIND_RUN(m_name) ClassDB::bind_method(D_METHOD(#m_name), &ProbeChecks::m_name)
	BIND_RUN(run_strings);
	BIND_RUN(run_containers);
	BIND_RUN(run_variants);
	BIND_RUN(run_math);
	BIND_RUN(run_math_against_engine);
	BIND_RUN(run_objects);
	BIND_RUN(run_references);
	BIND_RUN(run_callables);
	BIND_RUN(run_engine_calls);
	BIND_RUN(run_errors);
#undef BIND_RUN
	ClassDB::bind_method(D_METHOD("get_passed"), &ProbeChecks::get_passed);
	ClassDB::bind_method(D_METHOD("wrapper_of", "object"), &ProbeChecks::wrapper_of);
	ClassDB::bind_method(D_METHOD("reference_count_of", "object"), &ProbeChecks::reference_count_of);
	ClassDB::bind_method(D_METHOD("churn", "count"), &ProbeChecks::churn);
}
