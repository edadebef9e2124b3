// What a machine does, sorted into a plan's operations.

#include "stepmill/post/read_program.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/dialect.h"
#include "post/reader/interpreter.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using reader::Action;
using reader::Comment;
using reader::Motion;
using reader::MotionKind;
using reader::Place;

/// "S1.O3" of "S1.O3 feature ..."; empty for other comments.
std::string operationOf(const std::string& comment) {
    std::string first = comment.substr(0, comment.find(' '));
    std::transform(first.begin(), first.end(), first.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return first.starts_with("S") && first.find(".O") != std::string::npos ? first : "";
}

MoveKind kindOf(const Vec3& from, const Vec3& to, bool arc) {
    if (to.z() >= from.z()) return MoveKind::Feed;
    return !arc && to.head<2>() == from.head<2>() ? MoveKind::Plunge : MoveKind::Ramp;
}

/// The highest place that the program names: stands for the top of the machine's travel.
double highestMm(const reader::Run& run) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Action& action : run.actions)
        if (const auto* motion = std::get_if<Motion>(&action.doing))
            highest = std::max(highest, motion->to.z.value_or(highest));
    return std::isfinite(highest) ? highest : 0;
}

class Gatherer {
  public:
    Gatherer(const reader::Run& run, const std::string& file) : run_(run), home_mm_(highestMm(run)) {
        program_.file = file;
        program_.states = run.states;
    }

    ReadProgram gather() {
        for (const Action& action : run_.actions) {
            action_ = &action;
            std::visit([this](const auto& doing) { take(doing); }, action.doing);
        }
        return std::move(program_);
    }

  private:
    void take(const Comment& comment) {
        const std::string id = operationOf(comment.text);
        if (id.empty()) return;
        ReadOperation operation;
        operation.id = id;
        operation.line = action_->line;
        operation.start = at_.value_or(Vec3::Zero());
        program_.operations.push_back(operation);
    }

    void take(const reader::Dwell& dwell) {
        if (!program_.operations.empty())
            program_.operations.back().dwells.push_back({dwell.seconds, action_->line, dwell.z_mm});
    }

    void take(const reader::ToolPrepared& prepared) {
        program_.tool_words.push_back({action_->line, operationId(), prepared.tool});
    }

    void take(const reader::ToolChange&) {
        stop(false);
        leaveWithToolBefore();
        at_.reset();
        at_home_ = false;
    }
    /// The way to a tool change is the last of the operation before, whatever comment stands over it.
    void leaveWithToolBefore() {
        std::vector<ReadOperation>& operations = program_.operations;
        if (operations.empty()) return;
        std::vector<ReadMove>& way = operations.back().moves;
        const bool only_leaves = std::all_of(way.begin(), way.end(), [](const ReadMove& read) {
            return read.fed.move.kind == MoveKind::Rapid;
        });
        if (!only_leaves) return;
        if (operations.size() > 1) {
            std::vector<ReadMove>& before = operations[operations.size() - 2].moves;
            before.insert(before.end(), way.begin(), way.end());
        }
        way.clear();
    }

    void take(const reader::ProgramEnd&) { stop(true); }

    void stop(bool is_end) {
        ReadStop stop;
        stop.line = last_line_ > 0 ? last_line_ : action_->line;
        stop.operation = operationId();
        stop.z_mm = left_at_mm_;
        stop.at_home = at_home_;
        stop.is_end = is_end;
        program_.stops.push_back(stop);
        left_at_mm_.reset();
        last_line_ = 0;
    }

    void take(const Motion& motion) {
        const std::optional<Vec3> from = placeOf(motion.from);
        at_ = placeOf(motion.to);
        if (from && at_) {
            addMoves(motion, *from, *at_);
        } else {
            addLeap(motion);
            if (at_) arrive(*at_, motion.to.z_home);
        }
        left_at_mm_ = motion.to.z;
        at_home_ = motion.to.z_home;
        last_line_ = action_->line;
    }

    std::optional<Vec3> placeOf(const Place& place) const {
        if (!place.knowsXY() || !(place.z || place.z_home)) return std::nullopt;
        return Vec3(*place.x, *place.y, place.z.value_or(home_mm_));
    }

