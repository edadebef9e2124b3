#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stepmill/layers/layer_stack.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// What passes leave of so little area is named, however small the feature; more than a small share of it is
/// a fault of its path [mm2].
inline constexpr double kCrumbMm2 = 0.01;

/// A feature as it can be planned below others that left material standing and beside fixtures.
struct ReducedFeature {
    Feature feature;                ///< with an empty target when nothing of it is free
    std::vector<Residual> blocked;  ///< what of the feature lies below material that stays, or fixtures
};

/// The planned feature of an id.
using PlannedById = std::function<const PlannedFeature&(const std::string& id)>;

/// The features that a feature waits for directly, ...
std::vector<const PlannedFeature*> parentsOf(const Feature& feature, const PlannedById& planned);
/// ... and with those that these wait for: nearest first, each once.
std::vector<const PlannedFeature*> ancestorsOf(const Feature& feature, const PlannedById& planned);

/// Takes what the features above left, and the fixtures that reach above its floor, out of a feature's target
/// and adds them to what cutter and holder must keep clear of: no tool meets material that was believed gone,
/// nor what holds the part. A through hole with a fixture under it is through no more: drills stop at its
/// floor. \param parents    the feature's own parents, planned \param ancestors  all features it waits for,
/// planned
ReducedFeature reduced(const Feature& feature, const std::vector<const PlannedFeature*>& parents,
                       const std::vector<const PlannedFeature*>& ancestors,
                       const std::vector<Fixture>& fixtures, const Tolerances& tol);

/// The setup's fixtures as the file says, grown, instead of the vise; nothing changes where the file does not
/// name the setup. \throws Error(Usage) for a fixture that stands in the stock.
void setFixtures(Stage& stage, const FixtureFile& given, const Tolerances& tol);

/// Height of the highest over the stock's top; 0 where none stands over it [mm].
double highestFixtureMm(const std::vector<Fixture>& fixtures);

/// The library less cutting data that no program can be made with: feeds that the machine's spindle slows
/// to nothing, and depths of cut so thin that the stock's height takes more than toolpath::kMostLayers of
/// them. Each tool that loses its data is a warning "tool-unusable".
ToolLibrary usableLibrary(const ToolLibrary& library, const SequenceOptions& options, const Machine& machine,
                          double deepest_mm, std::vector<Warning>& warnings);

/// Height of the stock in the setup where it stands tallest [mm].
double tallestStockMm(const std::vector<Setup>& setups);

/// What must be machined before a feature.
struct Precedence {
    std::string feature_id;
    std::vector<std::string> parents;
    int setup = 0;  ///< number of its setup; it waits for the setups before through its parents alone
};

/// The features of all setups, those of a setup after all of the setup before.
std::vector<Precedence> inSetupOrder(const std::vector<PlannedSetup>& setups);

/// How many partial orders the look-ahead keeps after each tool change.
inline constexpr std::size_t kBeamWidth = 16;

/// The tools in the order of their visits, as few as a beam search finds: each feature's operations keep
/// their order, and parents come before their children. One entry a visit, an index into tools named in the
/// order of their first appearance.
std::vector<int> toolVisits(const std::vector<Operation>& operations, const std::vector<Precedence>& features,
                            std::size_t beam_width);

/// Puts operations in an order that keeps parents before children and each feature's own tool order, and
/// that changes tools as rarely as a greedy look-ahead finds. Returns indices into `operations`.
/// \param features  parents before children
std::vector<int> orderOperations(const std::vector<Operation>& operations,
                                 const std::vector<Precedence>& features);

/// The features' sequences chosen for the plan: one of choicesOf() each.
struct SharedChoice {
    std::vector<std::size_t> choice;  ///< of each feature; 0 where it has none
    ToolSharing gain;
};

/// Chooses one sequence a feature so that paths and tool changes of the whole plan, operations merged, weigh
/// least, and no more tools are called than the magazine has places, as far as the choices allow: first the
/// places, then the weight. Exact where the choices have few combinations (kMostCombinations); else from each
/// feature's own cheapest by giving up tools and changing single features as long as that helps. Never worse
/// than the features' own cheapest.
/// \param choices        of each feature, its own cheapest first
/// \param change_weight  of one tool change, in the unit of the choices' paths
/// \param magazine       places for tools; 0: no limit
SharedChoice shareTools(const std::vector<Precedence>& features,
                        const std::vector<std::vector<SequenceChoice>>& choices, double change_weight,
                        int magazine);

