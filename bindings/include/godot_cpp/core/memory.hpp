// Memory that the engine counts, and `memnew`/`memdelete`, the only way to make and free objects.
#pragma once

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

#include <new>

namespace godot {

class Wrapped;
class StringName;

class Memory {
	Memory() = delete;

public:
	static void *alloc_static(size_t p_bytes, bool p_pad_align = false);
	static void *realloc_static(void *p_memory, size_t p_bytes, bool p_pad_align = false);
	static void free_static(void *p_ptr, bool p_pad_align = false);
};

namespace internal {

// Marks our operator new; the pointer says which class is being made.
struct ClassDescription;
struct AllocationTag {
	const ClassDescription *description = nullptr;
};

// What `Wrapped`'s constructor must know about the most derived class before that class's own constructor runs.
struct ClassDescription {
	// Name to give the engine with the instance; null for a plain engine class.
	const StringName *extension_class = nullptr;
	const GDExtensionInstanceBindingCallbacks *callbacks = nullptr;
};

void *allocate(size_t p_size, const ClassDescription *p_description);
void announce_creation(Wrapped *p_object);

template <class T> AllocationTag allocation_tag() {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		return {T::_gde_description()};
	} else {
		return {};
	}
}

template <class T> T *after_creation(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		announce_creation(p_object);
	}
	return p_object;
}

} // namespace internal
} // namespace godot

inline void *operator new(size_t p_size, const godot::internal::AllocationTag &p_tag) {
	return godot::internal::allocate(p_size, p_tag.description);
}
// Called only if a constructor throws, and exceptions are off; it silences the compiler.
inline void operator delete(void *p_memory, const godot::internal::AllocationTag &) {
	godot::Memory::free_static(p_memory);
}

#define memalloc(m_size) ::godot::Memory::alloc_static(m_size)
#define memrealloc(m_mem, m_size) ::godot::Memory::realloc_static(m_mem, m_size)
#define memfree(m_mem) ::godot::Memory::free_static(m_mem)

// `decltype` evaluates nothing: it only finds the class in `Foo`, `Foo()` or `Foo(1, 2)`.
#define memnew(m_class)                                                                                                \
	::godot::internal::after_creation(                                                                                 \
	        new (::godot::internal::allocation_tag<                                                                    \
	                std::remove_pointer_t<decltype(new (::godot::internal::AllocationTag{}) m_class)>>()) m_class)

#define memnew_placement(m_placement, m_class) (new (m_placement) m_class)

namespace godot {

template <class T> void memdelete(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		// The engine object owns the wrapper and takes it along.
		internal::engine.object_destroy(p_object->_owner);
	} else {
		p_object->~T();
		Memory::free_static(p_object);
	}
}

namespace internal {

// The element count sits in the padding before the array, where `memdelete_arr` finds it.
constexpr size_t array_header_size =
        alignof(std::max_align_t) < sizeof(uint64_t) ? sizeof(uint64_t) : alignof(std::max_align_t);

} // namespace internal

template <class T> T *memnew_arr_template(size_t p_count) {
	if (p_count == 0) {
		return nullptr;
	}
	uint8_t *memory = static_cast<uint8_t *>(Memory::alloc_static(internal::array_header_size + sizeof(T) * p_count));
	*reinterpret_cast<uint64_t *>(memory) = p_count;
	T *items = reinterpret_cast<T *>(memory + internal::array_header_size);
	for (size_t i = 0; i < p_count; i++) {
		new (&items[i]) T;
	}
	return items;
}

template <class T> void memdelete_arr(T *p_items) {
	if (!p_items) {
		return;
	}
	uint8_t *memory = reinterpret_cast<uint8_t *>(p_items) - internal::array_header_size;
	for (uint64_t i = 0; i < *reinterpret_cast<uint64_t *>(memory); i++) {
		p_items[i].~T();
	}
	Memory::free_static(memory);
}

#define memnew_arr(m_class, m_count) ::godot::memnew_arr_template<m_class>(m_count)

} // namespace godot
