#include "report/viewer/packed_bytes.h"

#include <cmath>

#include "report/page/base64.h"

namespace stepmill::report {

std::int64_t packedSteps(double length_mm) {
    return std::llround(length_mm / kPackedStepMm);
}

void PackedBytes::number(std::int64_t value) {
    auto rest = static_cast<std::uint64_t>(value < 0 ? -(value + 1) : value) << 1U;
    if (value < 0) rest |= 1U;
    while (rest >= 0x80U) {
        byte(static_cast<std::uint8_t>(rest | 0x80U));
        rest >>= 7U;
    }
    byte(static_cast<std::uint8_t>(rest));
}

void PackedBytes::half(std::uint16_t value) {
    byte(static_cast<std::uint8_t>(value));
    byte(static_cast<std::uint8_t>(value >> 8U));
}

void PackedBytes::whole(std::uint32_t value) {
    half(static_cast<std::uint16_t>(value));
    half(static_cast<std::uint16_t>(value >> 16U));
}

std::string PackedBytes::text() const {
    return base64(bytes_);
}

}  // namespace stepmill::report
