#pragma once

#include <godot_cpp/classes/resource_format_saver.hpp>
#include <godot_cpp/core/binder_common.hpp>

namespace pcg {

// Writes rule sets as rule files, whole or not at all.
class PCGRuleSetSaver : public godot::ResourceFormatSaver {
	GDCLASS(PCGRuleSetSaver, godot::ResourceFormatSaver)

public:
	godot::Error _save(const godot::Ref<godot::Resource> &p_resource, const godot::String &p_path, uint32_t p_flags) override;
	bool _recognize(const godot::Ref<godot::Resource> &p_resource) const override;
	godot::PackedStringArray _get_recognized_extensions(const godot::Ref<godot::Resource> &p_resource) const override;

protected:
	static void _bind_methods() {}
};

} // namespace pcg
