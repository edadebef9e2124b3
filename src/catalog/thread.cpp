#include "stepmill/catalog/thread.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

struct MetricRow {
    double diameter_mm;
    double pitch_mm;
    double drill_mm;
};

/// ISO 261, coarse pitches of the first three choices; drills of ISO 2306.
constexpr MetricRow kMetricCoarse[] = {
    {1.6, 0.35, 1.25}, {1.8, 0.35, 1.45}, {2, 0.4, 1.6},  {2.2, 0.45, 1.75}, {2.5, 0.45, 2.05},
    {3, 0.5, 2.5},     {3.5, 0.6, 2.9},   {4, 0.7, 3.3},  {4.5, 0.75, 3.7},  {5, 0.8, 4.2},
    {6, 1, 5},         {7, 1, 6},         {8, 1.25, 6.8}, {9, 1.25, 7.8},    {10, 1.5, 8.5},
    {11, 1.5, 9.5},    {12, 1.75, 10.2},  {14, 2, 12},    {16, 2, 14},       {18, 2.5, 15.5},
    {20, 2.5, 17.5},   {22, 2.5, 19.5},   {24, 3, 21},    {27, 3, 24},       {30, 3.5, 26.5},
    {33, 3.5, 29.5},   {36, 4, 32},       {39, 4, 35}};

struct UnifiedRow {
    const char* size;
    int threads_per_inch;
    double drill_inch;
};

/// ASME B1.1, the coarse series UNC; drills by number, letter and fraction of an inch.
constexpr UnifiedRow kUnifiedCoarse[] = {
    {"#1", 64, 0.0595},     {"#2", 56, 0.0700},    {"#3", 48, 0.0785},     {"#4", 40, 0.0890},
    {"#5", 40, 0.1015},     {"#6", 32, 0.1065},    {"#8", 32, 0.1360},     {"#10", 24, 0.1495},
    {"#12", 24, 0.1770},    {"1/4", 20, 0.2010},   {"5/16", 18, 0.2570},   {"3/8", 16, 0.3125},
    {"7/16", 14, 0.3680},   {"1/2", 13, 0.421875}, {"9/16", 12, 0.484375}, {"5/8", 11, 0.53125},
    {"3/4", 10, 0.65625},   {"7/8", 9, 0.765625},  {"1", 8, 0.875},        {"1 1/8", 7, 0.984375},
    {"1 1/4", 7, 1.109375}, {"1 3/8", 6, 1.21875}, {"1 1/2", 6, 1.34375}};

/// Heights of the profile over the pitch: from D to D1 it is 5/8 of the whole triangle, twice.
constexpr double kMinorShare = 1.0825318;

/// Names on drawings are shorter; a regular expression takes stack for every character.
constexpr std::size_t kLongestName = 24;

/// A pitch is between these shares of the diameter in all series.
constexpr double kFinestShare = 0.02;
constexpr double kCoarsestShare = 0.3;

/// Major diameter of a size as it is written [inch]: numbered screws are 0.060 and 0.013 a number.
std::optional<double> inchesOf(const std::string& size) {
    static const std::regex kNumbered("#([0-9]{1,2})");
    static const std::regex kFraction("(?:([0-9]) )?([0-9]{1,2})/([0-9]{1,2})");
    static const std::regex kWhole("[0-9]");
    std::smatch found;
    if (std::regex_match(size, found, kNumbered)) return 0.060 + 0.013 * std::stoi(found[1]);
    if (std::regex_match(size, kWhole)) return std::stoi(size);
    if (!std::regex_match(size, found, kFraction) || std::stoi(found[3]) == 0) return std::nullopt;
    const double whole = found[1].matched ? std::stoi(found[1]) : 0;
    return whole + static_cast<double>(std::stoi(found[2])) / std::stoi(found[3]);
}

Thread metric(double diameter_mm, double pitch_mm) {
    return {fmt::format("M{}x{}", diameter_mm, pitch_mm), ThreadStandard::Iso, diameter_mm, pitch_mm};
}

Thread unified(const std::string& size, double diameter_inch, int threads_per_inch, const char* series) {
    return {fmt::format("{}-{}{}", size, threads_per_inch, series), ThreadStandard::Unified,
            kMillimetresPerInch * diameter_inch, kMillimetresPerInch / threads_per_inch};
}

