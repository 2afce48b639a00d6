// VARIANT_ENUM_CAST and VARIANT_BITFIELD_CAST: an enum that bound methods may use, and its name for the engine.
#pragma once

namespace godot::internal {

struct EnumInfo {
	// As written, e.g. "Node::ProcessMode"; null for an enum that was not announced.
	const char *name = nullptr;
	bool is_bitfield = false;
};

template <class T> inline constexpr EnumInfo enum_info = {};

} // namespace godot::internal

#define VARIANT_ENUM_CAST(m_enum)                                                                                      \
	namespace godot {                                                                                                  \
	template <> inline constexpr internal::EnumInfo internal::enum_info<m_enum> = {#m_enum, false};                    \
	}
#define VARIANT_BITFIELD_CAST(m_enum)                                                                                  \
	namespace godot {                                                                                                  \
	template <> inline constexpr internal::EnumInfo internal::enum_info<m_enum> = {#m_enum, true};                     \
	}