    std::string operationId() const {
        return program_.operations.empty() ? "" : program_.operations.back().id;
    }

    void addLeap(const Motion& motion) {
        ReadLeap leap;
        leap.line = action_->line;
        leap.state = action_->state;
        leap.operation = operationId();
        leap.from_z_mm = motion.from.z;
        leap.to_z_mm = motion.to.z;
        leap.to_home = motion.to.z_home;
        leap.across = motion.across;
        leap.names_place = motion.names_place;
        program_.leaps.push_back(leap);
    }

    /// The tool comes back to a place that is known, over everything.
    void arrive(const Vec3& to, bool home) {
        if (program_.operations.empty()) return;
        ReadOperation& operation = program_.operations.back();
        if (operation.moves.empty()) {
            operation.start = to;
            return;
        }
        const Vec3 last = operation.moves.back().fed.move.to;
        addRapid(operation, {last.x(), last.y(), home_mm_}, true);
        addRapid(operation, {to.x(), to.y(), home_mm_}, true);
        addRapid(operation, to, home);
    }

    void addRapid(ReadOperation& operation, const Vec3& to, bool home) {
        const Vec3 from = operation.moves.empty() ? operation.start : operation.moves.back().fed.move.to;
        if (to == from) return;
        Move move;
        move.to = to;
        operation.moves.push_back({{move, 0}, action_->line, action_->state, 0, 0, home});
    }

    void addMoves(const Motion& motion, const Vec3& from, const Vec3& to) {
        const bool home = motion.to.z_home;
        if (program_.operations.empty()) {
            if (motion.from.known() && !home)
                throw Error(ErrorCode::InvalidCatalog,
                            fmt::format("{}, line {}", program_.file, action_->line),
                            "a motion before the first operation's comment");
            return;
        }
        ReadOperation& operation = program_.operations.back();
        if (motion.kind == MotionKind::Rapid) return addRapid(operation, to, home);
        if (motion.kind == MotionKind::Arc) return addArc(operation, motion, from, to);
        if (to != from) addFeed(operation, motion, kindOf(from, to, false), to, std::nullopt);
    }

    /// Whole turns first, each a circle; all rise evenly.
    void addArc(ReadOperation& operation, const Motion& motion, const Vec3& from, const Vec3& to) {
        const Vec2 start = from.head<2>();
        const Vec2 end = to.head<2>();
        const Vec2 centre = snapToGrid(motion.centre);
        const double radius_mm = snapToGrid(((start - centre).norm() + (end - centre).norm()) / 2);
        const Arc arc{centre, radius_mm, motion.ccw};
        const MoveKind kind = kindOf(from, to, true);
        const double sweep = std::abs(sweepAngle(start, end, arc));
        const double all = sweep + 2 * kPi * (motion.turns - 1);
        for (int turn = 1; turn < motion.turns; ++turn) {
            const double z = from.z() + (to.z() - from.z()) * 2 * kPi * turn / all;
            addFeed(operation, motion, kind, {start.x(), start.y(), snapToGrid(z)}, arc);
        }
        addFeed(operation, motion, kind, to, arc);
    }

    void addFeed(ReadOperation& operation, const Motion& motion, MoveKind kind, const Vec3& to,
                 const std::optional<Arc>& arc) {
        operation.moves.push_back({{{kind, to, arc, false}, motion.feed_mm_per_min},
                                   action_->line,
                                   action_->state,
                                   motion.radii_differ_mm,
                                   motion.pitch_mm,
                                   false});
    }

    const reader::Run& run_;
    double home_mm_;
    const Action* action_ = nullptr;
    ReadProgram program_;
    std::optional<Vec3> at_;
    std::optional<double> left_at_mm_;
    bool at_home_ = false;
    int last_line_ = 0;
};

}  // namespace

ReadProgram readProgram(std::string_view text, const std::string& file, Dialect dialect) {
    const reader::Run run = reader::runProgram(text, file, dialect);
    ReadProgram program = Gatherer(run, file).gather();
    program.has_length_offsets = rulesOf(dialect).tool_lengths;
    program.blends_corners = rulesOf(dialect).blends_corners;
    return program;
}

}  // namespace stepmill
