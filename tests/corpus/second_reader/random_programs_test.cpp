// Random programs through our reader and through LinuxCNC's interpreter: both refuse one, or both make the
// same of it, motion by motion.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "post/reader/interpreter.h"
#include "stepmill/core/error.h"
#include "support/canon_run.h"
#include "support/random_programs.h"
#include "support/second_reader.h"

namespace stepmill::test {
namespace {

using reader::Action;
using reader::Motion;
using reader::MotionKind;
using reader::Run;

constexpr int kDefaultPrograms = 500;
/// Positions agree to this beyond what the interpreter's four decimals leave open [mm].
constexpr double kSameMm = 1e-4;
constexpr double kSameFeed = 1e-3;

int fromEnvironment(const char* name, int otherwise) {
    const char* asked = std::getenv(name);
    return asked != nullptr ? std::atoi(asked) : otherwise;
}

std::string eightTools() {
    std::string table;
    for (int i = 1; i <= 8; ++i)
        table += fmt::format("T{} P{} Z0 D0.2 ;tool\n", i, i);
    return table;
}

bool agrees(const std::optional<double>& ours, double theirs, double tolerance) {
    return !ours || std::abs(*ours - theirs) <= tolerance;
}

/// Walks along what both make of a program. A rapid of ours whose ends are not known may be one of theirs
/// that goes nowhere.
class Comparison {
  public:
    Comparison(const Run& run, const std::vector<CanonEvent>& theirs) : run_(run), theirs_(theirs) {}

    /// The first difference; empty without any.
    std::string difference() {
        for (const Action& action : run_.actions) {
            const std::string found =
                std::visit([&](const auto& doing) { return compare(doing, action); }, action.doing);
            if (!found.empty()) return fmt::format("line {}: {}", action.line, found);
        }
        if (next_ < theirs_.size() && theirs_[next_].kind != CanonEvent::Kind::End)
            return fmt::format("LinuxCNC does {} things more", theirs_.size() - next_);
        return {};
    }

    int motions = 0;

  private:
    std::string compare(const reader::Comment&, const Action&) { return {}; }
    std::string compare(const reader::ProgramEnd&, const Action&) { return expect(CanonEvent::Kind::End); }
    std::string compare(const reader::ToolPrepared&, const Action&) { return {}; }
    std::string compare(const reader::ToolChange&, const Action& action) {
        const std::string found = expect(CanonEvent::Kind::ToolChange);
        return found.empty() && theirs_[next_ - 1].tool != run_.states[action.state].tool ? "another tool"
                                                                                          : found;
    }
    std::string compare(const reader::Dwell& dwell, const Action&) {
        const std::string found = expect(CanonEvent::Kind::Dwell);
        if (!found.empty()) return found;
        return std::abs(theirs_[next_ - 1].seconds - dwell.seconds) > 1e-3 ? "another dwell" : "";
    }

    std::string expect(CanonEvent::Kind kind) {
        if (next_ >= theirs_.size() || theirs_[next_].kind != kind)
            return fmt::format("LinuxCNC does something else than {}", static_cast<int>(kind));
        ++next_;
        return {};
    }

    std::string compare(const Motion& motion, const Action& action) {
        const bool known = motion.from.known() && motion.to.known();
        if (known && motion.kind != MotionKind::Arc && motion.from.x == motion.to.x &&
            motion.from.y == motion.to.y && motion.from.z == motion.to.z)
            return {};
        const auto kind = motion.kind == MotionKind::Rapid  ? CanonEvent::Kind::Rapid
                          : motion.kind == MotionKind::Feed ? CanonEvent::Kind::Feed
                                                            : CanonEvent::Kind::Arc;
        const bool there =
            next_ < theirs_.size() && theirs_[next_].kind == kind && ends(motion, theirs_[next_]);
        if (!there && !known) return {};
        // What goes nowhere once it is printed.
        const double printed_mm = next_ < theirs_.size() ? theirs_[next_].printed_mm : 0;
        if (!there && kind != CanonEvent::Kind::Arc && lengthOf(motion) <= kSameMm + 2.5 * printed_mm)
            return {};
        if (!there) return describe(motion, kind);
        ++motions;
        return compareSettings(motion, run_.states[action.state], theirs_[next_++]);
    }

    static double lengthOf(const Motion& motion) {
        return std::hypot(*motion.to.x - *motion.from.x, *motion.to.y - *motion.from.y,
                          *motion.to.z - *motion.from.z);
    }

