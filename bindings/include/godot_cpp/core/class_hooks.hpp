// What the engine calls on an extension class: creation, notifications, dynamic properties.
#pragma once

#include <godot_cpp/core/object.hpp>

namespace godot::internal {

template <class T> constexpr bool is_extension_class = !std::is_same_v<typename T::_gde_engine_class, T>;

// The list handed to the engine by `get_property_list`, kept until the engine gives it back.
struct PropertyListBuffer {
	List<PropertyInfo> owned;

	static const GDExtensionPropertyInfo *publish(PropertyListBuffer *p_buffer, uint32_t *r_count);
	static void release(const GDExtensionPropertyInfo *p_list);
};

// One definition per class. "Own" means declared in that very class: only then does the member pointer's type name it.
template <class T> struct ClassHooks {
	using Parent = typename T::parent_type;
	static constexpr bool parent_is_ours = is_extension_class<Parent>;

	static T *self(void *p_instance) { return static_cast<T *>(static_cast<Wrapped *>(p_instance)); }
	static const StringName &name(GDExtensionConstStringNamePtr p_name) {
		return *static_cast<const StringName *>(p_name);
	}

	static constexpr bool own_notification = std::is_same_v<decltype(&T::_notification), void (T::*)(int)>;
	static constexpr bool own_set =
	        std::is_same_v<decltype(&T::_set), bool (T::*)(const StringName &, const Variant &)>;
	static constexpr bool own_get =
	        std::is_same_v<decltype(&T::_get), bool (T::*)(const StringName &, Variant &) const>;
	static constexpr bool own_list =
	        std::is_same_v<decltype(&T::_get_property_list), void (T::*)(List<PropertyInfo> *) const>;
	static constexpr bool own_can_revert =
	        std::is_same_v<decltype(&T::_property_can_revert), bool (T::*)(const StringName &) const>;
	static constexpr bool own_get_revert =
	        std::is_same_v<decltype(&T::_property_get_revert), bool (T::*)(const StringName &, Variant &) const>;
	static constexpr bool own_validate =
	        std::is_same_v<decltype(&T::_validate_property), void (T::*)(PropertyInfo &) const>;
	static constexpr bool own_to_string = std::is_same_v<decltype(&T::_to_string), String (T::*)() const>;

	static GDExtensionObjectPtr create(void *, GDExtensionBool p_notify) {
		if constexpr (std::is_abstract_v<T>) {
			return nullptr;
		} else {
			T *object = new (allocation_tag<T>()) T;
			if (p_notify) {
				announce_creation(object);
			}
			return object->_owner;
		}
	}

	static void free(void *, GDExtensionClassInstancePtr p_instance) {
		T *object = self(p_instance);
		object->~T();
		Memory::free_static(object);
	}

	// A parent hears of it before its children, and of an ending (reversed) after them.
	static void notify(GDExtensionClassInstancePtr p_instance, int32_t p_what, GDExtensionBool p_reversed) {
		if constexpr (parent_is_ours) {
			if (!p_reversed) {
				ClassHooks<Parent>::notify(p_instance, p_what, p_reversed);
			}
		}
		if constexpr (own_notification) {
			self(p_instance)->T::_notification(p_what);
		}
		if constexpr (parent_is_ours) {
			if (p_reversed) {
				ClassHooks<Parent>::notify(p_instance, p_what, p_reversed);
			}
		}
	}

	static GDExtensionBool set(GDExtensionClassInstancePtr p_instance, GDExtensionConstStringNamePtr p_name,
	                           GDExtensionConstVariantPtr p_value) {
		if constexpr (parent_is_ours) {
			if (ClassHooks<Parent>::set(p_instance, p_name, p_value)) {
				return true;
			}
		}
		if constexpr (own_set) {
			return self(p_instance)->T::_set(name(p_name), *static_cast<const Variant *>(p_value));
		}
		return false;
	}

	static GDExtensionBool get(GDExtensionClassInstancePtr p_instance, GDExtensionConstStringNamePtr p_name,
	                           GDExtensionVariantPtr r_value) {
		if constexpr (parent_is_ours) {
			if (ClassHooks<Parent>::get(p_instance, p_name, r_value)) {
				return true;
			}
		}
		if constexpr (own_get) {
			return self(p_instance)->T::_get(name(p_name), *static_cast<Variant *>(r_value));
		}
		return false;
	}

	static constexpr bool has_property_list() {
		if constexpr (parent_is_ours) {
			return own_list || ClassHooks<Parent>::has_property_list();
		} else {
			return own_list;
		}
	}

	static void collect_properties(void *p_instance, List<PropertyInfo> *r_list) {
		if constexpr (parent_is_ours) {
			ClassHooks<Parent>::collect_properties(p_instance, r_list);
		}
		if constexpr (own_list) {
			self(p_instance)->T::_get_property_list(r_list);
		}
	}

	static const GDExtensionPropertyInfo *get_property_list(GDExtensionClassInstancePtr p_instance, uint32_t *r_count) {
		PropertyListBuffer *buffer = new (AllocationTag{}) PropertyListBuffer;
		collect_properties(p_instance, &buffer->owned);
		return PropertyListBuffer::publish(buffer, r_count);
	}

	static void free_property_list(GDExtensionClassInstancePtr, const GDExtensionPropertyInfo *p_list, uint32_t) {
		PropertyListBuffer::release(p_list);
	}

	static GDExtensionBool can_revert(GDExtensionClassInstancePtr p_instance, GDExtensionConstStringNamePtr p_name) {
		if constexpr (own_can_revert) {
			if (self(p_instance)->T::_property_can_revert(name(p_name))) {
				return true;
			}
		}
		if constexpr (parent_is_ours) {
			return ClassHooks<Parent>::can_revert(p_instance, p_name);
		}
		return false;
	}

	static GDExtensionBool get_revert(GDExtensionClassInstancePtr p_instance, GDExtensionConstStringNamePtr p_name,
	                                  GDExtensionVariantPtr r_value) {
		if constexpr (own_get_revert) {
			if (self(p_instance)->T::_property_get_revert(name(p_name), *static_cast<Variant *>(r_value))) {
				return true;
			}
		}
		if constexpr (parent_is_ours) {
			return ClassHooks<Parent>::get_revert(p_instance, p_name, r_value);
		}
		return false;
	}

	static GDExtensionBool validate_property(GDExtensionClassInstancePtr p_instance, GDExtensionPropertyInfo *p_info) {
		bool validated = false;
		if constexpr (parent_is_ours) {
			validated = ClassHooks<Parent>::validate_property(p_instance, p_info);
		}
		if constexpr (own_validate) {
			PropertyInfo info(p_info);
			self(p_instance)->T::_validate_property(info);
			info._update(p_info);
			validated = true;
		}
		return validated;
	}

	static void to_string(GDExtensionClassInstancePtr p_instance, GDExtensionBool *r_is_valid,
	                      GDExtensionStringPtr r_out) {
		if constexpr (own_to_string) {
			*static_cast<String *>(r_out) = self(p_instance)->T::_to_string();
			*r_is_valid = true;
		} else if constexpr (parent_is_ours) {
			ClassHooks<Parent>::to_string(p_instance, r_is_valid, r_out);
		} else {
			*r_is_valid = false;
		}
	}

	static GDExtensionClassCreationInfo5 creation_info() {
		GDExtensionClassCreationInfo5 info = {};
		info.set_func = set;
		info.get_func = get;
		info.get_property_list_func = has_property_list() ? get_property_list : nullptr;
		info.free_property_list_func = free_property_list;
		info.property_can_revert_func = can_revert;
		info.property_get_revert_func = get_revert;
		info.validate_property_func = validate_property;
		info.notification_func = notify;
		info.to_string_func = to_string;
		info.create_instance_func = create;
		info.free_instance_func = free;
		return info;
	}
};

} // namespace godot::internal
