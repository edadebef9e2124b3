#include "support/random_parts.h"

#include <cmath>

#include <fmt/format.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>

#include "solids.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill::test {
namespace {

/// Tools that cut an open side reach beyond it by this much [mm].
constexpr double kBeyondMm = 5;
/// Walls and floors are at least this thick [mm], but for thin walls on purpose.
constexpr double kLeastWallMm = 3;
constexpr double kPointAngleDeg = 59;

/// A rectangle on a side of the block, in its own coordinates.
struct Place {
    double x0 = 0;
    double y0 = 0;
    double x1 = 0;
    double y1 = 0;

    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
    double smaller() const { return std::min(width(), height()); }
};

/// A side of the block, seen from the spindle: x and y along its edges from a corner, z = 0 on it and up out
/// of it.
struct Side {
    std::string name;
    double length_mm = 0;
    double width_mm = 0;
    double depth_mm = 0;
    gp_Ax3 frame;
};

Side sideOf(std::size_t which, double length, double width, double height) {
    switch (which) {
        case 0:
            return {"+z", length, width, height, gp_Ax3(gp_Pnt(0, 0, height), gp::DZ(), gp::DX())};
        case 1:
            return {"-z", length, width, height, gp_Ax3(gp_Pnt(0, width, 0), -gp::DZ(), gp::DX())};
        case 2:
            return {"+x", width, height, length, gp_Ax3(gp_Pnt(length, 0, 0), gp::DX(), gp::DY())};
        case 3:
            return {"-x", width, height, length, gp_Ax3(gp_Pnt(0, width, 0), -gp::DX(), -gp::DY())};
        case 4:
            return {"+y", length, height, width, gp_Ax3(gp_Pnt(length, width, 0), gp::DY(), -gp::DX())};
        default:
            return {"-y", length, height, width, gp_Ax3(gp_Pnt(0, 0, 0), -gp::DY(), gp::DX())};
    }
}

TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Ax3& to) {
    gp_Trsf move;
    move.SetTransformation(to, gp_Ax3());
    return BRepBuilderAPI_Transform(shape, move, Standard_True).Shape();
}

/// Upright sides that lean outwards on the way up.
TopoDS_Shape drafted(const Place& floor, double floor_z, double top_z, double draft_deg) {
    const double grows = (top_z - floor_z) * std::tan(degToRad(draft_deg));
    BRepOffsetAPI_ThruSections loft(Standard_True, Standard_True);
    for (const bool top : {false, true}) {
        const double by = top ? grows : 0;
        const double z = top ? top_z : floor_z;
        BRepBuilderAPI_MakePolygon outline;
        outline.Add(gp_Pnt(floor.x0 - by, floor.y0 - by, z));
        outline.Add(gp_Pnt(floor.x1 + by, floor.y0 - by, z));
        outline.Add(gp_Pnt(floor.x1 + by, floor.y1 + by, z));
        outline.Add(gp_Pnt(floor.x0 - by, floor.y1 + by, z));
        outline.Close();
        loft.AddWire(outline.Wire());
    }
    return loft.Shape();
}

/// Cuts one side after another; what would spoil the solid is undone.
class Cutter {
  public:
    Cutter(SamplePart& part, Dice& dice) : part_(part), dice_(dice) {}

    void cut(const Side& side) {
        side_ = side;
        part_.about += fmt::format("; {}:", side.name);
        if (dice_.chance(0.2)) raiseBosses();
        const std::size_t count = 1 + dice_.below(4);
        for (std::size_t i = 0; i < count; ++i)
            addFeature();
    }

  private:
    void addFeature() {
        switch (dice_.below(10)) {
            case 0:
            case 1:
            case 2:
                return pocket(inner(), depth(0.7), 0);
            case 3:
                return openPocket();
            case 4:
                return window();
            case 5:
                return slot();
            case 6:
                return step();
            case 7:
                return nearWall();
            default:
                return holes();
        }
    }

    // Places --------------------------------------------------------------------------------------------

    /// Somewhere inside the side, at least a wall away from its edges.
    Place inner() { return within({0, 0, side_.length_mm, side_.width_mm}, kLeastWallMm); }

