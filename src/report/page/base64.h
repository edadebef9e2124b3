#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace stepmill::report {

/// Bytes as text: six bits a character, filled up with "=" to whole groups of four [RFC 4648, section 4].
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace stepmill::report
