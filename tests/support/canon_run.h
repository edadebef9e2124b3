#pragma once

#include <array>
#include <string>
#include <vector>

namespace stepmill::test {

/// One thing LinuxCNC's interpreter has the machine do, in mm whatever the program's units, and what the
/// machine is set to by then.
struct CanonEvent {
    enum class Kind { Rapid, Feed, Arc, Dwell, ToolChange, End };
    Kind kind = Kind::Rapid;
    std::array<double, 3> to{};
    std::array<double, 2> centre{};
    int turns = 0;  ///< of an arc: positive counter-clockwise
    double feed_mm_per_min = 0;
    double seconds = 0;     ///< of a dwell
    double printed_mm = 0;  ///< what the four printed decimals leave open
    int spin = 0;           ///< 1 clockwise, -1 counter-clockwise
    double speed_rpm = 0;
    bool mist = false;
    bool flood = false;
    int tool = 0;
    double length_offset = 0;  ///< in z [mm]
    int work_offset = 1;       ///< 1 to 9: G54 to G59.3
    std::string path_control;  ///< as printed
    std::string comment;       ///< the last one before that begins an operation
};

/// A line of what rs274 -g prints: "  12 N5  STRAIGHT_FEED(1.0000, 2.0000, 3.0000, ...)".
struct CanonCall {
    std::string n_word;
    std::string name;
    std::string inside;  ///< the brackets

    /// What stands inside as numbers, up to the first word that is none.
    std::vector<double> numbers() const;
};

/// All calls of the interpreter's output, in order.
std::vector<CanonCall> canonCalls(const std::string& output);

/// Reads what rs274 -g prints. Motions that go nowhere are left out.
std::vector<CanonEvent> canonEvents(const std::string& output);

}  // namespace stepmill::test
