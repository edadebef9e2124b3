// Random cuts from several sides, seen from a third: the stock as slices is never less than the solid that
// OCCT makes of the same cuts, and its volume is that solid's.

#include <gtest/gtest.h>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <gp_Trsf.hxx>
#include <GProp_GProps.hxx>

#include <random>

#include "stepmill/layers/section_cutter.h"
#include "stepmill/layers/stock_after.h"
#include "stepmill/planar/boolean.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

using test::kTol;
const Vec3 kSize(60, 40, 20);
/// Of what was cut: what the quadrature over slabs with many bends may miss.
constexpr double kVolumeShare = 0.01;

struct Cut {
    Prism prism;
    TopoDS_Shape solid;  ///< the same in part coordinates
};

TopoDS_Shape toPart(const TopoDS_Shape& shape, const stepmill::Setup& setup) {
    const Eigen::Matrix4d m = setup.part_to_setup.inverse().matrix();
    gp_Trsf move;
    move.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0), m(2, 1),
                   m(2, 2), m(2, 3));
    return BRepBuilderAPI_Transform(shape, move, true).Shape();
}

class RandomCuts {
  public:
    explicit RandomCuts(unsigned seed) : random_(seed) {}

    /// Pockets and holes from the stock's top that do not meet, wholly over the stock's box.
    std::vector<Cut> cuts(const stepmill::Setup& setup) {
        const Vec3 size = setup.stock_bbox_mm.sizes();
        std::vector<Cut> found;
        Region taken;
        for (int i = 0; i < 5; ++i) {
            const double depth = number(2, size.z());
            const Vec2 centre(number(8, size.x() - 8), number(8, size.y() - 8));
            Cut cut;
            if (random_() % 2 == 0) {
                const double radius = number(1, 6);
                cut = {{makeCircle(centre, radius), 0, -depth},
                       cylinder(snapToGrid(centre).x(), snapToGrid(centre).y(), -depth, radius, depth)};
            } else {
                const Vec2 low = centre - Vec2(number(1, 7), number(1, 7));
                const Vec2 reach(number(2, 7), number(2, 7));
                cut = {{makeRectangle(low, low + reach), 0, -depth},
                       box(low.x(), low.y(), -depth, reach.x(), reach.y(), depth)};
            }
            if (area(intersect(cut.prism.region, taken, kTol)) > 0) continue;
            taken = unite(taken, cut.prism.region, kTol);
            cut.solid = toPart(cut.solid, setup);
            found.push_back(std::move(cut));
        }
        return found;
    }

    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() % 1000) / 1000;
    }

  private:
    std::mt19937 random_;
};

double volumeOf(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

/// What of the prism the slabs of the arriving stock hold.
void addWithin(const LayerStack& arriving, const Prism& prism, std::vector<Prism>& into) {
    for (const Layer& layer : arriving.layers) {
        const double top = std::min(layer.top_z_mm, prism.top_z_mm);
        const double bottom = std::max(layer.bottom_z_mm, prism.bottom_z_mm);
        Region common = top > bottom ? intersect(prism.region, layer.stock, kTol) : Region{};
        if (!common.empty()) into.push_back({std::move(common), top, bottom});
    }
}

Vec3 axisOf(unsigned number) {
    const Vec3 axes[] = {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1), Vec3(0.6, 0, 0.8),
                         Vec3(0, 0.28, -0.96)};
    return axes[number % 5];
}

/// Arcs of cuts askew to the setup's axis are polygons that near.
constexpr double kAskewMm = 0.03;

/// What stands on a part of the ground is what stands anywhere, there.
void expectAlikeOverPart(const StockSections& sections, const Region& everywhere, double bottom_mm,
                         double top_mm, RandomCuts& random) {
    const Box2 box = boundingBox(everywhere);
    const Vec2 low(random.number(box.min().x(), box.max().x() - 5),
                   random.number(box.min().y(), box.max().y() - 5));
    const Region ground = makeRectangle(low, low + Vec2(random.number(1, 5), random.number(1, 5)));
    const double throughout_mm2 =
        area(intersect(sections.throughout(everywhere, bottom_mm, top_mm), ground, kTol));
    EXPECT_NEAR(area(sections.throughout(ground, bottom_mm, top_mm)), throughout_mm2, 1e-3);
    const double somewhere_mm2 = area(intersect(sections.between(bottom_mm, top_mm), ground, kTol));
    EXPECT_NEAR(area(sections.between(ground, bottom_mm, top_mm)), somewhere_mm2, 1e-3);
}