    Place within(const Place& room, double wall) {
        const double width = dice_.between(0.2, 0.8) * (room.width() - 2 * wall);
        const double height = dice_.between(0.2, 0.8) * (room.height() - 2 * wall);
        const double x = std::round(dice_.between(room.x0 + wall, room.x1 - wall - width));
        const double y = std::round(dice_.between(room.y0 + wall, room.y1 - wall - height));
        return {x, y, x + std::max(2.0, std::round(width)), y + std::max(2.0, std::round(height))};
    }

    double depth(double share) {
        return std::max(1.0, std::round(2 * dice_.between(0.05, share) * side_.depth_mm) / 2);
    }

    double cornerRadius(const Place& place) {
        const double drawn = dice_.oneOf({0.0, 0.8, 1.0, 1.5, 1.6, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0});
        return std::min(drawn, 0.49 * place.smaller());
    }

    // Solids --------------------------------------------------------------------------------------------

    TopoDS_Shape block(const Place& place, double radius, double z0, double z1) const {
        return prism(rectangle(place.x0, place.y0, place.x1, place.y1, radius), z0, z1);
    }

    void remove(const TopoDS_Shape& shape, const std::string& what) { change({}, {shape}, what); }

    void change(const std::vector<TopoDS_Shape>& added, const std::vector<TopoDS_Shape>& removed,
                const std::string& what) {
        std::vector<TopoDS_Shape> up;
        std::vector<TopoDS_Shape> off;
        for (const TopoDS_Shape& shape : added)
            up.push_back(placed(shape, side_.frame));
        for (const TopoDS_Shape& shape : removed)
            off.push_back(placed(shape, side_.frame));
        SamplePart changed = part_;
        try {
            changed.solid = assemble(part_.solid, up, off);
            changed.about += " " + what;
            sampleStepText(changed);
        } catch (const Error&) {
            return;  // not one valid solid any more, or none that can be written: the part stays as it was
        }
        part_ = std::move(changed);
    }

    // Features ------------------------------------------------------------------------------------------

    /// The top is cut down but for one to three bosses.
    void raiseBosses() {
        const double down = dice_.between(1, 0.3 * side_.depth_mm, 0.5);
        TopoDS_Shape around = box(-kBeyondMm, -kBeyondMm, -down, side_.length_mm + kBeyondMm,
                                  side_.width_mm + kBeyondMm, kBeyondMm);
        const std::size_t count = 1 + dice_.below(3);
        std::vector<TopoDS_Shape> bosses;
        for (std::size_t i = 0; i < count; ++i) {
            const Place place = inner();
            const double radius = cornerRadius(place);
            if (dice_.chance(0.5))
                bosses.push_back(block(place, radius, -2 * down, 2 * kBeyondMm));
            else
                bosses.push_back(cylinder(place.x0 + place.smaller() / 2, place.y0 + place.smaller() / 2,
                                          place.smaller(), -2 * down, 2 * kBeyondMm));
        }
        try {
            const TopoDS_Shape removed = assemble(around, {}, bosses);
            remove(removed, fmt::format("bosses {} mm high", down));
        } catch (const Error&) {
            // Bosses that touch both edges part the ground in two.
        }
    }

    void pocket(const Place& place, double deep, double top_z) {
        const double radius = cornerRadius(place);
        const double floor_z = -deep;
        if (dice_.chance(0.08)) {
            remove(drafted(place, floor_z, kBeyondMm, dice_.oneOf({1.0, 3.0, 5.0, 10.0})),
                   fmt::format("drafted pocket {}x{}x{}", place.width(), place.height(), deep));
        } else {
            remove(pocketSolid(place, radius, floor_z, top_z),
                   fmt::format("pocket {}x{}x{} r{:.4g}", place.width(), place.height(), deep, radius));
        }
        const double rest_mm = side_.depth_mm - deep - kLeastWallMm;
        if (place.smaller() < 8 || rest_mm < 2) return;
        if (dice_.chance(0.35)) pocket(within(place, nestedWall()), deep + nestedDepth(rest_mm), floor_z);
        if (dice_.chance(0.35)) hole(placeIn(place), deep, rest_mm);
    }

