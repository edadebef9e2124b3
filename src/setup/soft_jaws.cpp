// Jaws that are bored to the outline of what they hold.

#include <algorithm>

#include <fmt/format.h>

#include "setup/ways_to_hold.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::setup {

namespace {

/// Deeper they are not bored [mm].
constexpr double kDeepestBoreMm = 15;
/// Between the jaws so much of the stock's width is free: they must close on it [share].
constexpr double kOpenShare = 0.25;

class SoftJaws {
  public:
    SoftJaws(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol)
        : stock_(stock),
          vise_(wish.vise),
          growth_mm_(wish.growth_mm),
          tol_(tol),
          bottom_mm_(stock.arriving.back().bottom_z_mm),
          outline_(withoutHoles(stock.arriving.back().region)) {}

    WayToHold find() const {
        const Box2 box = boundingBox(outline_);
        const Vec2 across = box.sizes().x() < box.sizes().y() ? Vec2::UnitX() : Vec2::UnitY();
        const double opening_mm = across.dot(box.sizes());
        if (components(outline_).size() != 1) return {{}, "no soft jaws: the bottom is in several pieces"};
        if (opening_mm > vise_.opening_mm)
            return {{},
                    fmt::format("no soft jaws: the vise opens {:.4g} mm, the stock is {:.4g} mm wide",
                                vise_.opening_mm, opening_mm)};
        const Vec2 along(-across.y(), across.x());
        const double beside_mm = besideJawsMm(stock_, vise_, across, along.dot(box.center()));
        if (holdsOneEndAlone(vise_, beside_mm)) return {{}, "no soft jaws: " + endsStickOut(beside_mm)};
        const double depth_mm = std::min(
            {sameOutlineMm(), lowestCutMm() - vise_.jaw_clearance_mm, kDeepestBoreMm, vise_.jaw_height_mm});
        if (depth_mm < vise_.grip_mm - kPlaneMm)
            return {{}, "no soft jaws: the outline is cut or changes too low for them"};
        Clamping found = made(box, across, depth_mm);
        askForSupport(found, vise_, beside_mm);
        return {std::move(found), {}};
    }

  private:
    /// So high over the bottom the stock has its lowest outline, with upright walls; the jaws end below the
    /// stock's top.
    double sameOutlineMm() const {
        double height_mm = 0;
        for (std::size_t i = stock_.arriving.size(); i-- > 0;) {
            const bool same = covers(outline_, withoutHoles(stock_.arriving[i].region), kPlaneMm, tol_) &&
                              covers(withoutHoles(stock_.standing[i]), outline_, kPlaneMm, tol_);
            if (!same) return height_mm;
            height_mm = stock_.arriving[i].top_z_mm - bottom_mm_;
        }
        return height_mm - vise_.jaw_clearance_mm;
    }

    /// Lowest cutting at the outside, over the bottom.
    double lowestCutMm() const {
        const Region inside = offset(outline_, -kPlaneMm, tol_);
        double lowest_mm = 1e300;
        for (const Prism& prism : stock_.removed)
            if (!subtract(prism.region, inside, tol_).empty())
                lowest_mm = std::min(lowest_mm, prism.bottom_z_mm - bottom_mm_);
        return lowest_mm;
    }

    Clamping made(const Box2& box, const Vec2& across, double depth_mm) const {
        Clamping made;
        made.kind = HoldKind::SoftJaws;
        made.across = Vec3(across.x(), across.y(), 0);
        made.opening_mm = across.dot(box.sizes());
        made.depth_mm = depth_mm;
        const Vec2 along(-across.y(), across.x());
        made.length_mm = std::min(std::abs(along.dot(box.sizes())), vise_.jaw_width_mm);
        for (const Vec2& out : {across, Vec2(-across)}) {
            const double from_mm = out.dot(box.center()) + kOpenShare / 2 * made.opening_mm;
            Vise block = vise_;
            block.jaw_thickness_mm += made.opening_mm / 2;
            Fixture jaw = viseJaw(block, growth_mm_, out, from_mm, Vec2(-out.y(), out.x()).dot(box.center()),
                                  bottom_mm_ + depth_mm);
            jaw.section = subtract(jaw.section, outline_, tol_);
            made.fixtures.push_back(std::move(jaw));
        }
        made.text = fmt::format(
            "vise with soft jaws, bored {:.3g} mm deep to the stock's outline, {:.4g} mm wide across {}",
            depth_mm, made.opening_mm, directionName(across));
        return made;
    }

    const StockToHold& stock_;
    const Vise& vise_;
    double growth_mm_ = 0;
    const Tolerances& tol_;
    double bottom_mm_ = 0;
    Region outline_;
};

}  // namespace

WayToHold inSoftJaws(const StockToHold& stock, const HoldWish& wish, const Tolerances& tol) {
    return SoftJaws(stock, wish, tol).find();
}

}  // namespace stepmill::setup