    static bool ends(const Motion& motion, const CanonEvent& event) {
        const double tolerance = kSameMm + event.printed_mm;
        return agrees(motion.to.x, event.to[0], tolerance) && agrees(motion.to.y, event.to[1], tolerance) &&
               agrees(motion.to.z, event.to[2], tolerance);
    }

    std::string describe(const Motion& motion, CanonEvent::Kind kind) const {
        if (next_ >= theirs_.size()) return "LinuxCNC does nothing more";
        const CanonEvent& event = theirs_[next_];
        return fmt::format("ours {} to {} {} {}, LinuxCNC's {} to {} {} {}", static_cast<int>(kind),
                           motion.to.x.value_or(NAN), motion.to.y.value_or(NAN), motion.to.z.value_or(NAN),
                           static_cast<int>(event.kind), event.to[0], event.to[1], event.to[2]);
    }

    static std::string compareSettings(const Motion& motion, const MachineState& state,
                                       const CanonEvent& event) {
        if (motion.kind != MotionKind::Rapid &&
            std::abs(motion.feed_mm_per_min - event.feed_mm_per_min) >
                kSameFeed * (1 + motion.feed_mm_per_min) + event.printed_mm)
            return fmt::format("feed {}, LinuxCNC's {}", motion.feed_mm_per_min, event.feed_mm_per_min);
        const int spin = state.spin == Spin::Off ? 0 : state.spin == Spin::Clockwise ? 1 : -1;
        if (spin != event.spin || std::abs(state.speed_rpm - event.speed_rpm) > 1e-3)
            return "another spindle";
        if (state.mist != event.mist || state.flood != event.flood) return "another coolant";
        if (state.tool.value_or(0) != event.tool) return "another tool";
        if (motion.kind != MotionKind::Arc) return {};
        const double tolerance = kSameMm + event.printed_mm;
        if (std::hypot(motion.centre.x() - event.centre[0], motion.centre.y() - event.centre[1]) >
            2 * tolerance)
            return fmt::format("centre {} {}, LinuxCNC's {} {}", motion.centre.x(), motion.centre.y(),
                               event.centre[0], event.centre[1]);
        return (motion.ccw ? motion.turns : -motion.turns) == event.turns ? "" : "other turns";
    }

    const Run& run_;
    const std::vector<CanonEvent>& theirs_;
    std::size_t next_ = 0;
};

struct Tally {
    int alike = 0;
    int both_refuse = 0;
    int beyond = 0;
    int motions = 0;
};

void compareOne(unsigned seed, Tally& tally) {
    const RandomProgram program = randomProgram(seed);
    const SecondReader second(program.text, eightTools());
    std::optional<Run> run;
    std::string refusal;
    try {
        run = reader::runProgram(program.text, "random.ngc", Dialect::LinuxCnc);
    } catch (const Error& error) {
        refusal = error.what();
    }
    const std::string where =
        fmt::format("seed {}\nours: {}\nLinuxCNC: {}\n{}", seed, refusal, second.refusal, program.text);
    if (!program.beyond.empty()) {
        ++tally.beyond;
        EXPECT_FALSE(run) << program.beyond << " is refused by design; " << where;
        return;
    }
    ASSERT_EQ(run.has_value(), second.exit_code == 0) << where;
    if (!run) {
        ++tally.both_refuse;
        return;
    }
    const std::vector<CanonEvent> events = canonEvents(second.output);
    Comparison comparison(*run, events);
    EXPECT_EQ(comparison.difference(), "") << where;
    ++tally.alike;
    tally.motions += comparison.motions;
}

TEST(RandomPrograms, AreReadAsLinuxCncReadsThem) {
    STEPMILL_NEEDS_SECOND_READER();
    Tally tally;
    const int first = fromEnvironment("STEPMILL_RANDOM_FIRST", 1);
    const int programs = fromEnvironment("STEPMILL_RANDOM_PROGRAMS", kDefaultPrograms);
    for (int seed = first; seed < first + programs; ++seed) {
        compareOne(static_cast<unsigned>(seed), tally);
        if (testing::Test::HasFailure()) break;  // one program is enough to read
    }
    fmt::print("{} programs alike ({} motions), {} refused by both, {} beyond our reader\n", tally.alike,
               tally.motions, tally.both_refuse, tally.beyond);
}

}  // namespace
}  // namespace stepmill::test