    /// Distance between the walls of a pocket and of one in its floor.
    double nestedWall() { return dice_.oneOf({0.0, 0.5, 1.0, 2.0}); }
    double nestedDepth(double rest_mm) { return dice_.between(1, std::min(25.0, rest_mm), 0.5); }

    TopoDS_Shape pocketSolid(const Place& place, double radius, double floor_z, double top_z) {
        TopoDS_Shape solid = prism(outlineOf(place, radius), floor_z, kBeyondMm);
        if (place.smaller() < 10 || !dice_.chance(0.3)) return solid;
        const Place at = within(place, dice_.oneOf({-1.0, 0.5, 2.0, 4.0}));
        const double island_top = dice_.chance(0.6) ? 2 * kBeyondMm : dice_.between(floor_z + 0.5, top_z);
        const TopoDS_Shape island = dice_.chance(0.5)
                                        ? cylinder(at.x0 + at.smaller() / 2, at.y0 + at.smaller() / 2,
                                                   at.smaller(), floor_z - kBeyondMm, island_top)
                                        : block(at, cornerRadius(at), floor_z - kBeyondMm, island_top);
        try {
            return assemble(solid, {}, {island});
        } catch (const Error&) {
            return solid;  // an island across the whole pocket parts it
        }
    }

    /// A rectangle, or an L.
    std::vector<Corner> outlineOf(const Place& place, double radius) {
        if (place.smaller() < 12 || !dice_.chance(0.3))
            return rectangle(place.x0, place.y0, place.x1, place.y1, radius);
        const double x = place.x0 + place.width() * dice_.between(0.3, 0.7);
        const double y = place.y0 + place.height() * dice_.between(0.3, 0.7);
        const double small = std::min(radius, 0.14 * place.smaller());
        return {{place.x0, place.y0, small}, {place.x1, place.y0, small}, {place.x1, y, small}, {x, y, small},
                {x, place.y1, small},        {place.x0, place.y1, small}};
    }

    void openPocket() {
        Place place = inner();
        const double radius = cornerRadius(place);
        switch (dice_.below(4)) {
            case 0:
                place.x0 = -kBeyondMm - radius;
                break;
            case 1:
                place.x1 = side_.length_mm + kBeyondMm + radius;
                break;
            case 2:
                place.y0 = -kBeyondMm - radius;
                break;
            default:
                place.y1 = side_.width_mm + kBeyondMm + radius;
        }
        const double deep = depth(0.6);
        remove(pocketSolid(place, radius, -deep, 0),
               fmt::format("open pocket {} deep r{:.4g}", deep, radius));
    }

    void window() {
        const Place place = inner();
        const double radius = cornerRadius(place);
        remove(pocketSolid(place, radius, -side_.depth_mm - kBeyondMm, 0),
               fmt::format("window {}x{} r{:.4g}", place.width(), place.height(), radius));
    }

    void slot() {
        const Place place = inner();
        const double wide = dice_.oneOf({2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0});
        const double deep = depth(0.5);
        const Place across{-kBeyondMm, place.y0, side_.length_mm + kBeyondMm, place.y0 + wide};
        const Place along{place.x0, -kBeyondMm, place.x0 + wide, side_.width_mm + kBeyondMm};
        Place found = dice_.chance(0.5) ? across : along;
        if (dice_.chance(0.4)) found.x1 = std::max(place.x1, found.x0 + wide);  // ends within the block
        remove(block(found, std::min(cornerRadius(found), wide / 2 - 0.01), -deep, kBeyondMm),
               fmt::format("slot {} wide {} deep", wide, deep));
    }

    void step() {
        const double deep = depth(0.6);
        const double into = dice_.between(1, 0.4 * std::min(side_.length_mm, side_.width_mm), 0.5);
        const double out = kBeyondMm;
        const Place places[] = {{-out, -out, into, side_.width_mm + out},
                                {side_.length_mm - into, -out, side_.length_mm + out, side_.width_mm + out},
                                {-out, -out, side_.length_mm + out, into},
                                {-out, -out, 0.5 * side_.length_mm, into}};
        remove(block(places[dice_.below(4)], 0, -deep, kBeyondMm),
               fmt::format("step {} wide {} deep", into, deep));
    }

