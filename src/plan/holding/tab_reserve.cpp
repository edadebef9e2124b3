// A frame round the part, and tabs that tie the part to it.

#include "plan/holding/tab_reserve.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "stepmill/access/collision.h"
#include "stepmill/core/error.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"

namespace stepmill {
namespace {

/// So much wider than its mill is the channel: its two walls are passes of their own, and chips get out.
constexpr double kChannelMills = 1.2;
/// Wider mills are quicker but cut more stock up: they come where no narrower one reaches down [mm].
constexpr double kWideMillMm = 12;
/// Narrower places of the frame bend away from the cutter [mm].
constexpr double kLeastFrameMm = 4;
/// A tab is so high, or half of the stock where that is less [mm],
constexpr double kTabHeightMm = 1;
/// and so wide [mm].
constexpr double kTabWidthMm = 6;
/// Tabs are no farther apart along the outline [mm]; a piece of the part has no fewer than that many.
constexpr double kTabSpacingMm = 120;
constexpr int kLeastTabs = 3;
/// Where the stock ends beside the part a tab has no frame to reach; fewer than that hold nothing.
constexpr std::size_t kLeastFramedTabs = 2;
/// A straight stretch is near where it is within this share of the spacing.
constexpr double kNearShare = 0.3;
/// A tab reaches so far into part and frame [mm].
constexpr double kIntoMm = 1;
/// A part that ends so near to the stock's bottom stands on it [mm].
constexpr double kOnBottomMm = 0.01;

/// A place on an outline with the direction out of the part.
struct TabPlace {
    Vec2 at;
    Vec2 out;
};

/// An edge of an outline and how far from the outline's start it begins [mm].
struct PlacedEdge {
    Edge edge;
    double from_mm = 0;
    double length_mm = 0;

    /// Within the edge, half a tab off its ends, nearest to a place along the outline; nothing where the
    /// edge is no straight one of a tab's length.
    std::optional<double> straightNear(double along_mm) const {
        if (edge.segment.arc || length_mm < kTabWidthMm) return std::nullopt;
        return std::clamp(along_mm, from_mm + kTabWidthMm / 2, from_mm + length_mm - kTabWidthMm / 2);
    }
    TabPlace placeAt(double along_mm) const {
        const double share = std::clamp((along_mm - from_mm) / length_mm, 0.0, 1.0);
        return {pointAt(edge, share), -leftOf(tangentAt(edge, share)).normalized()};
    }
};

std::vector<PlacedEdge> placedEdges(const Loop& outline) {
    std::vector<PlacedEdge> edges;
    double from_mm = 0;
    for (const Edge& edge : edgesOf(outline)) {
        edges.push_back({edge, from_mm, length(edge)});
        from_mm += edges.back().length_mm;
    }
    return edges;
}

TabPlace placeNear(const std::vector<PlacedEdge>& edges, double along_mm, double near_mm) {
    const PlacedEdge* on = &edges.back();
    double best_mm = along_mm;
    double distance_mm = near_mm;
    for (const PlacedEdge& one : edges) {
        const bool holds = along_mm >= one.from_mm && along_mm <= one.from_mm + one.length_mm;
        if (holds && distance_mm == near_mm) on = &one;
        const std::optional<double> straight = one.straightNear(along_mm);
        if (!straight || std::abs(*straight - along_mm) >= distance_mm) continue;
        on = &one;
        best_mm = *straight;
        distance_mm = std::abs(*straight - along_mm);
    }
    return on->placeAt(best_mm);
}

/// Evenly along an outline.
std::vector<TabPlace> tabPlaces(const Loop& outline) {
    const std::vector<PlacedEdge> edges = placedEdges(outline);
    const double around_mm = edges.back().from_mm + edges.back().length_mm;
    const int count = std::max(kLeastTabs, static_cast<int>(std::ceil(around_mm / kTabSpacingMm)));
    std::vector<TabPlace> places;
    for (int i = 0; i < count; ++i) {
        const double along_mm = (i + 0.5) * around_mm / count;
        places.push_back(placeNear(edges, along_mm, kNearShare * around_mm / count));
    }
    return places;
}

/// Of the mills that reach that deep, the wide ones last, the one with the most removal per width of the
/// channel it needs.
const ToolAssembly* channelMill(const ToolLibrary& library, const std::string& material, double depth_mm) {
    const ToolAssembly* best = nullptr;
    std::pair<bool, double> best_rank{false, 0};  // narrow, and how quick
    for (const ToolAssembly& tool : library.tools) {
        const CuttingData* cutting = tool.cuttingFor(material);
        if (tool.type != ToolType::Flat || cutting == nullptr || access::freeReachMm(tool) < depth_mm)
            continue;
        const std::pair rank{tool.diameter_mm <= kWideMillMm,
                             ratedRemovalMm3PerMin(*cutting) / tool.diameter_mm};
        if (rank <= best_rank) continue;
        best = &tool;
        best_rank = rank;
    }
    return best;
}

Region tabAt(const TabPlace& place, double channel_mm) {
    const Vec2 side = leftOf(place.out) * (kTabWidthMm / 2);
    const Vec2 inner = place.at - kIntoMm * place.out;
    const Vec2 outer = place.at + (channel_mm + kIntoMm) * place.out;
    const auto corner = [](const Vec2& p) { return Segment{snapToGrid(p), std::nullopt}; };
    const Vec2 start = snapToGrid(Vec2(inner - side));
    Region tab{{{start, {corner(outer - side), corner(outer + side), corner(inner + side), {start, {}}}}}};
    if (signedArea(tab.loops.front()) < 0) tab.loops.front() = reversed(tab.loops.front());
    return tab;
}

class FrameMaker {
  public:
    FrameMaker(const LayerStack& layers, const ToolLibrary& library, const std::string& material,
               const Tolerances& tol)
        : layers_(layers), tol_(tol) {
        findPart();
        const double depth_mm = layers.stock_top_z_mm - layers.stock_bottom_z_mm;
        const ToolAssembly* mill = channelMill(library, material, depth_mm);
        if (mill == nullptr)
            fail(fmt::format("no end mill for {} of {} clears a channel {:.4g} mm deep", material,
                             library.file, depth_mm));
        mill_mm_ = mill->diameter_mm;
        channel_mm_ = kChannelMills * mill_mm_;
    }

