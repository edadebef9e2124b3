// Order of the passes of a layer and the ways between them.

#include "toolpath/layer_script.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/path_parts.h"
#include "toolpath/ring_family.h"
#include "toolpath/swept_ground.h"

namespace stepmill::toolpath {

namespace {

/// Links are tried to this many of the nearest passes before the cutter is lifted.
constexpr std::size_t kLinkTrials = 8;
/// A straight link to a neighbouring pass may be this many step-overs long.
constexpr double kNeighbourLink = 2.0;
/// A helix or ramp smaller than this is not worth the name [mm].
constexpr double kLeastEntryMm = 0.05;
/// A ramp shorter than it should be by this share is none the steeper.
constexpr double kLeastLeadShare = 1e-9;
constexpr double kRounding = 1e-9;

/// Where a pass would be joined.
struct Joint {
    int pass = 0;
    double distance_mm = 0;
    NearestPoint at;
    bool backwards = false;
};

class LayerPlanner {
  public:
    LayerPlanner(const LayerTask& task, const RingFamily::Component& component, const Entry& entry,
                 const std::vector<Pass>& passes)
        : task_(task.clearing),
          standing_(task.standing),
          component_(component),
          passes_(passes),
          entry_(entry),
          radius_mm_(task.radius_mm),
          step_over_mm_(task.step_over_mm),
          rates_(task.rates),
          tol_(task.tol),
          passes_ground_(task.clearing, task.radius_mm),
          swept_(task.clearing, task.radius_mm),
          before_(swept_),
          done_(passes.size(), false),
          was_cut_(passes.size(), false),
          spot_of_(passes.size(), 0),
          looked_at_(passes.size(), false),
          left_(static_cast<int>(passes.size())) {
        dropNeedless();
        passes_ground_ = groundOfPasses(-1);
    }

    LayerScript plan() {
        for (dropCleared(); left_ > 0; dropCleared())
            if (!linkOn()) goTo();
        if (script_.empty()) return {};
        // The layers after the first begin where this one ends.
        STEPMILL_CHECK(!descents_.empty() && descents_.front().step == 0, "a layer begins from above");
        LayerScript script;
        script.apart = blocksApart();
        script.whole.begin = descents_.front().to;
        script.whole.end = at_;
        script.whole.next_over = overWay(at_, script.whole.begin, swept_);
        for (const Descent& descent : descents_)
            setOver(script_[descent.step], overWay(descent.from, descent.to, swept_));
        script.whole.steps = std::move(script_);
        return script;
    }

  private:
    const Pass& pass(int i) const { return passes_[static_cast<std::size_t>(i)]; }
    bool isDone(int i) const { return done_[static_cast<std::size_t>(i)]; }
    bool isReady(int i) const {
        return std::all_of(pass(i).after.begin(), pass(i).after.end(), [&](int j) { return isDone(j); });
    }

    Joint jointWith(int i, const Vec2& from) const {
        const Path& path = pass(i).path;
        if (pass(i).closed) {
            const NearestPoint at = nearestOn(path, from);
            return {i, at.distance_mm, at, false};
        }
        const bool backwards = pass(i).reversible && (from - path.end()).norm() < (from - path.start).norm();
        const Vec2& point = backwards ? path.end() : path.start;
        const double distance = (from - point).norm();
        return {i, distance, {distance, 0, 0, point}, backwards};
    }

    bool startsInAir(const Joint& joint) const {
        return joint.backwards ? pass(joint.pass).ends_in_air : pass(joint.pass).starts_in_air;
    }

    /// Passes not yet cut, nearest to `from` first.
    std::vector<Joint> waiting(const Vec2& from, bool ready) const {
        std::vector<Joint> joints;
        for (int i = 0; i < static_cast<int>(passes_.size()); ++i)
            if (!isDone(i) && isReady(i) == ready) joints.push_back(jointWith(i, from));
        std::stable_sort(joints.begin(), joints.end(),
                         [](const Joint& a, const Joint& b) { return a.distance_mm < b.distance_mm; });
        return joints;
    }

    bool isFree(const Vec2& a, const Vec2& b) const { return isFreeWay(component_, a, b, tol_); }

    /// What the passes still to be cut will sweep, but for one.
    SweptGround groundOfPasses(int without) const {
        SweptGround ground(task_, radius_mm_);
        for (int i = 0; i < static_cast<int>(passes_.size()); ++i) {
            if (isDone(i) || i == without) continue;
            for (const Edge& edge : edgesOf(pass(i).path))
                ground.add(edge);
        }
        return ground;
    }

