// Names of images are paths, and those may hold any bytes; the formats want text.
#pragma once

#include <string>
#include <string_view>

namespace sailmap {

// Valid UTF-8: each byte that belongs to no character becomes U+FFFD.
std::string utf8(std::string_view bytes);

// The same without the characters that XML 1.0 does not have, control characters foremost: U+FFFD instead.
std::string xml_text(std::string_view bytes);

// Between double quotes, those inside written as `escaped_quote`; in UTF-8.
std::string quoted(std::string_view bytes, std::string_view escaped_quote);

}  // namespace sailmap
