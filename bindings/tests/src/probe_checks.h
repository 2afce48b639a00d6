#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>

// Checks that only C++ can make. Each run_... returns the sentences that turned out false and counts the others.
class ProbeChecks : public godot::RefCounted {
	GDCLASS(ProbeChecks, godot::RefCounted)

public:
	godot::PackedStringArray run_strings();
	godot::PackedStringArray run_containers();
	godot::PackedStringArray run_variants();
	godot::PackedStringArray run_math();
	godot::PackedStringArray run_math_against_engine();
	godot::PackedStringArray run_objects();
	godot::PackedStringArray run_references();
	godot::PackedStringArray run_callables();
	godot::PackedStringArray run_engine_calls();
	godot::PackedStringArray run_errors();
	int get_passed() const { return _passed; }
	// The C++ object behind an engine object, as a number.
	uint64_t wrapper_of(godot::Object *p_object) const { return reinterpret_cast<uint64_t>(p_object); }
	int reference_count_of(const godot::Ref<godot::RefCounted> &p_object) const {
		return p_object->get_reference_count();
	}
	void churn(int p_count);

	void on_called(int p_value, const godot::String &p_text);
	int on_asked(int p_value) const { return p_value * 2; }
	static godot::String on_static(const godot::String &p_text) { return p_text + "!"; }

protected:
	static void _bind_methods();

private:
	void check(bool p_true, const char *p_sentence);
	void error_paths(const void *p_expected_null);
	int guarded(int p_expected_index);

	godot::PackedStringArray _failed;
	int _passed = 0;
	int _called_with = 0;
	godot::String _called_text;
};
