#include "crib/tool_maker.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"

namespace stepmill::crib {
namespace {

/// Pitches in files are rounded; threads differ by more [mm].
constexpr double kSamePitchMm = 0.01;
/// Diameters of inch threads in files are rounded [mm].
constexpr double kSameDiameterMm = 0.05;

/// The thread of these sizes as our library names it; nothing where no standard has it.
std::optional<Thread> threadOf(double diameter_mm, double pitch_mm) {
    for (const ThreadSize& size : threadSizes())
        if (std::abs(size.thread.diameter_mm - diameter_mm) < kSameDiameterMm &&
            std::abs(size.thread.pitch_mm - pitch_mm) < kSamePitchMm)
            return size.thread;
    return threadFrom(fmt::format("M{:.6g}x{:.6g}", diameter_mm, pitch_mm));
}

void finishTap(ForeignTool& foreign, double pitch_mm) {
    ToolAssembly& tool = foreign.tool;
    if (!tool.thread && pitch_mm > 0) tool.thread = threadOf(tool.diameter_mm, pitch_mm);
    if (!tool.thread) {
        foreign.unfit = pitch_mm > 0 ? fmt::format(
                                           "no standard thread has diameter {:.6g} mm and pitch "
                                           "{:.6g} mm",
                                           tool.diameter_mm, pitch_mm)
                                     : "the pitch of its thread is not told";
        return;
    }
    tool.diameter_mm = tool.thread->diameter_mm;
    if (tool.lead_mm == 0) tool.lead_mm = kUsualLeadThreads * tool.thread->pitch_mm;
}

void requireDiameter(const ForeignTool& foreign, const std::string& file) {
    const double diameter_mm = foreign.tool.diameter_mm;
    if (diameter_mm >= kThinnestMm && diameter_mm <= kWidestMm) return;
    refuse(file, foreign.place,
           fmt::format("expected a tool's diameter of {:g} to {:g} mm, found {}; --leave-out goes on without "
                       "such tools",
                       kThinnestMm, kWidestMm,
                       diameter_mm == 0 ? "none" : fmt::format("{:.6g} mm", diameter_mm)));
}

}  // namespace

std::optional<double> mmPerUnit(std::string_view word) {
    if (word == "mm" || word == "millimeters" || word == "millimetres" || word == "metric") return 1.0;
    if (word == "inch" || word == "inches" || word == "in" || word == "imperial") return kMillimetresPerInch;
    return std::nullopt;
}

double toldUnitMm(const ForeignOptions& options, const std::string& file) {
    if (options.unit.empty())
        throw Error(ErrorCode::Usage, "--unit",
                    fmt::format("expected mm or inch: {} does not say the unit of its lengths", file));
    if (const auto mm = mmPerUnit(options.unit)) return *mm;
    throw Error(ErrorCode::Usage, "--unit", fmt::format("expected mm or inch, found '{}'", options.unit));
}

std::optional<double> numberOf(std::string_view text) {
    std::string plain(text);
    std::replace(plain.begin(), plain.end(), ',', '.');
    const char* first = plain.data() + (plain.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [end, trouble] = std::from_chars(first, plain.data() + plain.size(), value);
    const bool whole = trouble == std::errc() && end == plain.data() + plain.size() && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

std::string fieldText(std::string_view text, std::size_t most) {
    std::string line = plainLine(text.substr(0, 4 * most));
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) return {};
    line = line.substr(first, line.find_last_not_of(' ') - first + 1);
    if (line.size() <= most) return line;
    while (most > 0 && (static_cast<unsigned char>(line[most]) & 0xC0U) == 0x80U)
        --most;  // whole characters
    return line.substr(0, most);
}

void refuse(const std::string& file, const std::string& place, const std::string& message) {
    throw Error(ErrorCode::InvalidCatalog, place.starts_with("#") ? file + place : file + ", " + place,
                message);
}

std::string materialName(const ForeignOptions& options, const std::string& preset,
                         const std::string& material) {
    constexpr std::size_t kLongestName = 100;
    for (const std::string& word : {preset, material})
        if (const auto ours = options.materials.find(word); !word.empty() && ours != options.materials.end())
            return ours->second;
    return fieldText(material.empty() ? preset : material, kLongestName);
}

void addCutting(ForeignTool& foreign, const std::string& preset, CuttingData data) {
    const std::string name = fieldText(preset, 60);
    if (!(data.speed_rpm > 0) || !(data.feed_mm_per_min > 0)) {
        foreign.notes.push_back(fmt::format("preset '{}' left aside: it has no {}", name,
                                            data.speed_rpm > 0 ? "feed" : "spindle speed"));
        return;
    }
    if (data.material.empty()) {
        foreign.notes.push_back("a preset left aside: neither it nor its material has a name");
        return;
    }
    if (foreign.tool.cuttingFor(data.material) != nullptr) {
        foreign.notes.push_back(
            fmt::format("preset '{}' left aside: another is for '{}' already", name, data.material));
        return;
    }
    foreign.tool.cutting.push_back(std::move(data));
}

void finishTool(ForeignTool& foreign, double pitch_mm, const std::string& file,
                const ForeignOptions& options) {
    if (!foreign.unfit.empty()) return;
    ToolAssembly& tool = foreign.tool;
    try {
        requireDiameter(foreign, file);
    } catch (const Error& error) {
        if (!options.leave_out) throw;
        foreign.unfit = "it has no diameter that a cutter can have";
        return;
    }
    if (tool.type == ToolType::Ball) tool.corner_radius_mm = tool.diameter_mm / 2;
    if (tool.isDrill() || tool.isSpot()) tool.centre_cutting = true;
    if (tool.isDrill()) tool.self_centring = tool.point_angle_deg >= kSelfCentringPointDeg;
    if (tool.type == ToolType::Reamer) tool.lead_mm = kUsualLeadShare * tool.diameter_mm;
    if (tool.isTap()) finishTap(foreign, pitch_mm);
    if (tool.type == ToolType::Bull && tool.corner_radius_mm == 0)
        foreign.unfit = "the corner radius of a bull nose is not told";
    if (tool.hasFlanks() && tool.included_angle_deg == 0)
        foreign.unfit = fmt::format("the angle of a {} is not told",
                                    tool.isCountersink() ? "countersink" : "chamfer mill");
    if (tool.max_plunge_mm == 0) tool.max_plunge_mm = usualPlungeMm(tool);
}

void stackHolder(ToolAssembly& tool) {
    double at_mm = tool.stick_out_mm;
    for (HolderCylinder& cylinder : tool.holder) {
        const double height_mm = cylinder.top_mm - cylinder.bottom_mm;
        cylinder.bottom_mm = at_mm;
        at_mm += height_mm;
        cylinder.top_mm = at_mm;
    }
}

}  // namespace stepmill::crib
