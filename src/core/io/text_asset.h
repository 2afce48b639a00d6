#pragma once

#include <string>
#include <string_view>

#include "core/ports/asset_provider.h"

// Text files that rules read (CGA reference: func_readTextFile, func_readTable).
namespace pcg {

// From UTF-8, UTF-16 with a byte order mark, or else Latin-1: UTF-8 with lines ended by \n; other control characters become ?.
std::string decode_text(std::string_view bytes);
// Fields parted by comma, semicolon or tab, whichever the first line has most of, else by blanks; quoted as in RFC 4180. Short rows are filled up with
// empty fields.
TextTable parse_table(std::string_view text);

} // namespace pcg
