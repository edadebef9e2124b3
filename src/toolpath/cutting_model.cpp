#include "stepmill/toolpath/cutting_model.h"

#include <algorithm>
#include <cmath>

#include "stepmill/catalog/spindle.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

constexpr EnumWord<FeedLimit> kLimits[] = {
    {FeedLimit::ToolFeed, "tool feed"}, {FeedLimit::Chip, "chip"},      {FeedLimit::Rated, "rated"},
    {FeedLimit::Slot, "slot"},          {FeedLimit::Power, "power"},    {FeedLimit::Torque, "torque"},
    {FeedLimit::Machine, "machine"},    {FeedLimit::Bending, "bending"}};

/// Teeth of a cutter whose library does not say: more than most have, and thin chips ask for more power.
constexpr int kUsualFlutes = 4;
/// Stiffness of what cutters are made of [N/mm2].
constexpr double kCarbideModulus = 600e3;
constexpr double kHssModulus = 210e3;
/// A fluted cutter bends like a plain rod of this share of its diameter.
constexpr double kCoreShare = 0.8;
/// N mm per minute that make a kilowatt.
constexpr double kNmmPerMinPerKw = 6e7;

}  // namespace

std::string toString(FeedLimit limit) {
    return wordOf(kLimits, limit);
}

std::optional<FeedLimit> feedLimitFrom(std::string_view word) {
    return valueOf(kLimits, word);
}

std::optional<CuttingFacts> cuttingFacts(const ToolAssembly& tool, const CuttingData& cutting,
                                         const Material& material, const Machine& machine) {
    const std::optional<SpindlePower> spindle = spindlePower(machine, cutting.speed_rpm);
    if (!spindle || tool.isForHoles()) return std::nullopt;
    CuttingFacts facts;
    facts.diameter_mm = tool.diameter_mm;
    facts.flutes = tool.flutes;
    facts.stick_out_mm = tool.stick_out_mm;
    facts.cutter_material = tool.cutter_material;
    facts.step_over_mm = cutting.step_over_mm;
    facts.step_down_mm = cutting.step_down_mm;
    facts.slot_step_down_mm = slotStepDownMm(tool, cutting);
    facts.rated_removal_mm3_per_min = ratedRemovalMm3PerMin(cutting);
    facts.feed_mm_per_min = cutting.feed_mm_per_min;
    facts.max_feed_mm_per_min = machine.max_feed_mm_per_min;
    facts.speed_rpm = cutting.speed_rpm;
    facts.kc11_n_per_mm2 = material.kc11_n_per_mm2;
    facts.mc = material.mc;
    facts.spindle_kw = spindle->power_kw;
    facts.by_torque = spindle->by_torque;
    facts.efficiency = machine.spindle_efficiency;
    return facts;
}

CuttingModel::CuttingModel(const CuttingFacts& facts) : facts_(facts) {
    STEPMILL_CHECK(facts.diameter_mm > 0 && facts.feed_mm_per_min > 0 && facts.speed_rpm > 0,
                   "a cut has a cutter, a feed and a speed");
    STEPMILL_CHECK(facts.pace <= kMostChipThinning, "no chip is thicker than that");
    if (facts_.flutes <= 0) facts_.flutes = kUsualFlutes;
}

/// Mean over the arc from where a tooth enters to where it leaves: f_z 2 w / (D phi).
double CuttingModel::meanChipMm(double width_mm, double feed_mm_per_min) const {
    const double share = std::clamp(width_mm / facts_.diameter_mm, 0.0, 1.0);
    const double arc_rad = std::acos(1 - 2 * share);
    const double tooth_mm = feed_mm_per_min / (facts_.speed_rpm * facts_.flutes);
    return arc_rad > 0 ? tooth_mm * 2 * share / arc_rad : 0;
}

/// A cut narrower than the step-over makes thinner chips at the same feed per tooth: their greatest thickness
/// is f_z sin(phi).
double CuttingModel::chipThinning(double width_mm) const {
    const auto sine = [&](double w_mm) {
        const double share = std::clamp(w_mm / facts_.diameter_mm, 0.0, 0.5);
        return 2 * std::sqrt(share * (1 - share));
    };
    const double full = sine(facts_.step_over_mm);
    const double thin = sine(std::max(width_mm, 0.0));
    return thin * kMostChipThinning > full ? std::max(1.0, full / thin) : kMostChipThinning;
}

