#include "core/io/utf8.h"

#define JSON_NOEXCEPTION
#include <nlohmann/json.hpp>

namespace pcg {

std::string valid_utf8(const std::string &text) {
	const std::string quoted = nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
	return nlohmann::json::parse(quoted, nullptr, false).get<std::string>();
}

} // namespace pcg
