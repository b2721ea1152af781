// Bytes as text, for data URIs (RFC 4648).
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace sailmap::report {

std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace sailmap::report
