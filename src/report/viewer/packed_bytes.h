#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stepmill::report {

/// A place of a setup in whole steps of kPackedStepMm, as the viewer's data has it: fine enough to look at.
inline constexpr double kPackedStepMm = 0.01;
std::int64_t packedSteps(double length_mm);

/// Whole numbers for the viewer's script (viewer_data.js reads them), small ones in one byte.
class PackedBytes {
  public:
    void byte(std::uint8_t value) { bytes_.push_back(value); }
    /// Seven bits a byte, the lowest first, the eighth says that more follow; the sign is the lowest bit.
    void number(std::int64_t value);
    /// Two bytes, the lower one first.
    void half(std::uint16_t value);
    /// Four bytes, the lowest first.
    void whole(std::uint32_t value);

    std::size_t size() const { return bytes_.size(); }
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }
    std::string text() const;

  private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace stepmill::report
