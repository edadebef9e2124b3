// Passes of form cutters at one height.

#include "stepmill/toolpath/form_passes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/nearer_than.h"
#include "stepmill/planar/unsure_offset.h"
#include "stepmill/planar/walk_inside.h"
#include "toolpath/needed_pieces.h"

namespace stepmill::toolpath {
namespace {

/// So many passes lie beside each other at most.
constexpr int kMostRings = 100;
/// Stretches without material that are shorter than this many radii are gone along rather than lifted over.
constexpr double kLevelBridgeRadii = 1;
/// Stretches that may wait for the next level are passed if they are shorter than so many radii: the tool is
/// no sooner across.
constexpr double kShortestWaitRadii = 4;
/// Whether a pass is needed is asked for stretches no longer than so many radii.
constexpr double kLongestEdgeRadii = 0.5;
/// Stairs farther over the tip than the cutter's form is high, and this much, ask for no pass [mm].
constexpr double kAboveFormMm = 1.0;

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

/// Farthest of the edge's ends and its middle from the nearest of others, or the limit.
double farthestFrom(const EdgeIndex& others, const Edge& edge, double limit_mm) {
    double farthest_mm = 0;
    for (const double share : {0.0, 0.5, 1.0})
        farthest_mm = std::max(farthest_mm, others.distanceTo(pointAt(edge, share), limit_mm));
    return farthest_mm;
}

/// How near to what stands at the slice's height a cutter's centre comes that meets it, its tip between two
/// heights; nothing above 0 where it meets nothing thicker than `least_mm` there.
double meetingMm(const StandingStairs::Slice& slice, const CutterForm& form, double top_z_mm,
                 double bottom_z_mm, double least_mm) {
    const bool out_of_reach = slice.z_mm - top_z_mm > form.heightMm() + kAboveFormMm;
    if (out_of_reach || slice.region.empty()) return 0;
    return form.radiusAt(slice.z_mm - bottom_z_mm) - least_mm;
}

}  // namespace

/// Tells where a cutter with its tip at one height meets stairs that are thicker than that.
class FormPasses::Meeting {
  public:
    Meeting(const StandingStairs& stairs, const CutterForm& form, double tip_z_mm, double least_mm) {
        for (const StandingStairs::Slice& slice : stairs.slices()) {
            const double radius_mm = meetingMm(slice, form, tip_z_mm, tip_z_mm, least_mm);
            if (radius_mm <= 0) continue;
            auto region = std::make_unique<IndexedRegion>(slice.region);
            const WalkInside walk(*region);
            near_.push_back({std::move(region), walk, radius_mm});
        }
    }

    bool nothing() const { return near_.empty(); }

    /// Of each edge along a way, not 0: there.
    std::vector<char> along(const std::vector<Edge>& way) {
        std::vector<char> meets;
        meets.reserve(way.size());
        for (const Edge& edge : way)
            meets.push_back(static_cast<char>(at(edge)));
        return meets;
    }

  private:
    bool at(const Edge& edge) {
        return std::any_of(near_.begin(), near_.end(),
                           [&](Near& near) { return near.walk.meets(edge, near.radius_mm); });
    }

    struct Near {
        std::unique_ptr<IndexedRegion> region;  ///< at one place, for the walk
        WalkInside walk;
        double radius_mm;
    };