std::vector<ThreadSize> allSizes() {
    std::vector<ThreadSize> sizes;
    for (const MetricRow& row : kMetricCoarse)
        sizes.push_back({metric(row.diameter_mm, row.pitch_mm), row.drill_mm});
    for (const UnifiedRow& row : kUnifiedCoarse)
        sizes.push_back({unified(row.size, inchesOf(row.size).value(), row.threads_per_inch, " UNC"),
                         kMillimetresPerInch * row.drill_inch});
    return sizes;
}

/// Tolerance of the minor diameter, grade 6 [ISO 965-1, 13.4], in um of mm.
double isoToleranceMm(double pitch_mm) {
    const double um =
        pitch_mm < 1 ? 433 * pitch_mm - 190 * std::pow(pitch_mm, 1.22) : 230 * std::pow(pitch_mm, 0.7);
    return um / 1000;
}

/// Tolerance of the minor diameter, classes 1B and 2B, from four threads an inch on [ASME B1.1, 5.8.1].
double unifiedToleranceMm(double diameter_mm, double pitch_mm) {
    constexpr double kSmallInch = 0.25;
    const double d = mmToInch(diameter_mm);
    const double p = mmToInch(pitch_mm);
    const double usual = 0.25 * p - 0.4 * p * p;
    if (d >= kSmallInch) return inchToMm(usual);
    const double small = 0.05 * std::cbrt(p * p) + 0.03 * p / d - 0.002;
    return inchToMm(std::clamp(small, usual, 0.394 * p));
}

/// No thread has another pitch: such a name is a slip of the pen.
std::optional<Thread> sensible(Thread thread) {
    const double share = thread.pitch_mm / thread.diameter_mm;
    if (!(share >= kFinestShare && share <= kCoarsestShare)) return std::nullopt;
    return thread;
}

std::optional<Thread> coarse(double diameter_mm) {
    for (const MetricRow& row : kMetricCoarse)
        if (row.diameter_mm == diameter_mm) return metric(row.diameter_mm, row.pitch_mm);
    return std::nullopt;
}

}  // namespace

const std::vector<ThreadSize>& threadSizes() {
    static const std::vector<ThreadSize> kSizes = allSizes();
    return kSizes;
}

bool sameThread(const Thread& one, const Thread& other) {
    constexpr double kSameMm = 1e-6;
    return std::abs(one.diameter_mm - other.diameter_mm) <= kSameMm &&
           std::abs(one.pitch_mm - other.pitch_mm) <= kSameMm;
}

CoreRange coreRange(const Thread& thread) {
    const double least_mm = thread.diameter_mm - kMinorShare * thread.pitch_mm;
    const double tolerance_mm = thread.standard == ThreadStandard::Iso
                                    ? isoToleranceMm(thread.pitch_mm)
                                    : unifiedToleranceMm(thread.diameter_mm, thread.pitch_mm);
    return {least_mm, least_mm + tolerance_mm};
}

bool isCoreOf(const Thread& thread, double bore_mm) {
    const CoreRange range = coreRange(thread);
    return bore_mm >= range.least_mm - kCoreRoundingMm && bore_mm <= range.most_mm + kCoreRoundingMm;
}

std::vector<const ThreadSize*> threadsForCore(double bore_mm) {
    std::vector<const ThreadSize*> fitting;
    for (const ThreadSize& size : threadSizes())
        if (isCoreOf(size.thread, bore_mm)) fitting.push_back(&size);
    return fitting;
}

std::optional<Thread> threadFrom(std::string_view name) {
    if (name.size() > kLongestName) return std::nullopt;
    static const std::regex kMetric("M([0-9]{1,3}(?:\\.[0-9]{1,2})?)(?:x([0-9](?:\\.[0-9]{1,3})?))?");
    static const std::regex kUnified("(#?[0-9 /]+)-([0-9]{1,2})( UNC| UNF| UN| UNEF)?");
    const std::string text(name);
    std::smatch found;
    if (std::regex_match(text, found, kMetric)) {
        const double diameter_mm = std::stod(found[1]);
        if (!found[2].matched) return coarse(diameter_mm);
        return sensible(metric(diameter_mm, std::stod(found[2])));
    }
    if (!std::regex_match(text, found, kUnified)) return std::nullopt;
    const std::optional<double> inches = inchesOf(found[1]);
    const int threads_per_inch = std::stoi(found[2]);
    if (!inches || *inches <= 0 || threads_per_inch == 0) return std::nullopt;
    return sensible(unified(found[1], *inches, threads_per_inch, found[3].str().c_str()));
}

}  // namespace stepmill
