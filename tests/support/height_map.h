#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "stepmill/toolpath/toolpath.h"
#include "support/move_places.h"
#include "support/raster_simulator.h"

namespace stepmill::test {

/// How high a cutter's edge is over its tip, by the distance from its axis: flat, rounded or a cone.
struct CutterProfile {
    double radius_mm = 0;
    double flat_mm = 0;     ///< radius of the flat at the tip
    double corner_mm = 0;   ///< radius of the rounded corner; 0: none
    double cone_slope = 0;  ///< height over distance of a cone's flank; 0: none

    double heightAt(double from_axis_mm) const {
        const double out = from_axis_mm - flat_mm;
        if (out <= 0) return 0;
        if (cone_slope > 0) return out * cone_slope;
        return corner_mm - std::sqrt(std::max(0.0, corner_mm * corner_mm - out * out));
    }
};
inline CutterProfile profileOf(const ToolAssembly& tool) {
    const double radius = tool.diameter_mm / 2;
    if (tool.isDrill())
        return {radius, 0, 0, 1 / std::tan(tool.point_angle_deg / 360 * 3.14159265358979323846)};
    if (!tool.hasFlanks()) return {radius, radius - tool.corner_radius_mm, tool.corner_radius_mm, 0};
    const double half_rad = tool.included_angle_deg / 360 * 3.14159265358979323846;
    return {radius, tool.tip_diameter_mm / 2, 0, 1 / std::tan(half_rad)};
}

/// Stock as heights over square cells, lowered by cutters of any form: a simulation of whole setups that
/// shares no geometry with the planner but points along its curves.
///
/// A cell stands for its centre. Rims and walls are therefore uncertain by half a cell's diagonal; what is
/// compared with the part keeps `margin` away from both.
class HeightMap {
  public:
    HeightMap(const Box2& box, double cell_mm, double empty_z_mm)
        : raster_(box, cell_mm), heights_(raster_.count(), empty_z_mm), empty_z_mm_(empty_z_mm) {}

    const Raster& raster() const { return raster_; }
    const std::vector<double>& heights() const { return heights_; }
    double cellMm2() const { return raster_.cellMm() * raster_.cellMm(); }

    /// Material in the region up to z, where none stands higher.
    void raise(const Region& region, double z_mm) {
        const std::vector<char> cells = raster_.cellsOf(region);
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (cells[i] && heights_[i] < z_mm) heights_[i] = z_mm;
    }

    /// Raises the cells under a triangle to its plane.
    void raise(const Vec3& a, const Vec3& b, const Vec3& c) {
        const double twice_area = (b - a).head<2>().x() * (c - a).y() - (b - a).y() * (c - a).x();
        if (twice_area == 0) return;
        Box2 box;
        for (const Vec3& p : {a, b, c})
            box.extend(p.head<2>());
        raster_.forBox(box, [&](int column, int row) {
            const Vec2 p = raster_.centre(column, row);
            const auto share = [&](const Vec3& from, const Vec3& to) {
                return ((to - from).x() * (p.y() - from.y()) - (to - from).y() * (p.x() - from.x())) /
                       twice_area;
            };
            const double of_a = share(b, c);
            const double of_b = share(c, a);
            const double of_c = share(a, b);
            if (of_a < 0 || of_b < 0 || of_c < 0) return;
            double& z = heights_[raster_.index(column, row)];
            z = std::max(z, of_a * a.z() + of_b * b.z() + of_c * c.z());
        });
    }

    /// Lowest height within `reach_mm` of each cell.
    std::vector<double> lowestWithin(double reach_mm) const {
        std::vector<double> lowest(heights_.size());
        for (int row = 0; row < raster_.rows(); ++row)
            for (int column = 0; column < raster_.columns(); ++column) {
                double& least = lowest[raster_.index(column, row)];
                least = heights_[raster_.index(column, row)];
                raster_.forDisc(raster_.centre(column, row), reach_mm,
                                [&](std::size_t c) { least = std::min(least, heights_[c]); });
            }
        return lowest;
    }

    double volume_mm3() const {
        double sum = 0;
        for (const double z : heights_)
            sum += z - empty_z_mm_;
        return sum * cellMm2();
    }

