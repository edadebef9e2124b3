// What the machine is set to while it moves, and where it moves without the program saying from where.

#include "verify/prove_state.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "stepmill/post/blending.h"

namespace stepmill::verify {
namespace {

/// S words are rounded to whole numbers [1/min].
constexpr double kSpeedRoundingRpm = 1;

std::string workOffsetName(int number) {
    return number <= 6 ? fmt::format("G{}", 53 + number) : fmt::format("G59.{}", number - 6);
}

/// What is wrong, each kind once.
enum class Fault {
    Tool,
    LengthOffset,
    WorkOffset,
    Compensation,
    Plane,
    Path,
    FeedMode,
    Spin,
    Speed,
    Coolant
};

class StateProver {
  public:
    StateProver(const ReadProgram& program, const RecordedOperation& planned, const Findings& findings)
        : program_(program), planned_(planned), findings_(findings) {}

    void prove(const ReadMove& move) {
        const bool feeds = move.fed.move.kind != MoveKind::Rapid;
        if (!seen_.insert({move.state, feeds, move.home}).second) return;
        move_ = &move;
        const MachineState& state = program_.states[move.state];
        checkOffsets(state);
        checkModes(state);
        if (!feeds) return;
        checkSpindle(state);
        checkCoolant(state);
    }

  private:
    void tell(Fault fault, const std::string& text) {
        if (told_.insert(fault).second) findings_.add(move_->line, text);
    }

    void checkOffsets(const MachineState& state) {
        const int tool = planned_.tool.number;
        if (state.tool != tool)
            tell(Fault::Tool,
                 state.tool
                     ? fmt::format("runs with T{}, planned is T{} {}", *state.tool, tool, planned_.tool.id)
                     : fmt::format("runs before T{} {} is put in", tool, planned_.tool.id));
        if (program_.has_length_offsets && !move_->home && state.length_offset != tool)
            tell(Fault::LengthOffset, lengthOffsetText(state, tool));
        if (state.work_offset != kPlannedWorkOffset)
            tell(Fault::WorkOffset, state.work_offset ? fmt::format("runs in {}, planned is G54",
                                                                    workOffsetName(*state.work_offset))
                                                      : std::string("runs before G54"));
    }

    static std::string lengthOffsetText(const MachineState& state, int tool) {
        if (state.length_offset.value_or(kNoLengthOffset) == kNoLengthOffset)
            return fmt::format("runs without the length offset of its tool (G43 H{})", tool);
        return fmt::format("runs with length offset H{}, of its tool is H{}", *state.length_offset, tool);
    }

    void checkModes(const MachineState& state) {
        if (!state.compensation_off) tell(Fault::Compensation, "runs before G40");
        if (state.plane != Plane::XY)
            tell(Fault::Plane, state.plane ? "runs in another plane than G17" : "runs before G17");
        if (state.feed_mode != FeedMode::PerMinute)
            tell(Fault::FeedMode, state.feed_mode ? "runs in another feed mode than G94" : "runs before G94");
        checkPath(state);
    }

    void checkPath(const MachineState& state) {
        if (!program_.blends_corners) return;
        const bool blends = state.path_control == PathControl::Blend;
        if (!state.path_control) tell(Fault::Path, "runs before G61: the controller may round every corner");
        if (blends && state.blend_mm <= 0)
            tell(Fault::Path,
                 "runs with G64 without P, which rounds corners by as much as the controller likes");
        const double largest_mm = largestBlendMm(planned_.leaves);
        if (state.blend_mm > largest_mm)
            tell(Fault::Path, fmt::format("corners may be rounded by {:.4g} mm (G64 P); {:.4g} are proven",
                                          state.blend_mm, largest_mm));
    }

    void checkSpindle(const MachineState& state) {
        if (state.spin == Spin::Off) {
            tell(Fault::Spin, "feeds with the spindle off");
        } else if (state.spin == Spin::CounterClockwise) {
            tell(Fault::Spin, "feeds with the spindle turning backwards (M4)");
        } else if (state.speed_rpm <= 0) {
            tell(Fault::Speed, "feeds at S0");
        } else if (state.speed_rpm > planned_.speed_rpm + kSpeedRoundingRpm) {
            tell(Fault::Speed,
                 fmt::format("runs at S{:.0f}, planned is S{:.0f}", state.speed_rpm, planned_.speed_rpm));
        }
    }

    void checkCoolant(const MachineState& state) {
        const bool mist = planned_.coolant == Coolant::Mist;
        const bool flood = planned_.coolant == Coolant::Flood;
        if (state.mist == mist && state.flood == flood) return;
        const std::string found = state.mist && state.flood ? "mist and flood"
                                  : state.mist              ? "mist"
                                  : state.flood             ? "flood"
                                                            : "off";
        tell(Fault::Coolant,
             fmt::format("feeds with coolant {}, planned is {}", found, toString(planned_.coolant)));
    }

