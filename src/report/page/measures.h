#pragma once

#include <string>

#include "stepmill/part/part.h"

namespace stepmill::report {

/// Lengths and feeds as a page shows them: in mm, or in inches with one more decimal.
class Measures {
  public:
    explicit Measures(bool inch) : inch_(inch) {}

    /// "mm" or "in".
    const char* unit() const { return inch_ ? "in" : "mm"; }
    /// "mm/min" or "in/min".
    const char* feedUnit() const { return inch_ ? "in/min" : "mm/min"; }

    /// Without its unit, for tables whose heads have it. \param decimals  of mm
    std::string number(double length_mm, int decimals = 2) const;
    /// "12.50 mm", "0.492 in".
    std::string length(double length_mm, int decimals = 2) const;
    /// "100.00 × 50.00 × 20.00 mm".
    std::string size(const Vec3& size_mm) const;
    /// "X 0.00 Y 12.50 Z -20.00 mm".
    std::string place(const Vec3& at_mm) const;
    /// Without its unit.
    std::string feed(double feed_mm_per_min) const;
    /// Of a long way: "12.3 m", "40.4 ft".
    std::string way(double length_mm) const;

  private:
    bool inch_;
};

}  // namespace stepmill::report
