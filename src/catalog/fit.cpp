// Limits of bores by the tables of ISO 286-1.

#include "stepmill/catalog/fit.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace stepmill {
namespace {

constexpr double kMmPerMicrometre = 1e-3;
constexpr int kLeastGrade = 6;
constexpr int kMostGrade = 11;

/// Bores over the limit of the row before up to this one's share deviations.
struct Row {
    double up_to_mm;
    std::array<int, kMostGrade - kLeastGrade + 1> grade_um;  ///< widths of the zones IT6 to IT11 [table 1]
    int g_um;                                                ///< lower deviation of G
    int f_um;                                                ///< lower deviation of F
};

constexpr Row kRows[] = {
    {3, {6, 10, 14, 25, 40, 60}, 2, 6},         {6, {8, 12, 18, 30, 48, 75}, 4, 10},
    {10, {9, 15, 22, 36, 58, 90}, 5, 13},       {18, {11, 18, 27, 43, 70, 110}, 6, 16},
    {30, {13, 21, 33, 52, 84, 130}, 7, 20},     {50, {16, 25, 39, 62, 100, 160}, 9, 25},
    {80, {19, 30, 46, 74, 120, 190}, 10, 30},   {120, {22, 35, 54, 87, 140, 220}, 12, 36},
    {180, {25, 40, 63, 100, 160, 250}, 14, 43}, {250, {29, 46, 72, 115, 185, 290}, 15, 50}};

/// How far the zone begins over the nominal diameter.
double lowerDeviationUm(const std::string& letter, const Row& row, int width_um) {
    if (letter == "F") return row.f_um;
    if (letter == "G") return row.g_um;
    return letter == "JS" ? -width_um / 2.0 : 0;
}

}  // namespace

std::optional<Fit> fitFrom(std::string_view name) {
    const auto digit =
        std::find_if(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    Fit fit{std::string(name), std::string(name.begin(), digit), 0};
    constexpr std::array<std::string_view, 4> kLetters{"F", "G", "H", "JS"};
    if (std::find(kLetters.begin(), kLetters.end(), fit.letter) == kLetters.end()) return std::nullopt;
    const std::string_view grade = name.substr(fit.letter.size());
    for (fit.grade = kLeastGrade; fit.grade <= kMostGrade; ++fit.grade)
        if (grade == std::to_string(fit.grade)) return fit;
    return std::nullopt;
}

std::optional<BoreLimits> boreLimits(const Fit& fit, double nominal_mm) {
    for (const Row& row : kRows) {
        if (nominal_mm > row.up_to_mm) continue;
        const int width_um = row.grade_um.at(static_cast<std::size_t>(fit.grade - kLeastGrade));
        const double least_um = lowerDeviationUm(fit.letter, row, width_um);
        return BoreLimits{nominal_mm + least_um * kMmPerMicrometre,
                          nominal_mm + (least_um + width_um) * kMmPerMicrometre};
    }
    return std::nullopt;
}

}  // namespace stepmill