    /// Would the pass take skins alone?
    bool isNeedless(const SweptGround& ground, const Path& path) const {
        const std::vector<Edge> edges = edgesOf(path);
        return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
            return ground.isClear(edge, kSkinSlivers * tol_.sliver_mm);
        });
    }

    void settle(int i) {
        done_[static_cast<std::size_t>(i)] = true;
        --left_;
    }

    /// Innermost rings whose ground the next ones out take as well: these are then the ones that cut full
    /// width, as the innermost always does.
    void dropNeedless() {
        for (int i = 0; i < static_cast<int>(passes_.size()); ++i) {
            const bool innermost = pass(i).closed && !pass(i).neighbours.empty() &&
                                   std::all_of(pass(i).neighbours.begin(), pass(i).neighbours.end(),
                                               [&](int j) { return pass(j).level < pass(i).level; });
            if (!isDone(i) && innermost && isNeedless(groundOfPasses(i), pass(i).path)) settle(i);
        }
    }

    /// Passes whose turn it is over ground that is proven clear by now: an open side's, when the next one in
    /// has reached the edge before.
    void dropCleared() {
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            if (done_[i] || looked_at_[i] || !isReady(static_cast<int>(i))) continue;
            looked_at_[i] = true;
            if (isNeedless(swept_, passes_[i].path)) settle(static_cast<int>(i));
        }
    }

    // At depth -------------------------------------------------------------------------------------------

    bool linkOn() {
        if (last_ < 0) return false;
        const std::vector<Joint> joints = waiting(at_, true);
        for (std::size_t i = 0; i < std::min(joints.size(), kLinkTrials); ++i)
            if (tryLink(joints[i])) return true;
        return false;
    }

    bool tryLink(const Joint& joint) {
        const Pass& next = pass(joint.pass);
        const bool neighbour = std::count(next.neighbours.begin(), next.neighbours.end(), last_) > 0 &&
                               joint.distance_mm <= kNeighbourLink * step_over_mm_;
        if (!neighbour && !isShorter(joint)) return false;
        if (!isFree(at_, joint.at.point)) return false;
        const bool cleared = swept_.isClear(at_, joint.at.point);
        if (!neighbour && !cleared) return false;
        if (!neighbour) descents_.back().needs_others = true;
        link(joint.at.point, cleared);
        cut(joint);
        return true;
    }

    /// Is the way at depth quicker than up, across and down again?
    bool isShorter(const Joint& joint) const {
        const Vec2& to = joint.at.point;
        const double approach_mm = before_.isClear(to, to) ? rates_.deep_approach_mm : rates_.approach_mm;
        const double over = (2 * rates_.lift_mm + joint.distance_mm) / rates_.rapid_mm_per_min +
                            approach_mm / rates_.plunge_feed_mm_per_min;
        return joint.distance_mm / rates_.feed_mm_per_min <= over;
    }

    // From above -----------------------------------------------------------------------------------------

    /// Lifts the cutter and comes down for another pass: where it can in air, else as the entry of the
    /// component says, at worst along the pass itself.
    void goTo() {
        for (const bool ready : {true, false}) {
            for (const Joint& joint : waiting(at_, ready))
                if (comeDownInAir(joint)) return;
            for (const Joint& joint : waiting(at_, ready))
                if (enter(joint, ready)) return;
        }
        const std::vector<Joint> joints = waiting(at_, true);
        STEPMILL_CHECK(!joints.empty(), "the order of passes has a cycle");
        rampInto(joints.front());
    }

    /// Down along the pass itself, which is then cut.
    void rampInto(const Joint& joint) {
        const RampAlong ramp = rampAlong(rotated(joint), pass(joint.pass).closed, rates_.descent_mm);
        descend(ramp, ramp.lead.start);
        finish(joint.pass, ramp.curve);
    }

    bool comeDownInAir(const Joint& joint) {
        const Pass& next = pass(joint.pass);
        const bool in_air = startsInAir(joint);
        if (in_air || swept_.isClear(joint.at.point, joint.at.point)) {
            comeDown(joint.at.point, !in_air);
            cut(joint);
            return true;
        }
        for (const int neighbour : next.neighbours) {
            if (!was_cut_[static_cast<std::size_t>(neighbour)]) continue;
            // The pair of points that is nearest from the pass' start or, when closed, from the last place.
            const NearestPoint landing = nearestOn(pass(neighbour).path, joint.at.point);
            const Joint from_there = jointWith(joint.pass, landing.point);
            if (from_there.distance_mm > kNeighbourLink * step_over_mm_) continue;
            if (!isFree(landing.point, from_there.at.point)) continue;
            comeDown(landing.point, true);
            link(from_there.at.point, false);
            cut(from_there);
            return true;
        }
        return false;
    }

    bool enter(const Joint& joint, bool ready) {
        const Entry& entry = entry_;
        const bool open = entry.kind == EntryKind::OpenEdge;
        // Through material a component is entered once a layer, and only for a pass whose turn it is.
        if (!open && (!ready || entered_)) return false;
        if (rampIsBetter(entry, joint)) {
            entered_ = true;
            rampInto(joint);
            return true;
        }
        const Joint from_entry = jointWith(joint.pass, entry.at);
        // An open edge's entry may lie outside the component, clear of everything.
        const auto is_free = [&](const Vec2& a, const Vec2& b) {
            return open ? standing_.isClear(a, b) : isFree(a, b);
        };
        if (!is_free(entry.at, from_entry.at.point)) return false;
        if (!goDown(entry, from_entry.at.point)) return false;
        entered_ = true;
        const Joint from_here = jointWith(joint.pass, at_);
        const bool near = is_free(at_, from_here.at.point);
        const Joint& best = near ? from_here : from_entry;
        if (!near) link(entry.at, true);
        if (open) linkThroughAir(best.at.point);
        link(best.at.point, false);
        cut(best);
        return true;
    }

    /// A ring saves the way from a helix or ramp; from an open edge the way to it may be longer than a ramp.
    bool rampIsBetter(const Entry& entry, const Joint& joint) const {
        const Path& path = pass(joint.pass).path;
        if (pass(joint.pass).reversible && entry.kind != EntryKind::Plunge &&
            entry.kind != EntryKind::OpenEdge)
            return isAsWideAsEntry(Path{path.start, {path.segments.front()}});
        if (!pass(joint.pass).closed || entry.kind == EntryKind::Plunge) return false;
        if (entry.kind != EntryKind::OpenEdge) return isAsWideAsEntry(path);
        return jointWith(joint.pass, entry.at).distance_mm > rates_.descent_mm &&
               boundingBox(path).sizes().maxCoeff() >= 2 * radius_mm_;
    }

    /// A curve narrower than the helix or ramp found for the tool would be steep for its middle, where it
    /// may not cut.
    bool isAsWideAsEntry(const Path& curve) const {
        const double width = boundingBox(curve).sizes().maxCoeff();
        const double entry_width = entry_.kind == EntryKind::Helix ? 2 * entry_.helix_radius_mm
                                                                   : (entry_.ramp_to - entry_.at).norm();
        // A helix that fills its room is a ring but for the guard.
        return width >= entry_width - 2 * onBoundaryMm(tol_);
    }

    /// Adds the way down; false when the entry does not keep the guard from the walls.
    bool goDown(const Entry& entry, const Vec2& towards) {
        switch (entry.kind) {
            case EntryKind::Helix:
                return goDownHelix(towards);
            case EntryKind::Ramp:
                return goDownRamp();
            case EntryKind::Plunge:
                descend(PlungeDown{entry.at}, entry.at);
                swept_.add(makeLine(entry.at, entry.at));
                return true;
            case EntryKind::OpenEdge:
                comeDown(entry.at, true);
                return true;
        }
        return false;
    }

    bool goDownHelix(const Vec2& towards) {
        const double room = distanceToBoundary(component_.region, entry_.at);
        const double radius = snapToGrid(std::min(entry_.helix_radius_mm, room - tol_.guard_mm - kGridMm));
        if (radius < kLeastEntryMm) return false;
        const Vec2 away = towards - entry_.at;
        const Vec2 direction = away.norm() > kGridMm ? Vec2(away.normalized()) : Vec2(1, 0);
        const Vec2 start = snapToGrid(Vec2(entry_.at + radius * direction));
        const Vec2 opposite = snapToGrid(Vec2(2 * entry_.at - start));
        const Arc arc{entry_.at, radius, true};
        RampAlong helix = rampAlong(Path{start, {{opposite, arc}, {start, arc}}}, true, rates_.descent_mm);
        helix.level = needsLevel(edgesOf(helix.curve));
        descend(helix, helix.lead.start);
        at_ = start;
        return true;
    }

    bool goDownRamp() {
        const Edge ramp = makeLine(entry_.at, entry_.ramp_to);
        if ((entry_.ramp_to - entry_.at).norm() < kLeastEntryMm) return false;
        if (component_.walls.anyNearer(ramp, tol_.guard_mm - 2 * kGridMm)) return false;
        descend(RampDown{entry_.at, entry_.ramp_to, needsLevel({ramp})}, entry_.at);
        return true;
    }

    /// Does the slope a descent leaves have to be taken away, since no pass does? Ground that is not made
    /// level does not count as swept.
    bool needsLevel(const std::vector<Edge>& descent) {
        const bool level = !std::all_of(descent.begin(), descent.end(),
                                        [&](const Edge& edge) { return passes_ground_.isClear(edge); });
        if (level)
            for (const Edge& edge : descent)
                swept_.add(edge);
        return level;
    }

    /// The first part of a way in over an open edge, up to where the disc meets the target.
    void linkThroughAir(const Vec2& to) {
        const Vec2 from = at_;
        double air = 0;
        double cutting = 1;
        for (int i = 0; i < 20; ++i) {
            const double middle = (air + cutting) / 2;
            const bool in_air =
                distanceToRegion(task_.target, Vec2(from + middle * (to - from))) >= radius_mm_;
            (in_air ? air : cutting) = middle;
        }
        if (air > 0) link(snapToGrid(Vec2(from + air * (to - from))), true);
    }

    // Height of the ways above --------------------------------------------------------------------------

    /// A way over the ground from where the cutter was to where it comes down.
    struct Descent {
        std::size_t step;
        Vec2 from;
        Vec2 to;
        /// It, or a link after it, counts on ground that was cleared before.
        bool needs_others;
    };

    void comeDown(const Vec2& at, bool needs_others) {
        descend(ComeDown{at, Over::Retract, before_.isClear(at, at)}, at, needs_others);
    }

    void descend(const ScriptStep& step, const Vec2& to, bool needs_others = true) {
        descents_.push_back({script_.size(), at_, to, needs_others});
        script_.push_back(step);
        at_ = to;
    }

    /// The whole layer has been cut when the next one asks: what it clears, it clears for the one below.
    Over overWay(const Vec2& from, const Vec2& to, const SweptGround& ground) const {
        if (!standing_.isClearForAll(from, to)) return Over::Retract;
        return ground.isClear(from, to) ? Over::Layer : Over::Top;
    }

    // Blocks --------------------------------------------------------------------------------------------

    /// Steps from one descent to the next one form a spot. Spots belong together where one counts on ground
    /// that the other clears, or has to wait for it.
    std::vector<LayerBlock> blocksApart() const {
        const std::vector<std::size_t> block_of = blocksOfSpots();
        const std::size_t count = 1 + *std::max_element(block_of.begin(), block_of.end());
        std::vector<LayerBlock> blocks;
        for (std::size_t block = 0; count > 1 && block < count; ++block)
            blocks.push_back(makeBlock(block, block_of));
        return blocks;
    }

    /// Numbered in the order of their first spots.
    std::vector<std::size_t> blocksOfSpots() const {
        std::vector<std::size_t> block_of(descents_.size());
        std::iota(block_of.begin(), block_of.end(), std::size_t{0});
        const auto join = [&](std::size_t a, std::size_t b) {
            const auto [into, from] = std::minmax(block_of[a], block_of[b]);
            std::replace(block_of.begin(), block_of.end(), std::size_t{from}, std::size_t{into});
        };
        for (std::size_t spot = 0; spot < descents_.size(); ++spot) {
            if (!descents_[spot].needs_others) continue;
            for (std::size_t before = 0; before < spot; ++before)
                join(before, spot);
        }
        for (std::size_t i = 0; i < passes_.size(); ++i)
            for (const int j : passes_[i].after)
                if (was_cut_[i] && was_cut_[static_cast<std::size_t>(j)])
                    join(spot_of_[i], spot_of_[static_cast<std::size_t>(j)]);
        std::vector<std::size_t> names = block_of;
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
        for (std::size_t& block : block_of)
            block =
                static_cast<std::size_t>(std::lower_bound(names.begin(), names.end(), block) - names.begin());
        return block_of;
    }

    LayerBlock makeBlock(std::size_t block, const std::vector<std::size_t>& block_of) const {
        LayerBlock made;
        SweptGround ground(task_, radius_mm_);
        for (std::size_t i = 0; i < passes_.size(); ++i)
            if (was_cut_[i] && block_of[spot_of_[i]] == block)
                for (const Edge& edge : edgesOf(passes_[i].path))
                    ground.add(edge);
        bool first = true;
        for (std::size_t spot = 0; spot < descents_.size(); ++spot) {
            if (block_of[spot] != block) continue;
            const Descent& descent = descents_[spot];
            const bool last_spot = spot + 1 == descents_.size();
            const std::size_t next = last_spot ? script_.size() : descents_[spot + 1].step;
            const std::size_t at = made.steps.size();
            made.steps.insert(made.steps.end(), script_.begin() + static_cast<std::ptrdiff_t>(descent.step),
                              script_.begin() + static_cast<std::ptrdiff_t>(next));
            if (first)
                made.begin = descent.to;
            else
                setOver(made.steps[at], overWay(made.end, descent.to, ground));
            first = false;
            made.end = last_spot ? at_ : descents_[spot + 1].from;
        }
        made.next_over = overWay(made.end, made.begin, ground);
        return made;
    }

    // Script ---------------------------------------------------------------------------------------------

    void link(const Vec2& to, bool in_air) {
        if ((to - at_).norm() < kGridMm / 2) return;
        script_.push_back(Link{to, in_air});
        swept_.add(makeLine(at_, to));
        at_ = to;
    }

    Path rotated(const Joint& joint) const {
        const Pass& next = pass(joint.pass);
        if (joint.backwards) return reversed(next.path);
        return next.closed ? startingAt(next.path, joint.at.edge, joint.at.share) : next.path;
    }

    void cut(const Joint& joint) {
        const Path path = rotated(joint);
        script_.push_back(Cut{path});
        finish(joint.pass, path);
    }

    void finish(int i, const Path& path) {
        for (const Edge& edge : edgesOf(path))
            swept_.add(edge);
        settle(i);
        was_cut_[static_cast<std::size_t>(i)] = true;
        spot_of_[static_cast<std::size_t>(i)] = descents_.size() - 1;
        last_ = i;
        at_ = path.end();
    }

    const ClearingTask& task_;
    const Standing& standing_;
    const RingFamily::Component& component_;
    const std::vector<Pass>& passes_;
    const Entry& entry_;
    double radius_mm_;
    double step_over_mm_;
    const LinkRates& rates_;
    const Tolerances& tol_;
    SweptGround passes_ground_;  ///< what the passes will have swept
    SweptGround swept_;          ///< what has been swept so far
    SweptGround before_;         ///< what was clear before the layer
    std::vector<bool> done_;     ///< cut, or found needless
    std::vector<bool> was_cut_;
    std::vector<std::size_t> spot_of_;  ///< number of the descent before it
    std::vector<bool> looked_at_;       ///< by dropCleared()
    int left_;                          ///< passes not yet cut
    bool entered_ = false;
    std::vector<ScriptStep> script_;
    std::vector<Descent> descents_;
    Vec2 at_ = Vec2::Zero();
    int last_ = -1;
};

}  // namespace