    /// A pocket that leaves a thin wall at the edge of the block.
    void nearWall() {
        const double wall = dice_.oneOf({0.5, 0.8, 1.0, 1.5, 2.0});
        const double across = dice_.between(6, 0.5 * side_.width_mm, 1);
        const Place place{wall, wall, wall + std::max(8.0, std::round(0.6 * side_.length_mm)), wall + across};
        pocket(place, depth(0.6), 0);
    }

    // Holes ---------------------------------------------------------------------------------------------

    struct At {
        double x = 0;
        double y = 0;
    };

    At placeIn(const Place& place) {
        return {std::round(dice_.between(place.x0, place.x1)), std::round(dice_.between(place.y0, place.y1))};
    }

    void holes() {
        const std::size_t count = 1 + dice_.below(3);
        const At at = placeIn(
            {kLeastWallMm, kLeastWallMm, side_.length_mm - kLeastWallMm, side_.width_mm - kLeastWallMm});
        const double apart = dice_.between(4, 20, 0.5);
        for (std::size_t i = 0; i < count; ++i)
            hole({at.x + apart * static_cast<double>(i), at.y}, 0, side_.depth_mm - kLeastWallMm);
    }

    double drilledMm() {
        if (dice_.chance(0.25)) return dice_.between(1.5, 20, 0.1);
        return dice_.oneOf({3.3, 4.2, 5.0, 5.0, 6.0, 6.0, 6.8, 6.8, 8.0, 8.0, 8.5, 10.0, 10.0, 12.0});
    }

    /// From the floor of what is that deep, or from the top.
    void hole(const At& at, double below_mm, double rest_mm) {
        const double diameter = drilledMm();
        const bool through = dice_.chance(0.4);
        const double deep = dice_.between(1, std::max(1.0, std::min(rest_mm, 8 * diameter)), 0.5);
        const double bottom = through ? -side_.depth_mm - kBeyondMm : -below_mm - deep;
        std::vector<TopoDS_Shape> cuts{cylinder(at.x, at.y, diameter, bottom, kBeyondMm)};
        std::string what =
            fmt::format("{} hole {:.4g} {} deep", through ? "through" : "blind", diameter, deep);
        if (!through && dice_.chance(0.5)) {
            const double point = diameter / 2 / std::tan(degToRad(kPointAngleDeg));
            cuts.push_back(BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(at.x, at.y, bottom - point), gp::DZ()), 0,
                                                diameter / 2, point)
                               .Shape());
            what += ", pointed";
        }
        if (dice_.chance(0.2)) {
            const double wide = diameter + dice_.between(1, 8, 0.5);
            cuts.push_back(cylinder(at.x, at.y, wide, -below_mm - std::min(deep, 3.0), kBeyondMm));
            what += ", counterbored";
        }
        change({}, cuts, what);
    }

    SamplePart& part_;
    Dice& dice_;
    Side side_;
};

}  // namespace

SamplePart randomPart(const std::string& name, Dice& dice) {
    const double length = dice.between(40, 160, 1);
    const double width = dice.between(40, std::max(45.0, 0.8 * length), 1);
    const double height = dice.between(10, std::min(60.0, width), 1);
    SamplePart part{name, fmt::format("block {}x{}x{}", length, width, height),
                    box(0, 0, 0, length, width, height)};
    Cutter cutter(part, dice);
    cutter.cut(sideOf(0, length, width, height));
    std::vector<std::size_t> others{1, 2, 3, 4, 5};
    const std::size_t more = dice.oneOf<std::size_t>({0, 0, 1, 1, 2});
    for (std::size_t i = 0; i < more; ++i) {
        const std::size_t pick = dice.below(others.size());
        cutter.cut(sideOf(others[pick], length, width, height));
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(pick));
    }
    return part;
}

}  // namespace stepmill::test
