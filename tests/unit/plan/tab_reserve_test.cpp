// A frame round a part and the tabs that tie the part to it.

#include "plan/holding/tab_reserve.h"

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// A plate of 80 x 60 x 10 with a window, in a stock that is larger on all sides.
Setup plateIn(double side_mm, double top_mm, double below_mm) {
    const Part part =
        test::part(test::cut(test::box(0, 0, 0, 80, 60, 10), test::cylinder(40, 30, -1, 25, 12)));
    return test::setupOf(part, Vec3::UnitZ(), {side_mm, top_mm, below_mm});
}

CutPrisms framed(const Setup& setup) {
    return tabbedFrame(setup, {}, defaultToolLibrary(), "aluminium", kTol);
}

std::string refusal(const Setup& setup) {
    try {
        framed(setup);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        return error.what();
    }
    return {};
}

TEST(TabbedFrame, LeavesAChannelForItsMillAndTabsAcrossIt) {
    const CutPrisms stays = framed(plateIn(25, 1, 0));
    ASSERT_EQ(stays.prisms.size(), 2U);
    const Prism& frame = stays.prisms.front();
    const Prism& tabs = stays.prisms.back();
    const Region stock = makeRectangle({0, 0}, {130, 110});
    const Region part = makeRectangle({25, 25}, {105, 85});
    EXPECT_DOUBLE_EQ(frame.top_z_mm, 0);
    EXPECT_DOUBLE_EQ(frame.bottom_z_mm, -11);
    EXPECT_DOUBLE_EQ(tabs.top_z_mm, -10);
    // 12 mm mill, channel of 14.4 mm, rounded at the part's corners; the stock's own corners stay.
    const double channel_mm = 14.4;
    const double frame_mm2 = 130 * 110 - (80 * 60 + 280 * channel_mm + kPi * channel_mm * channel_mm);
    EXPECT_NEAR(area(frame.region), frame_mm2, 1);
    EXPECT_LE(area(subtract(frame.region, stock, kTol)), kTol.area_mm2);
    EXPECT_LE(area(intersect(tabs.region, part, kTol)), kTol.area_mm2);
    const std::vector<Region> each = components(tabs.region);
    EXPECT_EQ(each.size(), 3U);
    for (const Region& tab : each) {
        // It touches both.
        EXPECT_GT(area(intersect(offset(tab, 0.1, kTol), part, kTol)), 0.3);
        EXPECT_GT(area(intersect(offset(tab, 0.1, kTol), frame.region, kTol)), 0.3);
        EXPECT_GE(area(tab), 6 * channel_mm - 1);
        // And has what the mill of 6 mm radius leaves in its corners, not much more.
        EXPECT_LE(area(tab), 6 * channel_mm + 5 * (1 - kPi / 4) * 6 * 6);
    }
}

TEST(TabbedFrame, SaysWhatItMisses) {
    EXPECT_NE(refusal(plateIn(2, 1, 0)).find("expected 18.4 mm or more"), std::string::npos);
    EXPECT_NE(refusal(plateIn(25, 1, 5)).find("stands on the stock's bottom"), std::string::npos);
    EXPECT_NE(refusal(plateIn(25, 300, 0)).find("no end mill for aluminium"), std::string::npos);
}

}  // namespace
}  // namespace stepmill
