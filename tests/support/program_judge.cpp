#include "support/program_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace stepmill::test {
namespace {

constexpr double kCellMm = 0.5;
/// Boundaries are uncertain by a cell's diagonal.
constexpr double kRimMm = 0.75;
/// Lower or higher by more than this is a gouge or material left [mm].
constexpr double kDeepMm = 0.02;
/// Cells that must be so, for one alone may be an accident of sampling.
constexpr int kCells = 2;
/// A feed may be this much over what is planned: words are rounded, and the spindle a little slow.
constexpr double kFeedShare = 1.12;

/// Corners may be cut by so much [mm].
constexpr double kBlendMm = 0.02;

using Kind = CanonEvent::Kind;

/// "CANON_CONTINUOUS, 0.010000": by 0.01 mm at most; 0 is any.
bool roundsCorners(const std::string& path_control) {
    const std::size_t comma = path_control.find(',');
    if (path_control.find("CONTINUOUS") == std::string::npos) return false;
    const double by_mm = comma == std::string::npos ? 0 : std::atof(path_control.c_str() + comma + 1);
    return by_mm <= 0 || by_mm > kBlendMm;
}

/// The operation a comment begins.
std::string operationOf(const std::string& comment) {
    const std::size_t from = comment.find('S');
    if (from == std::string::npos || comment.find(".O") == std::string::npos) return {};
    return comment.substr(from, comment.find_first_of(" \"", from) - from);
}

/// What goes straight down faster than the tool may cut, and no faster than it may through air, as rapids.
std::vector<CanonEvent> withGlidesAsRapids(std::vector<CanonEvent> events, const JudgedSetup& setup) {
    std::optional<Vec3> at;
    for (CanonEvent& event : events) {
        const Vec3 to = placeOf(event);
        const auto found = setup.operations.find(operationOf(event.comment));
        const bool down = at && event.kind == Kind::Feed && to.head<2>() == at->head<2>() && to.z() < at->z();
        const bool glides = down && found != setup.operations.end() &&
                            event.feed_mm_per_min > kFeedShare * found->second.feed_mm_per_min &&
                            event.feed_mm_per_min <= kFeedShare * setup.glide_feed_mm_per_min;
        if (event.kind == Kind::Rapid || event.kind == Kind::Feed || event.kind == Kind::Arc) at = to;
        if (glides) event.kind = Kind::Rapid;
    }
    return events;
}

/// Settings and places that are wrong whatever is cut.
class SettingsJudge {
  public:
    explicit SettingsJudge(const JudgedSetup& setup) : setup_(setup) {}

    std::string judge(const std::vector<CanonEvent>& events) {
        for (const CanonEvent& event : events) {
            const std::string wrong = wrongIn(event);
            if (!wrong.empty()) return wrong;
            at_ = placeOf(event);
        }
        return {};
    }

  private:
    std::string wrongIn(const CanonEvent& event) {
        if (event.kind == Kind::ToolChange || event.kind == Kind::End) return atStop();
        if (event.kind == Kind::Dwell) return {};
        if (event.work_offset != 1) return "another work offset";
        if (fresh_ && event.to[2] < setup_.safe_z_mm) return "comes from a tool change too low";
        const bool feeds = event.kind != Kind::Rapid;
        // A new tool may go across at the height it came in at before its length is said.
        const bool stays_up = !feeds && at_ && std::abs(event.to[2] - at_->z()) < 1e-6;
        const bool moves_z = (fresh_ && !stays_up) || feeds;
        if (moves_z && std::abs(event.length_offset - setup_.length_mm_per_tool * event.tool) > 1e-3)
            return "another length offset";
        fresh_ = fresh_ && stays_up;
        for (std::size_t i = 0; i < 3; ++i) {
            low_[i] = std::min(low_[i], event.to[i]);
            high_[i] = std::max(high_[i], event.to[i]);
            if (high_[i] - low_[i] > setup_.travel_mm[i]) return "beyond the machine's travel";
        }
        return feeds ? wrongFeed(event) : "";
    }

    std::string atStop() {
        fresh_ = true;
        if (at_ && at_->z() < setup_.safe_z_mm) return "stops in the stock";
        return {};
    }

    std::string wrongFeed(const CanonEvent& event) {
        const auto found = setup_.operations.find(operationOf(event.comment));
        if (found == setup_.operations.end()) return {};
        const AllowedOperation& allowed = found->second;
        if (roundsCorners(event.path_control)) return "corners rounded";
        if (event.tool != allowed.tool) return "another tool";
        if (event.spin != 1 || event.speed_rpm <= 0) return "the spindle does not turn";
        if (event.speed_rpm > allowed.speed_rpm + 1) return "too fast a spindle";
        const double slow = std::min(1.0, event.speed_rpm / allowed.speed_rpm);
        if (event.feed_mm_per_min > kFeedShare * allowed.feed_mm_per_min * slow) return "too high a feed";
        if (event.mist != allowed.mist || event.flood != allowed.flood) return "another coolant";
        return {};
    }

