#include "support/canon_run.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stepmill::test {
namespace {

constexpr double kInch = 25.4;
constexpr double kPrinted = 0.5e-4;

class CanonReader {
  public:
    std::vector<CanonEvent> events;

    void obey(const CanonCall& said) {
        const std::string& call = said.name;
        const std::string& inside = said.inside;
        const std::vector<double> v = said.numbers();
        if (call == "USE_LENGTH_UNITS") unit_ = inside.find("INCH") != std::string::npos ? kInch : 1;
        if (call == "SET_FEED_MODE") per_rev_ = v.at(1) != 0;
        if (call == "SET_FEED_RATE") feed_ = v.at(0) * unit_;
        if (call == "SET_SPINDLE_SPEED") now_.speed_rpm = v.at(1);
        if (call == "START_SPINDLE_CLOCKWISE") now_.spin = 1;
        if (call == "START_SPINDLE_COUNTERCLOCKWISE") now_.spin = -1;
        if (call == "STOP_SPINDLE_TURNING") now_.spin = 0;
        if (call == "MIST_ON") now_.mist = true;
        if (call == "MIST_OFF") now_.mist = false;
        if (call == "FLOOD_ON") now_.flood = true;
        if (call == "FLOOD_OFF") now_.flood = false;
        if (call == "COMMENT" && inside.find(".O") != std::string::npos) now_.comment = inside;
        if (call == "USE_TOOL_LENGTH_OFFSET") now_.length_offset = v.at(2) * unit_;
        if (call == "SET_G5X_OFFSET") now_.work_offset = static_cast<int>(v.at(0));
        if (call == "SET_MOTION_CONTROL_MODE") now_.path_control = inside;
        // CHANGE_TOOL names a row of the table.
        if (call == "SELECT_TOOL") selected_ = static_cast<int>(v.at(0));
        if (call == "CHANGE_TOOL") now_.tool = selected_;
        if (call == "CHANGE_TOOL") add(CanonEvent::Kind::ToolChange);
        if (call == "PROGRAM_END") add(CanonEvent::Kind::End);
        if (call == "DWELL") add(CanonEvent::Kind::Dwell).seconds = v.at(0);
        if (call == "STRAIGHT_TRAVERSE") straight(CanonEvent::Kind::Rapid, v);
        if (call == "STRAIGHT_FEED") straight(CanonEvent::Kind::Feed, v);
        if (call == "ARC_FEED") arc(v);
    }

  private:
    CanonEvent& add(CanonEvent::Kind kind) {
        events.push_back(now_);
        CanonEvent& event = events.back();
        event.kind = kind;
        event.to = at_;
        event.printed_mm = kPrinted * unit_;
        const bool feeds = kind == CanonEvent::Kind::Feed || kind == CanonEvent::Kind::Arc;
        event.feed_mm_per_min = feeds ? feed_ * (per_rev_ ? now_.speed_rpm : 1) : 0;
        return event;
    }

    void straight(CanonEvent::Kind kind, const std::vector<double>& v) {
        const std::array<double, 3> to{v.at(0) * unit_, v.at(1) * unit_, v.at(2) * unit_};
        double way = 0;
        for (std::size_t i = 0; i < 3; ++i)
            way = std::max(way, std::abs(to[i] - at_[i]));
        const double open = kPrinted * (unit_ + unit_before_);
        at_ = to;
        unit_before_ = unit_;
        if (way > 1.01 * open) add(kind);
    }

    void arc(const std::vector<double>& v) {
        at_ = {v.at(0) * unit_, v.at(1) * unit_, v.at(5) * unit_};
        unit_before_ = unit_;
        CanonEvent& event = add(CanonEvent::Kind::Arc);
        event.centre = {v.at(2) * unit_, v.at(3) * unit_};
        event.turns = static_cast<int>(v.at(4));
    }

    CanonEvent now_;
    std::array<double, 3> at_{};
    double unit_ = 1;
    double unit_before_ = 1;  ///< when at_ was printed
    int selected_ = 0;
    double feed_ = 0;
    bool per_rev_ = false;
};

}  // namespace

std::vector<double> CanonCall::numbers() const {
    std::string text = inside;
    std::replace(text.begin(), text.end(), ',', ' ');
    std::vector<double> values;
    std::istringstream items(text);
    for (double value = 0; items >> value;)
        values.push_back(value);
    return values;
}

std::vector<CanonCall> canonCalls(const std::string& output) {
    std::vector<CanonCall> calls;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t open = line.find('(');
        if (open == std::string::npos) continue;
        std::istringstream head(line.substr(0, open));
        std::string number;
        CanonCall call;
        head >> number >> call.n_word >> call.name;
        call.inside = line.substr(open + 1, line.rfind(')') - open - 1);
        calls.push_back(call);
    }
    return calls;
}

std::vector<CanonEvent> canonEvents(const std::string& output) {
    CanonReader reader;
    for (const CanonCall& call : canonCalls(output))
        reader.obey(call);
    return reader.events;
}

}  // namespace stepmill::test
