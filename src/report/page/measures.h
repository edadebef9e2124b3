#pragma once

#include <string>

#include "stepmill/part/part.h"

namespace stepmill::report {

/// Lengths, areas, volumes and feeds as a page shows them: in mm, or in inches with more decimals.
class Measures {
  public:
    explicit Measures(bool inch) : inch_(inch) {}

    /// "mm" or "in".
    const char* unit() const { return inch_ ? "in" : "mm"; }
    /// "mm/min" or "in/min".
    const char* feedUnit() const { return inch_ ? "in/min" : "mm/min"; }

    /// Without its unit, for tables whose heads have it.
    /// \param decimals  of mm
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

    /// "m" or "ft", of the next.
    const char* wayUnit() const { return inch_ ? "ft" : "m"; }
    std::string wayNumber(double length_mm, int decimals = 2) const;
    /// "µm" or "0.001 in", of the next.
    const char* fineUnit() const { return inch_ ? "0.001 in" : "µm"; }
    std::string fine(double length_mm) const;
    /// "mm²" or "in²", of the next.
    const char* areaUnit() const { return inch_ ? "in²" : "mm²"; }
    std::string area(double area_mm2, int decimals = 2) const;
    /// "cm³" or "in³", of the next.
    /// \param decimals  of cm³
    const char* volumeUnit() const { return inch_ ? "in³" : "cm³"; }
    std::string volume(double volume_mm3, int decimals = 3) const;
    /// For charts: in the page's unit, of volumes in volumeUnit().
    double lengthOf(double length_mm) const;
    double volumeOf(double volume_mm3) const;
    /// Of little material: "12.34 mm³", "0.00075 in³".
    std::string crumb(double volume_mm3) const;

  private:
    bool inch_;
};

}  // namespace stepmill::report