/// Points in what stands throughout a slab lie in the solid at all its heights, and in a thin slab that is
/// all there is.
void expectStandsThroughout(const StockSections& sections, const stepmill::Setup& setup,
                            BRepClass3d_SolidClassifier& inside, RandomCuts& random) {
    const Box3& box = setup.stock_bbox_mm;
    const Eigen::Isometry3d to_part = setup.part_to_setup.inverse();
    const Region everywhere = makeRectangle(box.min().head<2>(), box.max().head<2>());
    for (int slab = 0; slab < 4; ++slab) {
        const double bottom_mm = random.number(box.min().z(), box.max().z() - 2);
        const double top_mm = bottom_mm + random.number(0.05, 2);
        const Region stands = sections.throughout(everywhere, bottom_mm, top_mm);
        for (int i = 0; i < 20; ++i) {
            const Vec2 p(random.number(box.min().x(), box.max().x()),
                         random.number(box.min().y(), box.max().y()));
            const Vec3 q = to_part * Vec3(p.x(), p.y(), random.number(bottom_mm, top_mm));
            if (!contains(stands, p) || distanceToBoundary(stands, p) < kAskewMm) continue;
            inside.Perform(gp_Pnt(q.x(), q.y(), q.z()), 1e-6);
            EXPECT_NE(inside.State(), TopAbs_OUT) << q.transpose();
        }
        const double thin_mm2 = area(sections.throughout(everywhere, bottom_mm, bottom_mm + 0.01));
        EXPECT_NEAR(thin_mm2, area(sections.at(bottom_mm + 0.005)), 0.02 * thin_mm2 + 1);
        EXPECT_LE(area(stands), area(sections.between(bottom_mm, top_mm)) + 1e-3);
        expectAlikeOverPart(sections, everywhere, bottom_mm, top_mm, random);
    }
}

}  // namespace

TEST(StockLaw, SlicesAreTheSolidAndNeverLess) {
    const Part block = part(box(0, 0, 0, kSize.x(), kSize.y(), kSize.z()));
    for (unsigned seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        RandomCuts random(seed);
        stepmill::Setup setup = setupOf(block);
        TopoDS_Shape solid = block.shape->solid;
        for (const unsigned next : {seed, seed / 5 + seed}) {
            std::vector<Prism> removed;
            const LayerStack arriving = slice(setup, kTol);
            for (const Cut& made : random.cuts(setup)) {
                addWithin(arriving, made.prism, removed);
                solid = cut(solid, made.solid);
            }
            const Stock left = stockAfter(setup, arriving, removed, kTol).stock;
            EXPECT_NEAR(left.volume_mm3, volumeOf(solid), kVolumeShare * (kSize.prod() - volumeOf(solid)));
            setup = onStock(setupOf(block, axisOf(next)), left);
            const LayerStack stack = slice(setup, kTol);
            double hull_mm3 = 0;
            double air_mm3 = 0;
            for (const Layer& layer : stack.layers) {
                hull_mm3 += area(layer.stock) * layer.height_mm();
                air_mm3 += layer.stock_air_mm3;
            }
            const double cut_mm3 = kSize.prod() - volumeOf(solid);
            // Seen askew a cut may reach beside the raw box; the books scale the air to the stock's volume.
            if (!setup.indexed) {
                EXPECT_NEAR(hull_mm3 - air_mm3, volumeOf(solid), kVolumeShare * cut_mm3);
            }
            EXPECT_GE(hull_mm3, volumeOf(solid) - 1e-3 * cut_mm3);
            // Points well inside the solid are stock at their height.
            const Eigen::Isometry3d to_setup = setup.part_to_setup;
            BRepClass3d_SolidClassifier inside(solid);
            for (int i = 0; i < 60; ++i) {
                const Vec3 p(random.number(0, 60), random.number(0, 40), random.number(0, 20));
                inside.Perform(gp_Pnt(p.x(), p.y(), p.z()), 1e-6);
                if (inside.State() != TopAbs_IN) continue;
                const Vec3 q = to_setup * p;
                const Region& stock = stack.stockAt(q.z());
                const bool is_stock =
                    contains(stock, q.head<2>()) || distanceToBoundary(stock, q.head<2>()) < 0.01;
                EXPECT_TRUE(is_stock) << p.transpose();
            }
            expectStandsThroughout(StockSections(setup, left, kTol), setup, inside, random);
        }
    }
}