/// From the step-down at the step-over evenly to the slot's at the full width.
double CuttingModel::slotStepDownFor(double width_mm) const {
    const double wide_mm = facts_.diameter_mm - facts_.step_over_mm;
    const double share = wide_mm > 0 ? std::clamp((width_mm - facts_.step_over_mm) / wide_mm, 0.0, 1.0) : 1.0;
    return facts_.step_down_mm + share * (facts_.slot_step_down_mm - facts_.step_down_mm);
}

/// P = w d f kc1.1 / (c f)^mc with the mean chip c f, solved for f.
double CuttingModel::powerLimitedFeed(double width_mm, double depth_mm) const {
    const double cut_kw = facts_.spindle_kw * facts_.efficiency;
    const double chip_per_feed = meanChipMm(width_mm, 1);
    const double kw_per_feed = width_mm * depth_mm * facts_.kc11_n_per_mm2 / kNmmPerMinPerKw;
    return std::pow(cut_kw / kw_per_feed * std::pow(chip_per_feed, facts_.mc), 1 / (1 - facts_.mc));
}

/// The force grows with the feed to the power of 1 - mc, and the bending with the force.
double CuttingModel::bendingLimitedFeed(double width_mm, double depth_mm) const {
    const double feed = facts_.feed_mm_per_min;
    const double bent_mm = deflectionMm(width_mm, depth_mm, feed);
    return feed * std::pow(kMostDeflectionMm / bent_mm, 1 / (1 - facts_.mc));
}

LimitedFeed CuttingModel::feedAt(double pace, double width_mm, double depth_mm) const {
    const double thinning = chipThinning(width_mm);
    const double share = std::min(pace * thinning, kMostChipThinning);
    const bool is_thickest = share == kMostChipThinning;
    LimitedFeed found{facts_.feed_mm_per_min * share,
                      thinning > 1 || is_thickest ? FeedLimit::Chip : FeedLimit::ToolFeed};
    const auto limitTo = [&](double feed_mm_per_min, FeedLimit limit) {
        if (feed_mm_per_min < found.feed_mm_per_min) found = {feed_mm_per_min, limit};
    };
    if (facts_.max_feed_mm_per_min > 0) limitTo(facts_.max_feed_mm_per_min, FeedLimit::Machine);
    const double section_mm2 = width_mm * depth_mm;
    if (width_mm <= 0 || section_mm2 <= 0) return found;
    limitTo(pace * facts_.rated_removal_mm3_per_min / section_mm2, FeedLimit::Rated);
    if (width_mm > facts_.step_over_mm)
        limitTo(pace * facts_.feed_mm_per_min * slotStepDownFor(width_mm) / depth_mm, FeedLimit::Slot);
    limitTo(powerLimitedFeed(width_mm, depth_mm), facts_.by_torque ? FeedLimit::Torque : FeedLimit::Power);
    return found;
}

LimitedFeed CuttingModel::feedFor(double width_mm, double depth_mm) const {
    const LimitedFeed usual = feedAt(1, width_mm, depth_mm);
    if (facts_.pace <= 1) return usual;
    const LimitedFeed driven = feedAt(facts_.pace, width_mm, depth_mm);
    if (width_mm <= 0 || depth_mm <= 0) return driven;
    const double bending = bendingLimitedFeed(width_mm, depth_mm);
    if (bending >= driven.feed_mm_per_min) return driven;
    return {std::max(bending, usual.feed_mm_per_min), FeedLimit::Bending};
}

double CuttingModel::powerKw(double width_mm, double depth_mm, double feed_mm_per_min) const {
    const double chip_mm = meanChipMm(width_mm, feed_mm_per_min);
    if (chip_mm <= 0 || depth_mm <= 0) return 0;
    const double kc = facts_.kc11_n_per_mm2 * std::pow(chip_mm, -facts_.mc);
    return width_mm * depth_mm * feed_mm_per_min * kc / kNmmPerMinPerKw / facts_.efficiency;
}

double CuttingModel::deflectionMm(double width_mm, double depth_mm, double feed_mm_per_min) const {
    const double edge_mm_per_min = kPi * facts_.diameter_mm * facts_.speed_rpm;
    const double cut_kw = powerKw(width_mm, depth_mm, feed_mm_per_min) * facts_.efficiency;
    const double force_n = cut_kw * kNmmPerMinPerKw / edge_mm_per_min;
    const double modulus = facts_.cutter_material == CutterMaterial::Hss ? kHssModulus : kCarbideModulus;
    const double inertia_mm4 = kPi * std::pow(kCoreShare * facts_.diameter_mm, 4) / 64;
    return force_n * std::pow(facts_.stick_out_mm, 3) / (3 * modulus * inertia_mm4);
}

}  // namespace stepmill
