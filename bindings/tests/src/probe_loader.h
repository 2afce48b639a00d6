#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/resource_format_loader.hpp>
#include <godot_cpp/classes/resource_format_saver.hpp>

// A text file `*.probe` as a resource.
class ProbeResource : public godot::Resource {
	GDCLASS(ProbeResource, godot::Resource)

public:
	void set_text(const godot::String &p_text);
	godot::String get_text() const { return _text; }

protected:
	static void _bind_methods();

private:
	godot::String _text;
};

class ProbeLoader : public godot::ResourceFormatLoader {
	GDCLASS(ProbeLoader, godot::ResourceFormatLoader)

public:
	godot::PackedStringArray _get_recognized_extensions() const override;
	bool _handles_type(const godot::StringName &p_type) const override;
	godot::String _get_resource_type(const godot::String &p_path) const override;
	godot::Variant _load(const godot::String &p_path, const godot::String &p_original_path, bool p_use_sub_threads,
	                     int32_t p_cache_mode) const override;

protected:
	static void _bind_methods() {}
};

class ProbeSaver : public godot::ResourceFormatSaver {
	GDCLASS(ProbeSaver, godot::ResourceFormatSaver)

public:
	godot::Error _save(const godot::Ref<godot::Resource> &p_resource, const godot::String &p_path,
	                   uint32_t p_flags) override;
	bool _recognize(const godot::Ref<godot::Resource> &p_resource) const override;
	godot::PackedStringArray _get_recognized_extensions(const godot::Ref<godot::Resource> &p_resource) const override;

protected:
	static void _bind_methods() {}
};
