// What falls loose when a setup is cut.

#include "plan/holding/loose_pieces.h"

#include <algorithm>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "stepmill/core/groups.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

/// Smaller pieces go with the chips [mm3].
constexpr double kCrumbMm3 = 10;
/// So many are told one by one, the largest.
constexpr std::size_t kNamedPieces = 3;
/// Stock as near to a jaw touches it [mm].
constexpr double kTouchingMm = 0.05;

/// A connected piece of stock between two heights.
struct Slice {
    Region section;
    Box2 box;
    double top_z_mm = 0;
    double bottom_z_mm = 0;
};

/// Slices of the stock a setup leaves, joined where one stands on another.
class Pieces {
  public:
    Pieces(const Stage& stage, const std::vector<Prism>& removed, const Tolerances& tol)
        : stage_(stage), removed_(removed), tol_(tol) {
        const std::vector<double> heights = levels();
        std::size_t above_from = 0;
        for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
            const std::size_t from = slices_.size();
            addSlab(heights[i], heights[i + 1]);
            hanging_.grow(slices_.size());
            for (std::size_t below = from; below < slices_.size(); ++below)
                for (std::size_t above = above_from; above < from; ++above)
                    if (hanging_.of(above) != hanging_.of(below) && touch(slices_[above], slices_[below]))
                        hanging_.join(above, below);
            above_from = from;
        }
        held_.assign(slices_.size(), 0);
        for (std::size_t i = 0; i < slices_.size(); ++i)
            if (!held_[hanging_.of(i)] && isHeld(slices_[i])) held_[hanging_.of(i)] = 1;
    }

    /// What hangs together with nothing that is held, the largest first.
    /// \param arrives  the pieces before the cut: what hung loose already is a slice wider than the stock, for
    ///                 none fell from the setups before
    std::vector<LoosePiece> loose(const std::function<const Pieces&()>& arrives) const {
        std::vector<double> volumes_mm3(slices_.size(), 0);  // by the name of the piece
        for (std::size_t i = 0; i < slices_.size(); ++i)
            volumes_mm3[hanging_.of(i)] +=
                area(slices_[i].section) * (slices_[i].top_z_mm - slices_[i].bottom_z_mm);
        std::vector<LoosePiece> found;
        for (std::size_t i = 0; i < slices_.size(); ++i)
            if (!held_[i] && volumes_mm3[i] > kCrumbMm3 && arrives().holds(slices_[i]))
                found.push_back({volumes_mm3[i], placeOn(slices_[i])});
        std::stable_sort(found.begin(), found.end(), [](const LoosePiece& a, const LoosePiece& b) {
            return a.volume_mm3 > b.volume_mm3;
        });
        return found;
    }

  private:
    /// Where layers or what is removed begin or end, from above.
    std::vector<double> levels() const {
        std::vector<double> heights;
        for (const Layer& layer : stage_.layers.layers)
            heights.insert(heights.end(), {layer.top_z_mm, layer.bottom_z_mm});
        for (const Prism& prism : removed_)
            heights.insert(heights.end(), {prism.top_z_mm, prism.bottom_z_mm});
        std::sort(heights.rbegin(), heights.rend());
        const auto same = [](double a, double b) { return a - b <= kSameHeightMm; };
        heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
        return heights;
    }

    void addSlab(double top_mm, double bottom_mm) {
        const double middle_mm = (top_mm + bottom_mm) / 2;
        const Region& gone = goneAt(middle_mm);
        for (const Layer& layer : stage_.layers.layers) {
            if (layer.top_z_mm < middle_mm || layer.bottom_z_mm > middle_mm || layer.stock.empty()) continue;
            const Region left = gone.empty() ? layer.stock : subtract(layer.stock, gone, tol_);
            for (Region& piece : components(left)) {
                const Box2 box = boundingBox(piece);
                slices_.push_back({std::move(piece), box, top_mm, bottom_mm});
            }
        }
    }

    /// What is removed there; many slabs in turn have the same.
    const Region& goneAt(double z_mm) {
        std::vector<std::size_t> prisms;
        for (std::size_t i = 0; i < removed_.size(); ++i)
            if (removed_[i].top_z_mm > z_mm && removed_[i].bottom_z_mm < z_mm) prisms.push_back(i);
        if (prisms == gone_prisms_) return gone_;
        std::vector<Region> regions;
        regions.reserve(prisms.size());
        for (const std::size_t i : prisms)
            regions.push_back(removed_[i].region);
        gone_ = regions.empty() ? Region{} : unite(regions, tol_);
        gone_prisms_ = std::move(prisms);
        return gone_;
    }

    /// On top of it, in its middle where that is not open.
    Vec3 placeOn(const Slice& slice) const {
        Vec2 at = slice.box.center();
        if (!contains(slice.section, at))
            if (const auto disc = ClearanceDiagram(slice.section, tol_).largestInscribedDisc())
                at = disc->centre;
        return {at.x(), at.y(), slice.top_z_mm};
    }

    /// Does a piece that is held have some of the slice?
    bool holds(const Slice& slice) const {
        const double middle_mm = (slice.top_z_mm + slice.bottom_z_mm) / 2;
        for (std::size_t i = 0; i < slices_.size(); ++i)
            if (slices_[i].top_z_mm > middle_mm && slices_[i].bottom_z_mm < middle_mm &&
                held_[hanging_.of(i)] && touch(slices_[i], slice))
                return true;
        return false;
    }

    bool touch(const Slice& a, const Slice& b) const {
        return a.box.intersects(b.box) && area(intersect(a.section, b.section, tol_)) > tol_.area_mm2;
    }

    bool isHeld(const Slice& slice) const {
        const Clamping& clamping = stage_.clamping;
        const double bottom_mm = stage_.layers.stock_bottom_z_mm;
        if (clamping.kind == HoldKind::Plate || clamping.kind == HoldKind::Skin)
            return slice.bottom_z_mm <= bottom_mm + kSameHeightMm;
        return std::any_of(clamping.fixtures.begin(), clamping.fixtures.end(), [&](const Fixture& fixture) {
            const bool beside = slice.bottom_z_mm < fixture.top_z_mm && slice.top_z_mm > fixture.bottom_z_mm;
            const bool under = slice.bottom_z_mm < fixture.bottom_z_mm;
            if (fixture.kind == FixtureKind::Jaw ? !beside : !under) return false;
            const Box2 box = boundingBox(fixture.section);
            return slice.box.squaredExteriorDistance(box) < kTouchingMm * kTouchingMm &&
                   isNear(slice.section, fixture.section);
        });
    }

    static bool isNear(const Region& section, const Region& fixture) {
        for (const Loop& loop : section.loops)
            for (const Segment& segment : loop.segments)
                if (distanceToRegion(fixture, segment.to) < kTouchingMm) return true;
        for (const Loop& loop : fixture.loops)
            for (const Segment& segment : loop.segments)
                if (distanceToRegion(section, segment.to) < kTouchingMm) return true;
        return false;
    }

    const Stage& stage_;
    const std::vector<Prism>& removed_;
    const Tolerances& tol_;
    std::vector<std::size_t> gone_prisms_;  ///< those that gone_ unites
    Region gone_;
    std::vector<Slice> slices_;
    std::vector<char> held_;  ///< by the name of a piece: is it?
    Groups hanging_;          ///< slices that are one piece, named by an uppermost
};

}  // namespace

