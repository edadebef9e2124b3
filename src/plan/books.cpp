#include "stepmill/plan/books.h"

#include <fmt/format.h>

#include "plan/residual_prisms.h"

namespace stepmill {
namespace {

/// Volumes by reason [mm3].
class Account {
  public:
    double& operator[](const StayReason& reason) { return volumes_[reason]; }
    double at(const StayReason& reason) const {
        const auto found = volumes_.find(reason);
        return found == volumes_.end() ? 0 : found->second;
    }
    auto begin() const { return volumes_.begin(); }
    auto end() const { return volumes_.end(); }
    void add(const std::vector<ReasonVolume>& list) {
        for (const ReasonVolume& entry : list)
            volumes_[entry.reason] += entry.volume_mm3;
    }
    double sum() const {
        double sum_mm3 = 0;
        for (const auto& [reason, volume_mm3] : volumes_)
            if (volume_mm3 > 0) sum_mm3 += volume_mm3;
        return sum_mm3;
    }
    /// One entry a reason, in the order of the names; what is nothing falls away.
    std::vector<ReasonVolume> list() const {
        std::vector<ReasonVolume> list;
        for (const auto& [reason, volume_mm3] : volumes_)
            if (volume_mm3 > 0) list.push_back({reason, volume_mm3});
        return list;
    }
    /// Takes a volume off all entries, in proportion.
    void lessen(double by_mm3) {
        const double sum_mm3 = sum();
        if (sum_mm3 <= 0 || by_mm3 <= 0) return;
        const double keep = std::max(0.0, 1 - by_mm3 / sum_mm3);
        for (auto& [reason, volume_mm3] : volumes_)
            volume_mm3 *= keep;
    }

