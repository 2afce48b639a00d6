#pragma once

#include <cstdint>
#include <vector>

#include "core/lang/value.h"

namespace pcg::cga {

class Context;

// Where the pictures lie that rules name: the host is asked once for each name in each rule file.
class TextureFiles {
public:
	struct Entry {
		uint32_t file = 0; // as the rule names it, in the TextPool
		uint32_t path = 0; // 0: the host knows of none
		bool has_alpha = false;
	};

	void clear() { _entries.clear(); }
	// Of the file that the running call is written in. Warns where there is none.
	Entry find(Context &context, const Text &name);

private:
	struct Known : Entry {
		bool was_asked = false, is_missing = false;
	};
	Known ask(Context &context, const Text &name, uint32_t rule_file) const;

	std::vector<std::vector<Known>> _entries; // by rule file, by text
};

} // namespace pcg::cga
