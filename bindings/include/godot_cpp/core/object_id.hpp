#pragma once

#include <cstdint>

namespace godot {

// The engine's id of an object; 0 names none. Safe to keep: a freed object's id is never given out again.
class ObjectID {
	uint64_t id = 0;

public:
	ObjectID() = default;
	explicit ObjectID(uint64_t p_id) : id(p_id) {}
	explicit ObjectID(int64_t p_id) : id(uint64_t(p_id)) {}

	bool is_valid() const { return id != 0; }
	bool is_null() const { return id == 0; }
	bool is_ref_counted() const { return (id & (uint64_t(1) << 63)) != 0; }
	operator uint64_t() const { return id; }
	operator int64_t() const { return int64_t(id); }

	bool operator==(const ObjectID &p_id) const { return id == p_id.id; }
	bool operator!=(const ObjectID &p_id) const { return id != p_id.id; }
	bool operator<(const ObjectID &p_id) const { return id < p_id.id; }

	ObjectID &operator=(int64_t p_int64) {
		id = uint64_t(p_int64);
		return *this;
	}
	ObjectID &operator=(uint64_t p_uint64) {
		id = p_uint64;
		return *this;
	}
};

} // namespace godot
