#pragma once

namespace stepmill {

/// Heights closer than this are one, but for rounding [mm].
inline constexpr double kSameHeightMm = 1e-6;

/// The same of heights that may come out of a plan.json, which has six decimals [mm].
inline constexpr double kSameWrittenHeightMm = 1e-5;

}  // namespace stepmill
