#include "post/operation_start.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/comment.h"
#include "stepmill/core/units.h"
#include "stepmill/post/blending.h"

namespace stepmill {
namespace {

/// Said again where an operation begins. Without G49: the tool's length stays in force between operations.
constexpr const char* kModes = "G17 G40 G80 G90 G94 G54";

std::string coolantWord(Coolant coolant) {
    return coolant == Coolant::Flood ? "M8" : coolant == Coolant::Mist ? "M7" : "M9";
}

double roundedDown(double value, int decimals) {
    const double steps = std::pow(10.0, decimals);
    // Whole steps may be short of themselves by rounding.
    return std::floor(value * steps + 1e-9) / steps;
}

}  // namespace

OperationStart::OperationStart(const Job& job, const PostOptions& options, std::string& out,
                               MotionWriter& motion)
    : job_(job),
      inch_(options.inch),
      optional_stops_(options.optional_stops),
      rules_(rulesOf(options.dialect)),
      home_by_(job.machine.home_by.value_or(rules_.home_by)),
      out_(out),
      motion_(motion) {}

std::string OperationStart::safeLine() const {
    return fmt::format("{} {} G54", inch_ ? "G20" : "G21", rules_.safe_start);
}

void OperationStart::line(const std::string& text) {
    out_ += number_ + text + "\n";
    number_.clear();
}

void OperationStart::write(const JobOperation* before, const JobOperation& next) {
    const bool changes = before == nullptr || before->tool.id != next.tool.id;
    const bool stops = optional_stops_ && before != nullptr;
    const bool leaves = changes || stops;
    const std::string number = motion_.nextNumber();
    number_ = number + " ";
    starts_.push_back({next.id, number});
    if (leaves) leave();
    if (stops) line("M1");
    if (changes) putIn(next.tool, before == nullptr);
    // Wherever the change or the operator left the spindle.
    if (leaves) goHome();
    sayModes(next);
    const std::string length = rules_.tool_lengths ? fmt::format(" G43 H{}", next.tool.number) : "";
    motion_.approach(next.start, length, leaves && home_by_ != HomeBy::Nothing);
    if (!leaves && before->coolant != next.coolant && before->coolant != Coolant::Off) line("M9");
    line(coolantWord(next.coolant));
}

void OperationStart::leave() {
    line("M5");
    line("M9");
    goHome();
}

void OperationStart::goHome() {
    if (home_by_ == HomeBy::G53) line("G53 G0 Z0.");
    if (home_by_ != HomeBy::G28) return;
    line("G91 G28 Z0.");
    line("G90");
}

void OperationStart::putIn(const ToolAssembly& tool, bool first) {
    if (rules_.tool_changer) return line(fmt::format("T{} M6", tool.number));
    line(comment(
        fmt::format("Put in T{} {}, then set Z0 with it on the top of the stock", tool.number, tool.id)));
    line(fmt::format("T{}", tool.number));
    if (!first) line("M0");
}

void OperationStart::sayModes(const JobOperation& next) {
    line(kModes);
    if (const std::string words = pathWords(next); !words.empty()) line(words);
    line(fmt::format("S{:.0f} M3", next.speed_rpm));
}

std::string OperationStart::pathWords(const JobOperation& next) const {
    if (!rules_.blends_corners) return {};
    if (!rules_.own_words) return "G61";
    const double blend_mm = blendMm(next.leaves, job_.machine);
    const double blend =
        roundedDown(inch_ ? mmToInch(blend_mm) : blend_mm, inch_ ? kInchDecimals : kMetricDecimals);
    // G64 P0 would let it cut corners by as much as it likes.
    return blend > 0 ? fmt::format("G64 P{:g}", blend) : "G61";
}

void OperationStart::goToPartChange() {
    if (!job_.machine.part_change_mm || home_by_ == HomeBy::Nothing) return;
    const auto number = [&](double mm) { return inch_ ? mmToInch(mm) : mm; };
    const std::array<double, 2>& place = *job_.machine.part_change_mm;
    line(fmt::format("G53 G0 X{:.4f} Y{:.4f}", number(place[0]), number(place[1])));
}

void OperationStart::end() {
    line("M9");
    line("M5");
    goHome();
    goToPartChange();
    line("M30");
}

}  // namespace stepmill