    /// What a run of moves did.
    struct Cut {
        double removed_mm3 = 0;
        double feed_mm = 0;         ///< length fed
        double air_mm = 0;          ///< of it, over cells that were as low before
        double level_mm = 0;        ///< length fed on the level
        double level_air_mm = 0;    ///< of it in air
        double longest_air_mm = 0;  ///< longest run of feeds on the level in air
        int rapid_hits = 0;         ///< samples of rapids that touch material, rims left out by `slack_mm`
        Vec3 first_hit = Vec3::Zero();
    };

    /// Lowers the cells under a flat cutter that goes along the path.
    Cut run(const Toolpath& path, double radius_mm, double slack_mm) {
        return run(path, CutterProfile{radius_mm, radius_mm, 0, 0}, slack_mm);
    }

    /// The same of a cutter of another form.
    Cut run(const Toolpath& path, const CutterProfile& cutter, double slack_mm) {
        const double radius_mm = cutter.radius_mm;
        Cut cut;
        Vec3 from = path.start;
        double air_run = 0;
        for (const Move& move : path.moves) {
            if (move.kind == MoveKind::Rapid) {
                rapid(from, move, cutter, radius_mm - slack_mm, cut);
                air_run = 0;
            } else {
                feed(from, move, cutter, air_run, cut);
            }
            from = move.to;
        }
        return cut;
    }

  private:
    void rapid(const Vec3& from, const Move& move, const CutterProfile& cutter, double radius_mm,
               Cut& cut) const {
        // Nothing is lowered, so steps may be as long as the disc is wide in cells.
        const MovePlaces places(from, move, std::max(0.5 * radius_mm, raster_.cellMm()));
        for (int i = 0; i <= places.last(); ++i) {
            const Vec3 at = places.at(i);
            bool hit = false;
            raster_.forDisc(at.head<2>(), radius_mm, [&](std::size_t c) {
                const double z_mm = at.z() + cutter.heightAt((raster_.centre(c) - at.head<2>()).norm());
                hit = hit || (heights_[c] > empty_z_mm_ && heights_[c] > z_mm + kFlushMm);
            });
            if (hit && cut.rapid_hits++ == 0) cut.first_hit = at;
        }
    }

    void feed(const Vec3& from, const Move& move, const CutterProfile& cutter, double& air_run, Cut& cut) {
        const MovePlaces places(from, move, stepMm(cutter.radius_mm));
        const bool level = from.z() == move.to.z();
        cut.feed_mm += places.lengthMm();
        if (level) cut.level_mm += places.lengthMm();
        for (int i = 0; i <= places.last(); ++i) {
            const double taken = lower(places.at(i), cutter);
            cut.removed_mm3 += taken;
            if (i == 0) continue;
            const double step_mm = places.stepMm();
            if (taken > 0) {
                air_run = 0;
                continue;
            }
            cut.air_mm += step_mm;
            if (!level) continue;
            cut.level_air_mm += step_mm;
            air_run += step_mm;
            cut.longest_air_mm = std::max(cut.longest_air_mm, air_run);
        }
    }

    double lower(const Vec3& at, const CutterProfile& cutter) {
        double taken = 0;
        raster_.forDisc(at.head<2>(), cutter.radius_mm, [&](std::size_t c) {
            const double off_axis_mm = (raster_.centre(c) - at.head<2>()).norm();
            const double z_mm = at.z() + cutter.heightAt(std::min(off_axis_mm, cutter.radius_mm));
            if (heights_[c] <= z_mm) return;
            taken += heights_[c] - std::max(z_mm, empty_z_mm_);
            heights_[c] = std::max(z_mm, empty_z_mm_);
        });
        return taken * cellMm2();
    }

    /// Steps whose scallops stay under a tenth of a cell.
    double stepMm(double radius_mm) const { return std::sqrt(0.8 * raster_.cellMm() * radius_mm); }

    static constexpr double kFlushMm = 1e-6;

    Raster raster_;
    std::vector<double> heights_;
    double empty_z_mm_;
};

}  // namespace stepmill::test