std::vector<LoosePiece> loosePieces(const Stage& stage, const std::vector<Prism>& removed,
                                    const Tolerances& tol) {
    const HoldKind kind = stage.clamping.kind;
    if (kind == HoldKind::None || kind == HoldKind::Given) return {};
    const std::vector<Prism> nothing;
    std::optional<Pieces> arrives;
    return Pieces(stage, removed, tol).loose([&]() -> const Pieces& {
        if (!arrives) arrives.emplace(stage, nothing, tol);
        return *arrives;
    });
}

std::vector<Warning> looseWarnings(const std::vector<LoosePiece>& pieces, const std::string& setup_id) {
    std::vector<Warning> warnings;
    for (std::size_t i = 0; i < std::min(pieces.size(), kNamedPieces); ++i)
        warnings.push_back(
            {"loose", setup_id,
             fmt::format("{:.4g} mm3 fall loose at X{:.1f} Y{:.1f} Z{:.1f}: nothing that is held ties "
                         "them; screw or tape that piece down (--fixtures), or leave it to another setup",
                         pieces[i].volume_mm3, pieces[i].at.x(), pieces[i].at.y(), pieces[i].at.z())});
    if (pieces.size() <= kNamedPieces) return warnings;
    double others_mm3 = 0;
    for (std::size_t i = kNamedPieces; i < pieces.size(); ++i)
        others_mm3 += pieces[i].volume_mm3;
    warnings.push_back({"loose", setup_id,
                        fmt::format("{} more pieces fall loose, {:.4g} mm3 in all",
                                    pieces.size() - kNamedPieces, others_mm3)});
    return warnings;
}

}  // namespace stepmill
