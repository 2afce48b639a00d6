#pragma once

#include <string>

#include <godot_cpp/variant/string.hpp>

#include "core/base/result.h"
#include "core/lang/source.h"

namespace pcg {

// The whole file through the engine, so that res:// works in exported games too. Paths without a scheme are the system's. Larger than `limit` bytes:
// an error.
Result<std::string> read_engine_file(const godot::String &path, uint64_t limit = uint64_t(1) << 30);

class EngineFiles : public SourceProvider {
public:
	Result<std::string> read(const std::string &path) override;
};

} // namespace pcg
