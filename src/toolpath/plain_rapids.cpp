// Rapids that rest on nothing the planner believes of what stands.

#include <algorithm>

#include "stepmill/toolpath/toolpath.h"
#include "toolpath/emit.h"

namespace stepmill {
namespace {

class PlainRapids {
  public:
    PlainRapids(const Toolpath& path, double fed_below_mm) : path_(path), fed_below_mm_(fed_below_mm) {
        made_ = path;
        made_.moves.clear();
    }

    Toolpath make() {
        bool fed = false;
        for (const Move& move : path_.moves) {
            // Straight on at depth over a negative island: fed, as it would be without that.
            const bool over_void = fed && move.kind == MoveKind::Rapid && move.to.z() == at().z();
            fed = move.kind != MoveKind::Rapid || over_void;
            if (over_void)
                add(MoveKind::Feed, move.to);
            else if (move.kind == MoveKind::Rapid)
                rapidTo(move.to);
            else
                made_.moves.push_back(move);
        }
        return std::move(made_);
    }

  private:
    Vec3 at() const { return made_.moves.empty() ? made_.start : made_.moves.back().to; }

    void add(MoveKind kind, const Vec3& to) {
        if (to != at()) made_.moves.push_back({kind, to, std::nullopt, kind != MoveKind::Rapid});
    }

    void rapidTo(const Vec3& to) {
        if (to.head<2>() != at().head<2>()) {
            const double cross_z_mm = path_.start.z();
            add(MoveKind::Rapid, Vec3(at().x(), at().y(), cross_z_mm));
            add(MoveKind::Rapid, Vec3(to.x(), to.y(), cross_z_mm));
        }
        if (to.z() < at().z()) {
            const double rapid_z_mm = std::min(at().z(), std::max(to.z(), fed_below_mm_));
            add(MoveKind::Rapid, Vec3(to.x(), to.y(), rapid_z_mm));
            add(MoveKind::Plunge, to);
        } else {
            add(MoveKind::Rapid, to);
        }
    }

    const Toolpath& path_;
    double fed_below_mm_;
    Toolpath made_;
};

}  // namespace

Toolpath withPlainRapids(const Toolpath& path, double stock_top_z_mm, const Machine& machine) {
    const double over_top_mm = std::max(toolpath::kApproachMm, machine.top_clearance_mm);
    Toolpath made = PlainRapids(path, stock_top_z_mm + over_top_mm).make();
    made.totals = measure(made, machine);
    return made;
}

}  // namespace stepmill
