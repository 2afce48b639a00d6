#include <godot_cpp/classes/wrapped.hpp>

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/error_macros.hpp>

namespace godot {

namespace internal {

namespace {

// Objects whose memory is there but whose constructor has not reached Wrapped yet. More than one only if a
// constructor's arguments make objects themselves.
struct PendingCreation {
	void *memory;
	const ClassDescription *description;
};
constexpr int max_pending = 16;
thread_local PendingCreation pending[max_pending];
thread_local int pending_count = 0;

const ClassDescription *take_pending(const void *p_memory) {
	for (int i = pending_count - 1; i >= 0; i--) {
		if (pending[i].memory == p_memory) {
			const ClassDescription *description = pending[i].description;
			pending[i] = pending[--pending_count];
			return description;
		}
	}
	return nullptr;
}

} // namespace

void *allocate(size_t p_size, const ClassDescription *p_description) {
	void *memory = Memory::alloc_static(p_size);
	if (p_description) {
		CRASH_COND_MSG(pending_count == max_pending,
		               "Too many objects are made in each other's constructor arguments.");
		pending[pending_count++] = {memory, p_description};
	}
	return memory;
}

void announce_creation(Wrapped *p_object) {
	static_cast<Object *>(p_object)->notification(Object::NOTIFICATION_POSTINITIALIZE);
}

} // namespace internal

Wrapped::Wrapped(const StringName &p_engine_class) {
	const internal::ClassDescription *description = internal::take_pending(this);
	CRASH_COND_MSG(!description, "Engine objects are made by memnew() or Ref::instantiate() only.");
	_owner = internal::engine.classdb_construct_object2(p_engine_class._native_ptr());
	if (description->extension_class) {
		internal::engine.object_set_instance(_owner, description->extension_class->_native_ptr(), this);
	}
	internal::engine.object_set_instance_binding(_owner, internal::token, this, description->callbacks);
}

} // namespace godot
