// Passes of form cutters at one height.

#include "stepmill/toolpath/form_passes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/walk_inside.h"
#include "toolpath/needed_pieces.h"

namespace stepmill::toolpath {
namespace {

/// So many passes lie beside each other at most.
constexpr int kMostRings = 100;
/// Stretches without material that are shorter than this many radii are gone along rather than lifted over.
constexpr double kLevelBridgeRadii = 1;
/// Whether a pass is needed is asked for stretches no longer than so many radii.
constexpr double kLongestEdgeRadii = 0.5;
/// Stairs farther over the tip than the cutter's form is high, and this much, ask for no pass [mm].
constexpr double kAboveFormMm = 1.0;

/// Tells where a cutter with its tip at one height meets stairs that are thicker than that.
class Meeting {
  public:
    Meeting(const StandingStairs& stairs, const CutterForm& form, double tip_z_mm, double least_mm) {
        for (const StandingStairs::Slice& slice : stairs.slices()) {
            const double over_mm = slice.z_mm - tip_z_mm;
            const double radius_mm = form.radiusAt(over_mm) - least_mm;
            if (over_mm > form.heightMm() + kAboveFormMm || radius_mm <= 0 || slice.region.empty()) continue;
            auto edges = std::make_unique<EdgeIndex>(slice.region);
            const WalkInside walk(slice.region, *edges);
            near_.push_back({std::move(edges), walk, radius_mm});
        }
    }

    bool nothing() const { return near_.empty(); }

    /// Edge by edge along a way.
    bool at(const Edge& way) {
        return std::any_of(near_.begin(), near_.end(),
                           [&](Near& near) { return near.walk.meets(way, near.radius_mm); });
    }

  private:
    struct Near {
        std::unique_ptr<EdgeIndex> edges;  ///< at one place, for the walk
        WalkInside walk;
        double radius_mm;
    };

    std::vector<Near> near_;
};

/// The loop's edges, none longer than that.
std::vector<Edge> shortEdges(const Loop& loop, double longest_mm) {
    std::vector<Edge> edges;
    for (const auto& [from, segment] : eachEdge(loop)) {
        const Edge edge = makeEdge(from, segment);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length(edge) / longest_mm)));
        for (int i = 0; i < pieces; ++i)
            if (const auto piece =
                    cutOut(edge, static_cast<double>(i) / pieces, static_cast<double>(i + 1) / pieces))
                edges.push_back(*piece);
    }
    return edges;
}

/// Pieces of a loop where the cutter meets stairs; the loop itself where it does all round.
std::vector<Path> piecesOf(const Loop& loop, Meeting& meeting, double radius_mm) {
    const std::vector<Edge> edges = shortEdges(loop, kLongestEdgeRadii * radius_mm);
    std::vector<char> needed;
    needed.reserve(edges.size());
    for (const Edge& edge : edges)
        needed.push_back(static_cast<char>(meeting.at(edge)));
    return neededPieces(loop, edges, needed, kLevelBridgeRadii * radius_mm);
}

}  // namespace

FormLevel formLevel(const FormCentres& centres, const StandingStairs& stairs, const CutterForm& form,
                    double tip_z_mm, double step_over_mm, double least_mm, const Tolerances& tol) {
    FormLevel level{tip_z_mm, {}, {}};
    Meeting meeting(stairs, form, tip_z_mm, least_mm);
    if (meeting.nothing()) return level;
    level.free_centres = centres.at(tip_z_mm);
    const ClearanceDiagram diagram(level.free_centres, tol);
    for (int ring = 0; ring < kMostRings; ++ring) {
        const Region centres_of = ring == 0 ? level.free_centres : diagram.offset(-ring * step_over_mm);
        if (centres_of.empty()) break;
        std::vector<Path> passes;
        for (const Loop& loop : centres_of.loops)
            for (Path& piece : piecesOf(loop, meeting, form.fullRadiusMm()))
                passes.push_back(std::move(piece));
        if (passes.empty() && ring > 0) break;
        level.passes.insert(level.passes.begin(), passes.begin(), passes.end());
    }
    return level;
}

}  // namespace stepmill::toolpath
