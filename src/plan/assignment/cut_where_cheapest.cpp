// Which setup cuts what.

#include "plan/assignment/cut_where_cheapest.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "plan/assignment/propose_reserve.h"
#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

constexpr EnumWord<Verdict> kVerdicts[] = {{Verdict::SavesTooLittle, "saves too little"},
                                           {Verdict::MoreSetups, "more setups"},
                                           {Verdict::HeldWorse, "held worse"},
                                           {Verdict::MoreStays, "more stays"},
                                           {Verdict::Taken, "taken"}};

/// Two plans' books differ by so much of stock minus part where cuts are seen from the side, whatever stays.
constexpr double kBooksNoiseShare = 1e-6;
/// Where something stays anyway, so much more of it may: other tools reach a little less of a corner or more.
constexpr double kMoreMayStayShare = 0.005;
/// A plan must be shorter by so much to be taken: feeds and leaning walls, which come later, are not in it.
constexpr double kWorthChanging = 0.99;

/// Setups with what the books say of the part: a long sum, only made where trials are compared.
struct Booked {
    CutSetups cut;
    std::optional<VolumeBalance> books;
};

/// How many setups nothing is known that would hold them.
auto unheld(const CutSetups& cut) {
    return std::count_if(cut.setups.begin(), cut.setups.end(),
                         [](const PlannedSetup& setup) { return setup.clamping.kind == HoldKind::None; });
}

std::size_t loosePieces(const CutSetups& cut) {
    std::size_t sum = 0;
    for (const PlannedStage& stage : cut.stages)
        sum += stage.loose.size();
    return sum;
}

/// Do clamps that a shop's file gives by the setups' numbers stand in the same setups?
bool clampedAlike(const CutSetups& cut, const CutSetups& than, const FixtureFile& shop) {
    if (shop.setups.empty()) return true;
    return std::equal(cut.stages.begin(), cut.stages.end(), than.stages.begin(), than.stages.end(),
                      [](const PlannedStage& a, const PlannedStage& b) { return a.place == b.place; });
}

/// A trial is taken if it is clearly shorter, or cheaper if plans are made by cost, with no more setups, held
/// as well, and if no more stays.
Verdict verdictOn(const Booked& trial, const Booked& best, const PlanRequest& request) {
    const CutSetups& cut = trial.cut;
    const CutSetups& than = best.cut;
    const auto weight = [&](const PlanTotals& totals) {
        return request.sequence.objective == Objective::Time ? totals.motion_s : totals.cost;
    };
    const double noise_mm3 =
        std::max(kVolumeRoundingMm3, kBooksNoiseShare * best.books->stock_minus_part_mm3);
    const double may_stay_mm3 =
        best.books->leftMm3() + std::max(noise_mm3, kMoreMayStayShare * best.books->leftMm3());
    if (weight(cut.totals) >= kWorthChanging * weight(than.totals)) return Verdict::SavesTooLittle;
    if (cut.setups.size() > than.setups.size()) return Verdict::MoreSetups;
    if (unheld(cut) > unheld(than) || loosePieces(cut) > loosePieces(than) ||
        !clampedAlike(cut, than, request.fixtures))
        return Verdict::HeldWorse;
    const bool books_close = std::abs(trial.books->gapMm3()) <= std::abs(best.books->gapMm3()) + noise_mm3;
    return trial.books->leftMm3() > may_stay_mm3 || !books_close ? Verdict::MoreStays : Verdict::Taken;
}

/// The setups as they would be cut if one of them left stock.
struct Trial {
    ReserveProposal proposal;
    std::vector<CutPrisms> reserves;
    Booked made;
};

/// Trials end when few tools would begin to be weighed: what comes after the choice needs that time.
PlanRequest withoutSpareTime(PlanRequest request) {
    request.patience.few_tools = request.patience.all_tools;
    request.patience.setup_share = 1;
    return request;
}

class Trials {
  public:
    Trials(const std::vector<Setup>& setups, double stock_minus_part_mm3, PlanningShop shop,
           const Progress& progress)
        : setups_(setups), stock_minus_part_mm3_(stock_minus_part_mm3), shop_(shop), progress_(progress) {}

    /// What the i-th of the setups that cut might leave; nothing where it is not worth a trial. A trial that
    /// cannot be planned must not lose the plan there is.
    std::optional<Trial> leaving(const CutSetups& best, std::size_t i,
                                 std::vector<CutPrisms> reserves) const {
        const std::size_t place = best.stages[i].place;
        if (progress_) progress_("what " + best.setups[i].setup.id + " might leave for later setups", 1);
        try {
            // A setup that has nothing to cut would be one more.
            std::vector<std::size_t> later;
            for (std::size_t after = i + 1; after < best.stages.size(); ++after)
                later.push_back(best.stages[after].place);
            auto proposal = proposeReserve(best.setups[i], best.stages[i].layers, setups_, later, shop_);
            if (!proposal) return std::nullopt;
            reserves[place] = proposal->reserve;
            Booked made{cutSetups(setups_, reserves, shop_, progress_), std::nullopt};
            addBooks(made);
            return Trial{std::move(*proposal), std::move(reserves), std::move(made)};
        } catch (const std::exception&) {
            return std::nullopt;
        }
    }

    void addBooks(Booked& made) const {
        if (!made.books)
            made.books = booksOf(made.cut.setups, made.cut.stages, stock_minus_part_mm3_, shop_.tol).part;
    }

  private:
    const std::vector<Setup>& setups_;
    double stock_minus_part_mm3_;
    PlanningShop shop_;
    const Progress& progress_;
};

}  // namespace

std::string toString(Verdict verdict) {
    return wordOf(kVerdicts, verdict);
}

std::optional<Verdict> verdictFrom(std::string_view word) {
    return valueOf(kVerdicts, word);
}

CutSetups cutWhereCheapest(const std::vector<Setup>& setups, double stock_minus_part_mm3,
                           const PlanningShop& shop, const Progress& progress, Assignment& assignment) {
    const PlanRequest& request = shop.request;
    assignment.reserves.resize(setups.size());
    Booked best{cutSetups(setups, assignment.reserves, shop, progress), std::nullopt};
    if (request.assignment || !request.assign || request.roughing) return std::move(best.cut);
    const PlanRequest hasty = withoutSpareTime(request);
    const Trials trials(setups, stock_minus_part_mm3, shop.with(hasty), progress);
    for (std::size_t i = 0; i < best.cut.stages.size() && !request.patience.all_tools.passed(); ++i) {
        std::optional<Trial> trial = trials.leaving(best.cut, i, assignment.reserves);
        if (!trial) continue;
        trials.addBooks(best);
        const Verdict verdict = verdictOn(trial->made, best, request);
        assignment.tried.push_back({best.cut.setups[i].setup.id, std::move(trial->proposal),
                                    best.cut.totals.motion_s, trial->made.cut.totals.motion_s,
                                    trial->made.books->leftMm3() - best.books->leftMm3(), verdict});
        if (verdict != Verdict::Taken) continue;
        best = std::move(trial->made);
        assignment.reserves = std::move(trial->reserves);
    }
    return std::move(best.cut);
}

}  // namespace stepmill