    std::vector<Near> near_;
};

FormPasses::FormPasses(const FormCentres& centres, const CutterForm& form, const PassSpacing& spacing,
                       const ShallowGround& shallow, const Tolerances& tol)
    : centres_(centres), form_(form), shallow_(shallow), spacing_(spacing), tol_(tol) {}

bool FormPasses::mayPass(double top_z_mm, double bottom_z_mm, const StandingStairs& stairs) const {
    Region free;
    try {
        free = centres_.from(top_z_mm, bottom_z_mm);
    } catch (const UnsureOffset&) {
        return true;
    }
    if (free.empty()) return false;
    const EdgeIndex edges(free);
    const auto& slices = stairs.slices();
    return std::any_of(slices.begin(), slices.end(), [&](const StandingStairs::Slice& slice) {
        const double radius_mm = meetingMm(slice, form_, top_z_mm, bottom_z_mm, spacing_.skin_mm);
        return radius_mm > 0 && isNearer(free, edges, slice.region, radius_mm);
    });
}

FormLevel FormPasses::at(double tip_z_mm, const StandingStairs& stairs, std::optional<double> next_z_mm) {
    FormLevel level{tip_z_mm, {}, {}};
    Meeting meeting(stairs, form_, tip_z_mm, spacing_.skin_mm);
    if (meeting.nothing()) return level;
    level.free_centres = centres_.at(tip_z_mm);
    const ClearanceDiagram diagram(level.free_centres, tol_);
    Next next{next_z_mm, std::nullopt};
    Next none;
    const double shallow_next_mm = shallow_passed_mm_.value_or(tip_z_mm) - spacing_.over_shallow_mm;
    const bool passes_shallow = !next_z_mm || *next_z_mm < shallow_next_mm;
    if (passes_shallow || !shallow_passed_mm_) shallow_passed_mm_ = tip_z_mm;
    for (int ring = 0; ring < kMostRings; ++ring) {
        const bool along_wall = ring == 0;
        const Region centres_of =
            along_wall ? level.free_centres : diagram.offset(-ring * spacing_.step_over_mm);
        if (centres_of.empty()) break;
        std::vector<Path> passes;
        for (const Loop& loop : centres_of.loops)
            for (Path& piece : piecesOf(loop, meeting, along_wall ? next : none, passes_shallow))
                passes.push_back(std::move(piece));
        if (passes.empty() && ring > 0) break;
        if (along_wall) remember(tip_z_mm, passes);
        level.passes.insert(level.passes.begin(), passes.begin(), passes.end());
    }
    return level;
}

std::vector<Path> FormPasses::piecesOf(const Loop& loop, Meeting& meeting, Next& next,
                                       bool passes_shallow) const {
    const double radius_mm = form_.fullRadiusMm();
    const std::vector<Edge> edges = shortEdges(loop, kLongestEdgeRadii * radius_mm);
    std::vector<char> needed = meeting.along(edges);
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!passes_shallow && shallow_.isUnderOrRollsOff(pointAt(edges[i], 0.5))) needed[i] = 0;
    if (next.z_mm) {
        const std::vector<char> passed =
            bridged(edges, cannotWait(edges, needed, next), kShortestWaitRadii * radius_mm);
        for (std::size_t i = 0; i < edges.size(); ++i)
            needed[i] = static_cast<char>(needed[i] != 0 && passed[i] != 0);
    }
    return neededPieces(loop, edges, needed, kLevelBridgeRadii * radius_mm);
}

void FormPasses::remember(double tip_z_mm, const std::vector<Path>& passes) {
    std::erase_if(made_,
                  [&](const Made& made) { return made.tip_z_mm - tip_z_mm >= spacing_.along_wall_mm; });
    std::vector<Edge> edges;
    for (const Path& pass : passes)
        for (const auto& [from, segment] : eachEdge(pass))
            edges.push_back(makeEdge(from, segment));
    if (!edges.empty()) made_.push_back({tip_z_mm, EdgeIndex(std::move(edges))});
}

std::vector<char> FormPasses::cannotWait(const std::vector<Edge>& edges, const std::vector<char>& needed,
                                         Next& next) const {
    std::vector<char> passed(edges.size(), 1);
    for (const Made& made : made_) {
        const double down_mm = made.tip_z_mm - *next.z_mm;
        if (down_mm >= spacing_.along_wall_mm) continue;
        const double aside_mm =
            std::sqrt(spacing_.along_wall_mm * spacing_.along_wall_mm - down_mm * down_mm);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (needed[i] == 0 || passed[i] == 0) continue;
            const double left_mm = aside_mm - farthestFrom(made.edges, edges[i], aside_mm);
            if (left_mm <= 0) continue;
            if (!next.boundary) next.boundary = EdgeIndex(boundaryAt(*next.z_mm));
            passed[i] = static_cast<char>(farthestFrom(*next.boundary, edges[i], left_mm) >= left_mm);
        }
    }
    return passed;
}

/// Nothing where no sure free centres are found: no pass can wait for that level.
Region FormPasses::boundaryAt(double tip_z_mm) const {
    try {
        return centres_.at(tip_z_mm);
    } catch (const UnsureOffset&) {
        return {};
    }
}

}  // namespace stepmill::toolpath
