#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stepmill {

/// What a thread is called by its standard: whose limits its bore has.
enum class ThreadStandard {
    Iso,     ///< metric, ISO 68-1 profile
    Unified  ///< inch, ASME B1.1: the same profile, other sizes
};

/// A right-hand internal thread of the 60 degree profile.
struct Thread {
    std::string name;  ///< "M8x1.25", "1/4-20 UNC"
    ThreadStandard standard = ThreadStandard::Iso;
    double diameter_mm = 0;  ///< major: of the screw outside
    double pitch_mm = 0;
};

/// Have they one diameter and one pitch, whatever their names?
bool sameThread(const Thread& one, const Thread& other);

/// One that a shop has taps for, with the drill that it is usually tapped after.
struct ThreadSize {
    Thread thread;
    double tap_drill_mm = 0;
};

/// The metric coarse pitch series from M1.6 to M39 with the drills of ISO 2306 [ISO 261], then UNC from 1-64
/// to 1 1/2-6 with the usual drills [ASME B1.1]; each by rising diameter.
const std::vector<ThreadSize>& threadSizes();

/// Which bores a thread may be tapped into.
struct CoreRange {
    double least_mm = 0;
    double most_mm = 0;
};

/// Limits of the thread's minor diameter D1: from the profile, D - 1.0825 P, to that and the tolerance of
/// class 6H [ISO 965-1] or 2B [ASME B1.1, 5.8.1]. By the standards' formulas, not rounded to their tables.
CoreRange coreRange(const Thread& thread);

/// Bores on a drawing are rounded: a range holds a bore this near to its ends too [mm].
inline constexpr double kCoreRoundingMm = 5e-4;
bool isCoreOf(const Thread& thread, double bore_mm);

/// The threads of threadSizes() that a bore of this diameter may be tapped with, in their order.
std::vector<const ThreadSize*> threadsForCore(double bore_mm);

/// The thread of a name as drawings have it: "M8" (the coarse pitch), "M8x1", "M8x1.25", "1/4-20",
/// "1/4-20 UNC", "#10-24", "#10-24 UNC", "1 1/8-7". Nothing for other words, and for pitches that no thread
/// of that diameter has: from 0.02 to 0.3 of the diameter.
std::optional<Thread> threadFrom(std::string_view name);

}  // namespace stepmill