  private:
    std::map<StayReason, double, InOrderOfWords> volumes_;
};

void setLeft(VolumeBalance& books, const Account& residual, const Account& unreachable) {
    books.residual_by_reason = residual.list();
    books.unreachable_by_reason = unreachable.list();
    books.residual_mm3 = residual.sum();
    books.unreachable_mm3 = unreachable.sum();
}

/// Removal of a slab that its features and its unplanned volumes do not account for [mm3].
double slabGap(const Layer& layer, const PlannedSetup& setup) {
    double gap = (area(layer.stock) - area(layer.part)) * layer.height_mm() + layer.sloped_volume_mm3 -
                 layer.stock_air_mm3;
    for (const PlannedFeature& planned : setup.features) {
        const Feature& feature = planned.feature;
        if (layer.isWithin(feature.top_z_mm, feature.floor_z_mm)) gap -= feature.area_mm2 * layer.height_mm();
    }
    for (const Unplanned& unplanned : setup.unplanned) {
        if (!layer.isWithin(unplanned.top_z_mm, unplanned.bottom_z_mm)) continue;
        const double height = unplanned.top_z_mm - unplanned.bottom_z_mm;
        gap -= unplanned.volume_mm3 * layer.height_mm() / height;
    }
    return gap;
}

/// What stays of a setup's features: what their tools leave, allowance and held stock.
std::vector<ResidualPrism> leftIn(const PlannedSetup& setup) {
    std::vector<ResidualPrism> left = residualPrisms(setup.features);
    for (const Unplanned& entry : setup.unplanned)
        if (isLeftUncut(entry.reason))
            left.push_back({entry.reason,
                            entry.volume_mm3,
                            {entry.region, entry.top_z_mm, entry.bottom_z_mm},
                            nullptr,
                            nullptr});
    return left;
}

/// What a setup takes away, and what it names as staying.
std::vector<SetupPrism> accountedFor(const SetupAccount& account) {
    std::vector<SetupPrism> prisms;
    for (const Prism& prism : account.removed)
        prisms.push_back({&account.planned->setup, prism});
    for (const ResidualPrism& residual : leftIn(*account.planned))
        prisms.push_back({&account.planned->setup, residual.prism});
    return prisms;
}

/// The later setup that has most of the prism; empty where none has any.
std::string takerOf(const Setup& setup, const Prism& prism,
                    const std::vector<std::vector<SetupPrism>>& accounted, std::size_t first_later) {
    std::string taker;
    double least_outside = 1;
    for (std::size_t later = first_later; later < accounted.size(); ++later) {
        const double outside = shareOutside(setup, prism, accounted[later]);
        if (outside >= least_outside) continue;
        least_outside = outside;
        taker = accounted[later].front().setup->id;
    }
    return taker;
}

/// What of an early setup's residuals is still there at the end and not in a later setup's own list.
void addEarlierResiduals(const std::vector<SetupAccount>& accounts, Account& by_reason,
                         StayingResiduals& staying) {
    std::vector<std::vector<SetupPrism>> accounted;
    for (const SetupAccount& account : accounts)
        accounted.push_back(accountedFor(account));
    std::vector<SetupPrism> gone;
    for (std::size_t i = accounts.size(); i-- > 0;) {
        const Setup& setup = accounts[i].planned->setup;
        for (const ResidualPrism& residual : leftIn(*accounts[i].planned)) {
            if (i + 1 == accounts.size()) break;
            const double share = shareOutside(setup, residual.prism, gone);
            by_reason[residual.reason] += residual.volume_mm3 * share;
            if (residual.of == nullptr) continue;
            staying[residual.of] = {residual.volume_mm3 * share,
                                    share < 1 ? takerOf(setup, residual.prism, accounted, i + 1) : ""};
        }
        gone.insert(gone.end(), accounted[i].begin(), accounted[i].end());
    }
}

void scale(StayingResiduals& staying, double by) {
    for (auto& [residual, entry] : staying)
        entry.stays_mm3 *= by;
}

/// The last setup's residuals all stay, less the air among them.
void addLastResiduals(const PlannedSetup& last, double residual_mm3, StayingResiduals& staying) {
    double sum_mm3 = 0;
    for (const Unplanned& entry : last.unplanned)
        if (isLeftUncut(entry.reason)) sum_mm3 += entry.volume_mm3;
    for (const PlannedFeature& planned : last.features)
        sum_mm3 += residualVolumeMm3(planned.sequence);
    const double share = sum_mm3 > 0 ? residual_mm3 / sum_mm3 : 0;
    for (const PlannedFeature& planned : last.features)
        for (const Residual& residual : planned.sequence.residual)
            staying[&residual] = {residual.volume_mm3 * share, {}};
}

/// What form operations take of what leaning walls hide moves to what is planned; returns what of it is not
/// among those volumes.
double moveFormCuts(const PlannedSetup& planned, double& planned_mm3, Account& hidden) {
    double missing_mm3 = 0;
    for (const Operation& operation : planned.operations)
        for (const ReasonVolume& taken : operation.takes) {
            double& there_mm3 = hidden[taken.reason];
            const double moved_mm3 = std::min(there_mm3, taken.volume_mm3);
            there_mm3 -= moved_mm3;
            planned_mm3 += taken.volume_mm3;
            missing_mm3 += taken.volume_mm3 - moved_mm3;
        }
    return missing_mm3;
}

/// What of the last setup's residuals lies in stairs that form cutters of earlier setups took off.
Account residualsInStairs(const std::vector<SetupAccount>& accounts) {
    std::vector<SetupPrism> stairs;
    for (std::size_t i = 0; i + 1 < accounts.size(); ++i)
        if (const PlannedSetup& planned = *accounts[i].planned; planned.form)
            for (const Obstacle& stair : planned.form->stairs)
                stairs.push_back({&planned.setup, {stair.section, stair.top_z_mm, stair.bottom_z_mm}});
    Account there;
    if (stairs.empty()) return there;
    const PlannedSetup& last = *accounts.back().planned;
    for (const ResidualPrism& residual : leftIn(last))
        there[residual.reason] +=
            residual.volume_mm3 * (1 - shareOutside(last.setup, residual.prism, stairs));
    return there;
}

/// Takes a volume that form cutters took off what stays: first off residuals in their stairs, then off what
/// is out of reach, then off all other residuals.
void lessenByForms(double by_mm3, const Account& in_stairs, Account& residual, Account& unreachable) {
    const double in_stairs_mm3 = in_stairs.sum();
    const double share = in_stairs_mm3 > 0 ? std::min(1.0, by_mm3 / in_stairs_mm3) : 0;
    for (const auto& [reason, volume_mm3] : in_stairs) {
        const double gone_mm3 = std::min(residual[reason], share * volume_mm3);
        residual[reason] -= gone_mm3;
        by_mm3 -= gone_mm3;
    }
    const double reachable_mm3 = std::min(by_mm3, unreachable.sum());
    unreachable.lessen(reachable_mm3);
    residual.lessen(by_mm3 - reachable_mm3);
}

/// A wall that looks away from the last setup is an overhang to it, to another one the fillet or chamfer that
/// it did not finish: that is what to say of it, as far as that setup's books have it.
void nameFromOtherSides(const std::vector<VolumeBalance>& setups, Account& unreachable) {
    const StayReason overhang{Reason::Overhang, {}};
    Account seen;
    for (const VolumeBalance& setup : setups)
        for (const ReasonVolume& entry : setup.unreachable_by_reason)
            if (isOnLeaningWall(entry.reason)) seen[entry.reason] += entry.volume_mm3;
    Account more;
    for (const auto& [reason, volume_mm3] : seen)
        more[reason] = std::max(0.0, volume_mm3 - unreachable.at(reason));
    const double hidden_mm3 = unreachable.at(overhang);
    more.lessen(more.sum() - hidden_mm3);
    for (const auto& [reason, volume_mm3] : more)
        unreachable[reason] += volume_mm3;
    const double still_mm3 = hidden_mm3 - more.sum();
    unreachable[overhang] = still_mm3 > kVolumeRoundingMm3 ? still_mm3 : 0;
}

/// The books of one setup.
VolumeBalance setupBooks(const SetupAccount& account) {
    VolumeBalance books;
    const PlannedSetup& planned = *account.planned;
    books.stock_minus_part_mm3 = planned.setup.stock.volume_mm3 - planned.setup.part.volume_mm3;
    double features_mm3 = 0;
    Account residual;
    for (const PlannedFeature& feature : planned.features) {
        features_mm3 += feature.feature.volume_mm3;
        for (const Residual& left : feature.sequence.residual)
            residual[left.reason] += left.volume_mm3;
    }
    books.planned_mm3 = features_mm3 - residual.sum();
    Account unreachable;
    for (const Unplanned& unplanned : planned.unplanned) {
        (isLeftUncut(unplanned.reason) ? residual : unreachable)[unplanned.reason] += unplanned.volume_mm3;
    }
    double residual_mm3 = residual.sum();
    // Where the stock's walls lean, prisms hold air that earlier setups cut from other sides: what went is
    // what the solid lost.
    const SettledAir air = settleAir(account.air, books.planned_mm3, account.stock.removed_mm3);
    books.planned_mm3 -= air.in_prisms_mm3;
    if (!planned.setup.stock.isRaw()) {
        // Residuals of features that hold air are area times height: what of them was air is not left.
        const double air_left_mm3 =
            std::clamp(account.stock.removed_mm3 - books.planned_mm3, 0.0, residual_mm3);
        books.planned_mm3 += air_left_mm3;
        residual.lessen(air_left_mm3);
        residual_mm3 -= air_left_mm3;
    }
    unreachable[{Reason::LeaningWall, {}}] += air.back_mm3;
    residual.lessen(air.left_mm3);
    unreachable.lessen(air.left_mm3 - residual_mm3);
    unreachable.lessen(moveFormCuts(planned, books.planned_mm3, unreachable));
    setLeft(books, residual, unreachable);
    return books;
}

/// The books of the part, from those of the setups.
VolumeBalance partBooks(const std::vector<SetupAccount>& accounts, const std::vector<VolumeBalance>& setups,
                        double stock_minus_part_mm3, StayingResiduals& staying) {
    VolumeBalance books;
    books.stock_minus_part_mm3 = stock_minus_part_mm3;
    if (accounts.empty()) {
        books.unreachable_mm3 = std::max(0.0, stock_minus_part_mm3);
        return books;
    }
    for (const VolumeBalance& setup : setups)
        books.planned_mm3 += setup.planned_mm3;
    // What is left is what the last setup sees and does not cut; earlier residuals are unreachable to it.
    const VolumeBalance& last = setups.back();
    Account residual;
    Account unreachable;
    unreachable.add(last.unreachable_by_reason);
    // Form operations of earlier setups are no part of the stock that the last one sees. It may call what
    // they took by other names, what its own tools leave among them.
    double moved_mm3 = 0;
    double otherwise_mm3 = 0;
    for (std::size_t i = 0; i + 1 < accounts.size(); ++i)
        otherwise_mm3 += moveFormCuts(*accounts[i].planned, moved_mm3, unreachable);
    addEarlierResiduals(accounts, residual, staying);
    const double found_mm3 = residual.sum();
    const double earlier_mm3 = std::min(found_mm3, unreachable.sum());
    residual.lessen(found_mm3 - earlier_mm3);
    if (found_mm3 > 0) scale(staying, earlier_mm3 / found_mm3);
    addLastResiduals(*accounts.back().planned, last.residual_mm3, staying);
    unreachable.lessen(earlier_mm3);
    residual.add(last.residual_by_reason);
    const double with_stairs_mm3 = residual.sum();
    lessenByForms(otherwise_mm3, residualsInStairs(accounts), residual, unreachable);
    if (with_stairs_mm3 > 0) scale(staying, residual.sum() / with_stairs_mm3);
    nameFromOtherSides(setups, unreachable);
    setLeft(books, residual, unreachable);
    return books;
}

/// The setup and slab with the largest difference, in words.
std::string largestGap(const std::vector<SetupAccount>& accounts, double stock_minus_part_mm3,
                       const Tolerances& tol) {
    std::string where;
    double worst_mm3 = tol.volume_share * stock_minus_part_mm3 / 10;
    for (const SetupAccount& account : accounts) {
        for (const Layer& layer : account.layers->layers) {
            const double gap = slabGap(layer, *account.planned);
            if (std::abs(gap) <= std::abs(worst_mm3)) continue;
            worst_mm3 = gap;
            where = fmt::format("largest difference {:+.4g} mm3 between z {:.4g} and {:.4g} mm of {}", gap,
                                layer.top_z_mm, layer.bottom_z_mm, account.planned->setup.id);
        }
    }
    return where;
}

/// What of it stays against the plan's will.
double unwantedMm3(const std::vector<ReasonVolume>& left, bool roughing) {
    double sum_mm3 = 0;
    for (const ReasonVolume& entry : left)
        if (!(entry.reason == Reason::AsAsked) && (!roughing || !isLeftByRoughing(entry.reason)))
            sum_mm3 += entry.volume_mm3;
    return sum_mm3;
}

}  // namespace

double VolumeBalance::gapMm3() const {
    return stock_minus_part_mm3 - planned_mm3 - residual_mm3 - unreachable_mm3;
}

bool closes(const VolumeBalance& setup, double stock_minus_part_mm3, const Tolerances& tol) {
    return std::abs(setup.gapMm3()) <= std::max(kVolumeRoundingMm3, tol.volume_share * stock_minus_part_mm3);
}

double VolumeBalance::gapShare() const {
    if (stock_minus_part_mm3 <= kVolumeRoundingMm3) return 0;
    return std::abs(gapMm3()) / stock_minus_part_mm3;
}

PlanBooks booksOf(const std::vector<SetupAccount>& accounts, double stock_minus_part_mm3,
                  const Tolerances& tol) {
    PlanBooks books;
    for (const SetupAccount& account : accounts)
        books.setups.push_back(setupBooks(account));
    books.part = partBooks(accounts, books.setups, stock_minus_part_mm3, books.staying);
    if (books.part.gapShare() > tol.volume_share)
        books.largest_gap = largestGap(accounts, stock_minus_part_mm3, tol);
    return books;
}

bool leavesNothing(const VolumeBalance& part, bool roughing, const Tolerances& tol) {
    // A residual of one setup may be gone in a later one: what counts is what is left at the end.
    if (unwantedMm3(part.residual_by_reason, roughing) > kVolumeRoundingMm3) return false;
    const double rounding_mm3 = std::max(kVolumeRoundingMm3, tol.volume_share * part.stock_minus_part_mm3);
    return unwantedMm3(part.unreachable_by_reason, roughing) <= rounding_mm3;
}

}  // namespace stepmill