Standing::Standing(const ClearingTask& task, double radius_mm, const Tolerances& tol)
    : obstruction_{task.obstruction, EdgeIndex(task.obstruction), radius_mm + tol.guard_mm / 2} {
    for (const KeptOff& kept : task.kept_off)
        holder_.push_back({kept.section, EdgeIndex(kept.section), kept.distance_mm});
}

bool Standing::keeps(const Kept& kept, const Vec2& from, const Vec2& to) {
    return !kept.edges.anyNearer(makeLine(from, to), kept.distance_mm) && !contains(kept.section, to);
}

bool Standing::isClear(const Vec2& from, const Vec2& to) const {
    return keeps(obstruction_, from, to);
}

bool Standing::isClearForAll(const Vec2& from, const Vec2& to) const {
    return isClear(from, to) && std::all_of(holder_.begin(), holder_.end(),
                                            [&](const Kept& kept) { return keeps(kept, from, to); });
}

LayerScript scriptLayer(const LayerTask& task, const RingFamily::Component& component, const Entry& entry,
                        const std::vector<Pass>& passes) {
    return LayerPlanner(task, component, entry, passes).plan();
}

RampAlong rampAlong(const Path& curve, bool closed, double descent_mm) {
    const double whole = length(curve);
    if (!closed) {
        const Path lead = descent_mm / 2 < whole ? firstPart(curve, descent_mm / 2) : curve;
        const int turns = static_cast<int>(std::ceil(descent_mm / 2 / length(lead) - kRounding));
        return {lead, curve, false, std::max(1, turns), true, Over::Retract};
    }
    const int turns = static_cast<int>(std::floor(descent_mm / whole));
    const double rest = descent_mm - turns * whole;
    // Too short a lead is not worth a block: the turns are a little steeper without, within rounding.
    if (rest < kLeastLeadShare * descent_mm)
        return {Path{curve.start, {}}, curve, true, turns, true, Over::Retract};
    return {reversed(firstPart(reversed(curve), rest)), curve, true, turns, true, Over::Retract};
}

void setOver(ScriptStep& step, Over over) {
    std::visit(
        [over](auto& s) {
            if constexpr (requires { s.over; }) s.over = over;
        },
        step);
}

}  // namespace stepmill::toolpath