/// Makes the features' sequences anew where shareTools() finds better ones for the plan together. All choices
/// leave the same material, so what later setups found stands.
void shareTools(Plan& plan);

/// The steps of all features become operations, in machining order and numbered in it.
/// \param cautions  features whose mills get plain rapids
void makeOperations(Plan& plan, const Cautions& cautions);

/// Sets every tool of a range out as short as all its steps in the plan allow.
void setStickOuts(Plan& plan);

/// Names steps that take much of a feature's time for little of its volume.
void warnOfSlowSteps(Plan& plan, const PlannedSetup& setup);

/// Joins operations in their order: each begins with the rapid from where the one before it ended, so that
/// an operation's lengths and times are those of its part of the program.
void linkOperations(std::vector<Operation>& operations, const Machine& machine);

/// Times of every setup and of the plan; tool changes counted once a visit.
void addUpTotals(Plan& plan);

/// The residual under a floor that the tools do not reach; nothing when they do.
const Residual* belowReach(const PlannedFeature& planned);

/// What the steps of a feature take away: its target less residuals that stand over its whole depth, down to
/// where its tools reach. Residuals over a part of the depth (a drill's point) stand as a layer of the same
/// volume on the floor.
std::vector<Prism> removedBy(const PlannedFeature& planned, const Tolerances& tol);
/// The same of a whole setup.
std::vector<Prism> removedBy(const std::vector<PlannedFeature>& features, const Tolerances& tol);

/// A setup with its layers and its stock account, for the books.
struct SetupAccount {
    const PlannedSetup* planned = nullptr;
    const LayerStack* layers = nullptr;
    StockStep stock;
    StageAir air;
    std::vector<Prism> removed;  ///< in setup coordinates
};

/// A residual as it stands.
struct ResidualPrism {
    StayReason reason;
    double volume_mm3 = 0;
    Prism prism;
};
std::vector<ResidualPrism> residualPrisms(const std::vector<PlannedFeature>& features);

/// A prism and the setup in whose coordinates it is.
struct SetupPrism {
    const Setup* setup = nullptr;
    Prism prism;
};
/// Share of the prism's volume that lies in none of the others, from points in it [0..1].
double shareOutside(const Setup& setup, const Prism& prism, const std::vector<SetupPrism>& others);

/// The books of one setup.
VolumeBalance setupBooks(const SetupAccount& account);
/// The books of the part, from those of the setups. Whether a residual of an early setup is still there at
/// the end is asked at points in it, so the split by reason is an estimate; the sums are not. \pre every
/// setup's balance is filled
VolumeBalance partBooks(const std::vector<SetupAccount>& accounts, double stock_minus_part_mm3);

/// Where books do not close: the setup and slab with the largest difference, with its sign, in words; empty
/// when every account closes.
std::string largestGap(const std::vector<SetupAccount>& accounts, double stock_minus_part_mm3,
                       const Tolerances& tol);

/// Doubts about the part file and the slicing.
void warnOfInput(Plan& plan, const LayerStack& layers);
/// What was planned anew or dropped, and what the proof had said.
void warnOfCautions(Plan& plan, const Cautions& cautions);
/// More tools than the magazine has places.
void warnOfMagazine(Plan& plan);
/// Residuals, travel, slow steps.
void warnOfSetup(Plan& plan, const PlannedSetup& setup);
/// What no setup plans, one warning a reason. \pre the books are made up
void warnOfUnreachable(Plan& plan);
/// Books of part and setups that do not close, with the difference located.
void warnOfBooks(Plan& plan, const std::vector<SetupAccount>& accounts, const Tolerances& tol);
/// Says so when much of what is to be removed, or of the part's surface, asks for more than 2.5 axes.
/// \pre the books are made up
void warnOfShape(Plan& plan);

}  // namespace stepmill
