#pragma once

#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

// A Dictionary that admits one key type and one value type; `Variant` stands for any.
template <typename K, typename V> class TypedDictionary : public Dictionary {
	void set_element_types() {
		set_typed(internal::element_type<K>, internal::element_class<K>(), Variant(), internal::element_type<V>,
		          internal::element_class<V>(), Variant());
	}

public:
	TypedDictionary() { set_element_types(); }
	TypedDictionary(const Dictionary &p_dictionary) {
		set_element_types();
		if (is_same_typed(p_dictionary)) {
			Dictionary::operator=(p_dictionary);
		} else {
			assign(p_dictionary);
		}
	}
	TypedDictionary(const Variant &p_variant) : TypedDictionary(p_variant.operator Dictionary()) {}
	TypedDictionary(const TypedDictionary &p_dictionary) = default;
	TypedDictionary &operator=(const TypedDictionary &p_dictionary) = default;
	void operator=(const Dictionary &p_dictionary) {
		if (is_same_typed(p_dictionary)) {
			Dictionary::operator=(p_dictionary);
		} else {
			internal::report_untyped_assignment();
		}
	}
};

} // namespace godot
