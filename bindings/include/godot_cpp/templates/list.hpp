#pragma once

#include <godot_cpp/core/defs.hpp>

#include <list>

namespace godot {

// The part of the engine's doubly linked list that signatures need (`_get_property_list`).
template <class T> class List {
	std::list<T> items;

public:
	void push_back(const T &p_value) { items.push_back(p_value); }
	void push_front(const T &p_value) { items.push_front(p_value); }
	void pop_back() { items.pop_back(); }
	void pop_front() { items.pop_front(); }
	void clear() { items.clear(); }
	bool is_empty() const { return items.empty(); }
	int size() const { return int(items.size()); }

	auto begin() { return items.begin(); }
	auto end() { return items.end(); }
	auto begin() const { return items.begin(); }
	auto end() const { return items.end(); }
};

} // namespace godot