    const ReadProgram& program_;
    const RecordedOperation& planned_;
    const Findings& findings_;
    const ReadMove* move_ = nullptr;
    std::set<std::tuple<std::size_t, bool, bool>> seen_;
    std::set<Fault> told_;
};

/// What is wrong with a leap; empty: nothing.
std::string faultOf(const ReadProgram& program, const ReadLeap& leap, double safe_z_mm) {
    const MachineState& state = program.states[leap.state];
    const bool matters = leap.across || leap.to_z_mm || leap.to_home;
    if (!matters) return {};
    if (leap.across && leap.from_z_mm && *leap.from_z_mm < safe_z_mm)
        return fmt::format("goes away across from Z{:.4f}, below the top of stock and fixtures",
                           *leap.from_z_mm);
    if (leap.to_z_mm && *leap.to_z_mm < safe_z_mm)
        return fmt::format(
            "comes from a place that is not known to Z{:.4f}, below the top of stock and fixtures",
            *leap.to_z_mm);
    if (leap.to_home && !state.compensation_off) return "goes home before G40";
    if (!leap.names_place) return {};
    if ((leap.across || leap.to_z_mm) && state.work_offset != kPlannedWorkOffset)
        return "goes to a place in another work offset than G54";
    if (leap.to_z_mm && program.has_length_offsets && (!state.tool || state.length_offset != state.tool))
        return "goes to a height without the length offset of the tool in the spindle (G43 H)";
    return {};
}

std::string faultOf(const ReadStop& stop, double safe_z_mm, bool has_home) {
    const char* before_what = stop.is_end ? "program ends" : "tool changes";
    if (has_home && !stop.at_home)
        return fmt::format("the spindle is not taken to the top of its travel before the {}", before_what);
    if (!stop.z_mm || *stop.z_mm >= safe_z_mm) return {};
    return fmt::format("ends at Z{:.4f}, below the top of stock and fixtures, before the {}", *stop.z_mm,
                       before_what);
}

}  // namespace

void proveStates(const ReadProgram& program, const ReadOperation& operation, const RecordedOperation& planned,
                 const Findings& findings) {
    StateProver prover(program, planned, findings);
    for (const ReadMove& move : operation.moves)
        prover.prove(move);
}

void proveLeaps(const ReadProgram& program, double safe_z_mm, bool has_home,
                std::vector<ProofFailure>& failures) {
    for (const ReadLeap& leap : program.leaps)
        if (const std::string fault = faultOf(program, leap, safe_z_mm); !fault.empty())
            failures.push_back({program.file, leap.line, leap.operation, fault});
    for (const ReadStop& stop : program.stops)
        if (const std::string fault = faultOf(stop, safe_z_mm, has_home); !fault.empty())
            failures.push_back({program.file, stop.line, stop.operation, fault});
}

void proveTools(const ReadProgram& program, const std::set<int>& tools, std::vector<ProofFailure>& failures) {
    for (const ReadToolWord& word : program.tool_words)
        if (tools.count(word.tool) == 0)
            failures.push_back({program.file, word.line, word.operation,
                                fmt::format("T{} is no tool of this setup", word.tool)});
}

void TravelProver::prove(const ReadProgram& program) {
    for (const ReadOperation& operation : program.operations) {
        if (operation.moves.empty()) continue;
        extend(operation.start, program.file, operation.line, operation.id);
        for (const ReadMove& move : operation.moves)
            extend(move.fed.move.to, program.file, move.line, operation.id);
    }
}

void TravelProver::extend(const Vec3& place, const std::string& file, int line,
                          const std::string& operation) {
    keepOffColumn(place, file, line, operation);
    box_.extend(place);
    for (int axis = 0; axis < 3; ++axis) {
        const double travel_mm = machine_.travel_mm[static_cast<std::size_t>(axis)];
        const double needed_mm = box_.sizes()[axis];
        bool& told = told_[static_cast<std::size_t>(axis)];
        if (told || travel_mm <= 0 || needed_mm <= travel_mm + kSamePostedHeightMm) continue;
        told = true;
        failures_.push_back({file, line, operation,
                             fmt::format("the programs of the setup now go over {:.4g} mm along {}, the "
                                         "machine travels {:.4g} mm",
                                         needed_mm, "XYZ"[axis], travel_mm)});
    }
}

void TravelProver::keepOffColumn(const Vec3& place, const std::string& file, int line,
                                 const std::string& operation) {
    const double needed_mm = back_mm_ - place.y() + machine_.side_clearance_mm;
    const double column_mm = machine_.column_behind_mm;
    if (told_of_column_ || column_mm <= 0 || needed_mm <= column_mm + kSamePostedHeightMm) return;
    told_of_column_ = true;
    failures_.push_back({file, line, operation,
                         fmt::format("stock and fixtures need {:.4g} mm behind the spindle here, the column "
                                     "stands {:.4g} mm behind it",
                                     needed_mm, column_mm)});
}

}  // namespace stepmill::verify
