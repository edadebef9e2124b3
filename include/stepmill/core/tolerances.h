#pragma once

namespace stepmill {

/// Every tolerance of the program, each with one meaning. Passed as an argument, never global.
struct Tolerances {
    /// Deepest a cutter or holder may ever come into what must stay [mm]. The safety budget.
    double gouge_mm = 1e-3;

    /// A cutter enters a slot whose walls are nearer to the slot's middle than its radius by no more than
    /// this [mm]: half of the gouge budget, the other half is for rounding.
    double fit_mm = 5e-4;

    /// Points closer than this are the same point; curves closer than this coincide [mm].
    /// A hundred times the 1 nm grid that planar points live on.
    double linear_mm = 1e-4;

    /// Sagitta of the chords on which shapes are judged, as in classes and wall thickness [mm]. No area and
    /// no position comes from them.
    double chord_mm = 2e-3;

    /// Extra distance tool paths keep from walls, so that rounding never gouges [mm].
    double guard_mm = 2.5e-4;

    /// Strips of centre region narrower than this are rounding, not material worth a pass [mm].
    double sliver_mm = 2e-3;

    /// Free-form edges become lines and arcs no farther away than this, on the safe side [mm].
    double curve_fit_mm = 1e-3;

    /// Directions closer than this are parallel [rad].
    double angular_rad = 1e-6;

    /// Areas smaller than this are nothing [mm2].
    double area_mm2 = 1e-3;

    /// Volume books must close within this share of stock minus part.
    double volume_share = 1e-3;
};

}  // namespace stepmill
