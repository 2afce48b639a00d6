#include "probe_loader.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

void ProbeResource::set_text(const String &p_text) {
	_text = p_text;
	emit_changed();
}

void ProbeResource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_text", "text"), &ProbeResource::set_text);
	ClassDB::bind_method(D_METHOD("get_text"), &ProbeResource::get_text);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "text", PROPERTY_HINT_MULTILINE_TEXT), "set_text", "get_text");
}

PackedStringArray ProbeLoader::_get_recognized_extensions() const {
	return {"probe"};
}

bool ProbeLoader::_handles_type(const StringName &p_type) const {
	return p_type == StringName("ProbeResource") || p_type == StringName("Resource");
}

String ProbeLoader::_get_resource_type(const String &p_path) const {
	return p_path.get_extension().to_lower() == "probe" ? "ProbeResource" : "";
}

Variant ProbeLoader::_load(const String &p_path, const String &, bool, int32_t) const {
	Ref<FileAccess> file = FileAccess::open(p_path, FileAccess::READ);
	if (file.is_null()) {
		return FileAccess::get_open_error();
	}
	Ref<ProbeResource> resource;
	resource.instantiate();
	resource->set_text(file->get_as_text());
	return resource;
}

Error ProbeSaver::_save(const Ref<Resource> &p_resource, const String &p_path, uint32_t) {
	Ref<ProbeResource> resource = p_resource;
	ERR_FAIL_COND_V(resource.is_null(), ERR_INVALID_PARAMETER);
	Ref<FileAccess> file = FileAccess::open(p_path, FileAccess::WRITE);
	if (file.is_null()) {
		return FileAccess::get_open_error();
	}
	file->store_string(resource->get_text());
	return OK;
}

bool ProbeSaver::_recognize(const Ref<Resource> &p_resource) const {
	return Object::cast_to<ProbeResource>(p_resource.ptr()) != nullptr;
}

PackedStringArray ProbeSaver::_get_recognized_extensions(const Ref<Resource> &p_resource) const {
	return _recognize(p_resource) ? PackedStringArray{"probe"} : PackedStringArray();
}
