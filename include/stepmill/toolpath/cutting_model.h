#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/material.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// What keeps a feed from being higher.
enum class FeedLimit {
    ToolFeed,  ///< the cutting data's feed
    Chip,      ///< a thin cut may go faster than that, by so much
    Rated,     ///< the tool's rated removal rate
    Slot,      ///< a wide cut deeper than the slot step-down
    Power,     ///< the spindle's power
    Torque,    ///< its torque: it turns slower than where it gives its most
    Machine,   ///< the machine's highest feed
    Bending    ///< driven beyond the cutting data's feed the tool would bend by more than kMostDeflectionMm
};
std::string toString(FeedLimit limit);
/// The reverse; nothing for another word.
std::optional<FeedLimit> feedLimitFrom(std::string_view word);

/// A thin cut goes no faster than this times the cutting feed.
inline constexpr double kMostChipThinning = 1.5;

/// A tool that bends by more at its tip makes walls that lean, and breaks [mm].
inline constexpr double kMostDeflectionMm = 0.1;

/// A cut of one tool in one material on one machine: all that its forces follow from.
struct CuttingFacts {
    double diameter_mm = 0;
    int flutes = 0;           ///< 0: not told, kUsualFlutes stand
    double stick_out_mm = 0;  ///< tip to holder
    CutterMaterial cutter_material = CutterMaterial::Carbide;
    double step_over_mm = 0;  ///< the width that feed and rating are for
    double step_down_mm = 0;  ///< the depth that they are for
    double slot_step_down_mm = 0;
    double rated_removal_mm3_per_min = 0;
    double feed_mm_per_min = 0;
    double max_feed_mm_per_min = 0;  ///< of the machine; 0: no limit
    double speed_rpm = 0;
    double kc11_n_per_mm2 = 0;
    double mc = 0;
    double spindle_kw = 0;  ///< that the motor gives at that speed
    bool by_torque = false;
    double efficiency = 1;  ///< what of it gets to the cutter
    /// All that the cutting data limit may be so many times higher, within what else limits feeds; no more
    /// than kMostChipThinning.
    double pace = 1;
};

/// By the catalog's values.
/// \param cutting  within the machine's speed and feed (limitedBy()). Nothing for a
/// drill, and where the machine's file has no spindle.
std::optional<CuttingFacts> cuttingFacts(const ToolAssembly& tool, const CuttingData& cutting,
                                         const Material& material, const Machine& machine);

/// A feed and what keeps it from being higher.
struct LimitedFeed {
    double feed_mm_per_min = 0;
    FeedLimit limit = FeedLimit::ToolFeed;
};

/// How fast a cut of some width and depth may go, and what it asks of spindle and tool.
/// \see docs/algorithms/cutting-model.md for the formulas
class CuttingModel {
  public:
    explicit CuttingModel(const CuttingFacts& facts);

    const CuttingFacts& facts() const { return facts_; }

    /// The highest feed for a cut of that radial width and axial depth; never higher for a wider or a deeper
    /// one. Air, of no width or depth, may be fed as the thinnest cut. At a pace over 1 it is never lower
    /// than at 1, never over kMostChipThinning times the cutting feed, and asks for no more than the spindle
    /// gives.
    LimitedFeed feedFor(double width_mm, double depth_mm) const;

    /// What the cut asks of the spindle's motor [kW].
    double powerKw(double width_mm, double depth_mm, double feed_mm_per_min) const;

    /// How far the force along the edge's way bends the tool at its tip [mm]: a beam of 0.8 of the diameter,
    /// held at the holder.
    double deflectionMm(double width_mm, double depth_mm, double feed_mm_per_min) const;

  private:
    double meanChipMm(double width_mm, double feed_mm_per_min) const;
    double chipThinning(double width_mm) const;
    double slotStepDownFor(double width_mm) const;
    double powerLimitedFeed(double width_mm, double depth_mm) const;
    double bendingLimitedFeed(double width_mm, double depth_mm) const;
    LimitedFeed feedAt(double pace, double width_mm, double depth_mm) const;

    CuttingFacts facts_;
};

}  // namespace stepmill
