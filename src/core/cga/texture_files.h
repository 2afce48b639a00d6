#pragma once

#include <cstdint>
#include <unordered_map>

#include "core/lang/value.h"

namespace pcg::cga {

class Context;

// Where the pictures lie that rules name: the host is asked once for each name in each rule file.
class TextureFiles {
public:
	struct Entry {
		uint32_t path = 0; // in the TextPool; 0: the host knows of none
		bool has_alpha = false;
	};

	void clear() { _entries.clear(); }
	// Of the file that the running call is written in. Warns where there is none.
	Entry find(Context &context, const Text &name);

private:
	std::unordered_map<uint64_t, Entry> _entries;
};

} // namespace pcg::cga