    const JudgedSetup& setup_;
    std::optional<Vec3> at_;
    bool fresh_ = true;
    std::array<double, 3> low_{1e9, 1e9, 1e9};
    std::array<double, 3> high_{-1e9, -1e9, -1e9};
};

}  // namespace

Vec3 placeOf(const CanonEvent& event) {
    return {event.to[0], event.to[1], event.to[2]};
}

Toolpath pathOf(const Vec3& from, const CanonEvent& event) {
    Toolpath path;
    path.start = from;
    Move move;
    move.kind = event.kind == Kind::Rapid ? MoveKind::Rapid : MoveKind::Feed;
    move.to = placeOf(event);
    if (event.kind == Kind::Arc) {
        const Vec2 centre(event.centre[0], event.centre[1]);
        move.arc = Arc{centre, (from.head<2>() - centre).norm(), event.turns > 0};
        Move whole = move;
        whole.to = from;
        path.moves.assign(static_cast<std::size_t>(std::max(0, std::abs(event.turns) - 1)), whole);
    }
    path.moves.push_back(move);
    return path;
}

StockLeft leftBy(const std::vector<CanonEvent>& read, const JudgedSetup& setup) {
    const std::vector<CanonEvent> events = withGlidesAsRapids(read, setup);
    Box2 box;
    box.extend(Vec2(0, 0));
    box.extend(Vec2(setup.stock_mm[0], setup.stock_mm[1]));
    HeightMap map(box, kCellMm, -setup.stock_mm[2]);
    map.raise(makeRectangle(box.min(), box.max()), 0);
    StockLeft left;
    std::optional<Vec3> at;
    std::map<int, CutterProfile> cutters;
    for (const auto& [id, allowed] : setup.operations)
        cutters[allowed.tool] = allowed.cutter;
    for (const CanonEvent& event : events) {
        const bool moves = event.kind == Kind::Rapid || event.kind == Kind::Feed || event.kind == Kind::Arc;
        if (event.kind == Kind::ToolChange) at.reset();
        if (!moves) continue;
        // Places far off are told as beyond the travel; sampling the way there would take for ever.
        const bool near = placeOf(event).cwiseAbs().maxCoeff() < 2000;
        if (at && near)
            left.rapid_hits += map.run(pathOf(*at, event), cutters[event.tool], kRimMm).rapid_hits;
        if (near) at = placeOf(event);
    }
    const Raster& raster = map.raster();
    left.heights = map.heights();
    left.lowest = left.highest = left.heights;
    for (int row = 0; row < raster.rows(); ++row)
        for (int column = 0; column < raster.columns(); ++column) {
            const std::size_t cell = raster.index(column, row);
            raster.forDisc(raster.centre(column, row), kRimMm, [&](std::size_t near) {
                left.lowest[cell] = std::min(left.lowest[cell], left.heights[near]);
                left.highest[cell] = std::max(left.highest[cell], left.heights[near]);
            });
        }
    return left;
}

std::string worseThan(const StockLeft& before, const std::vector<CanonEvent>& events,
                      const JudgedSetup& setup) {
    const std::string wrong = SettingsJudge(setup).judge(withGlidesAsRapids(events, setup));
    if (!wrong.empty()) return wrong;
    const StockLeft now = leftBy(events, setup);
    if (now.rapid_hits > before.rapid_hits) return "a rapid in material";
    int gouged = 0;
    int left = 0;
    for (std::size_t i = 0; i < now.heights.size(); ++i) {
        gouged += now.heights[i] < before.lowest[i] - kDeepMm ? 1 : 0;
        left += now.heights[i] > before.highest[i] + kDeepMm ? 1 : 0;
    }
    if (gouged >= kCells) return fmt::format("{} cells gouged", gouged);
    if (left >= kCells) return fmt::format("{} cells left", left);
    return {};
}

bool sameRun(const std::vector<CanonEvent>& one, const std::vector<CanonEvent>& other) {
    return std::equal(
        one.begin(), one.end(), other.begin(), other.end(), [](const CanonEvent& a, const CanonEvent& b) {
            return a.kind == b.kind && a.to == b.to && a.centre == b.centre && a.turns == b.turns &&
                   a.feed_mm_per_min == b.feed_mm_per_min && a.seconds == b.seconds && a.spin == b.spin &&
                   a.speed_rpm == b.speed_rpm && a.mist == b.mist && a.flood == b.flood && a.tool == b.tool &&
                   a.length_offset == b.length_offset && a.work_offset == b.work_offset &&
                   a.path_control == b.path_control && operationOf(a.comment) == operationOf(b.comment);
        });
}

}  // namespace stepmill::test