    std::vector<Prism> make() const {
        Region frame = frameOf(subtract(stock_, offset(shadow_, channel_mm_, tol_), tol_));
        if (area(frame) <= tol_.area_mm2)
            fail(
                fmt::format("the stock leaves no frame: expected {:.4g} mm or more of it beside the part "
                            "(--stock-margin), for a channel of {:.4g} mm and {:g} mm that stay",
                            channel_mm_ + kLeastFrameMm, channel_mm_, kLeastFrameMm));
        const double bottom_mm = layers_.stock_bottom_z_mm;
        const double high_mm =
            std::min(kTabHeightMm, (layers_.stock_top_z_mm - layers_.stock_bottom_z_mm) / 2);
        Region tabs = tabsTo(frame);
        return {{std::move(frame), layers_.stock_top_z_mm, bottom_mm},
                {std::move(tabs), bottom_mm + high_mm, bottom_mm}};
    }

  private:
    /// Of the stock beyond the channel what is wide enough, with its corners.
    Region frameOf(const Region& beyond) const {
        const Region core = offset(beyond, -kLeastFrameMm / 2, tol_);
        return core.empty() ? Region{} : intersect(beyond, offset(core, kLeastFrameMm, tol_), tol_);
    }

    /// With what the channel's mill leaves in the corners beside them: nobody would send a smaller one there.
    Region tabsTo(const Region& frame) const {
        const Region channel = subtract(stock_, unite(shadow_, frame, tol_), tol_);
        std::vector<Region> across;
        for (const Loop& outline : shadow_.loops) {
            const std::size_t before = across.size();
            for (const TabPlace& place : tabPlaces(outline)) {
                Region tab = tabAt(place, channel_mm_);
                if (area(intersect(tab, frame, tol_)) > tol_.area_mm2)
                    across.push_back(intersect(tab, channel, tol_));
            }
            if (across.size() < before + kLeastFramedTabs)
                fail(
                    fmt::format("{} tabs reach the frame, expected {} or more: leave stock beside all of the "
                                "part (--stock-margin)",
                                across.size() - before, kLeastFramedTabs));
        }
        const Region tabs = unite(across, tol_);
        const Region centres = offset(subtract(channel, tabs, tol_), -mill_mm_ / 2, tol_);
        const Region left =
            centres.empty() ? channel : subtract(channel, offset(centres, mill_mm_ / 2, tol_), tol_);
        std::vector<Region> standing;
        for (Region& piece : components(left))
            if (area(intersect(piece, tabs, tol_)) > tol_.area_mm2) standing.push_back(std::move(piece));
        return unite(standing, tol_);
    }

    [[noreturn]] static void fail(const std::string& why) {
        throw Error(ErrorCode::Usage, "--hold tabs", why);
    }

    void findPart() {
        std::vector<Region> parts;
        std::vector<Region> stocks;
        for (const Layer& layer : layers_.layers) {
            if (!layer.part.empty()) parts.push_back(layer.part);
            if (!layer.stock.empty()) stocks.push_back(layer.stock);
        }
        const Layer& lowest = layers_.layers.back();
        if (lowest.part.empty() || lowest.bottom_z_mm > layers_.stock_bottom_z_mm + kOnBottomMm)
            fail(
                "expected a part that stands on the stock's bottom, where tabs tie it (no --stock-margin "
                "below it)");
        shadow_ = unite(parts, tol_);
        std::erase_if(shadow_.loops, [](const Loop& loop) { return signedArea(loop) < 0; });
        stock_ = unite(stocks, tol_);
    }

    const LayerStack& layers_;
    const Tolerances& tol_;
    Region shadow_;  ///< the part from above, windows and holes filled
    Region stock_;
    double mill_mm_ = 0;  ///< diameter of the channel's mill
    double channel_mm_ = 0;
};

}  // namespace

CutPrisms tabbedFrame(const Setup& setup, const SliceOptions& slicing, const ToolLibrary& library,
                      const std::string& material, const Tolerances& tol) {
    return {setup.part_to_setup, FrameMaker(slice(setup, tol, slicing), library, material, tol).make()};
}

}  // namespace stepmill
