// The claim of a plan.json, derived anew from the files it was made from.

#include "stepmill/verify/claim.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/plan/books.h"
#include "stepmill/plan/common_ground.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/hold_stage.h"
#include "stepmill/plan/removed.h"
#include "stepmill/plan/roughing.h"
#include "stepmill/plan/stages.h"
#include "stepmill/plan/usable_library.h"
#include "verify/claim_form.h"
#include "verify/claim_holes.h"

namespace stepmill {
namespace {

/// Volumes of solids are sums over faces [share].
constexpr double kSameVolumeShare = 1e-6;

bool sameLength(double a, double b) {
    return std::abs(a - b) <= kSameWrittenHeightMm;
}

bool sameVolume(double a, double b) {
    return std::abs(a - b) <= kSameWrittenHeightMm + kSameVolumeShare * std::max(std::abs(a), std::abs(b));
}

bool isDone(const PlanRecord& record, const std::string& feature_id) {
    return std::any_of(record.operations.begin(), record.operations.end(),
                       [&](const auto& entry) { return entry.second.feature_id == feature_id; });
}

/// Down to where the feature's operations go.
double reachedZ(const PlanRecord& record, const Feature& feature) {
    double lowest_mm = feature.top_z_mm;
    for (const auto& [id, operation] : record.operations)
        if (operation.feature_id == feature.id)
            lowest_mm = std::min(lowest_mm, operation.z_floor_mm - operation.leaves.floors_mm);
    return sameLength(lowest_mm, feature.floor_z_mm) ? feature.floor_z_mm : lowest_mm;
}

/// The volume as it was before it was written: area times one of the heights that residuals stand for.
double unrounded(const Residual& residual, double depth_mm, double below_mm) {
    for (const double height_mm : {depth_mm, below_mm})
        if (sameVolume(residual.volume_mm3, residual.area_mm2 * height_mm))
            return residual.area_mm2 * height_mm;
    return residual.volume_mm3;
}

/// The derived feature with what the record says of its tools' work.
/// \param all  with what was named once all setups were planned; no later one was planned with that
PlannedFeature asPlanned(const PlanRecord& record, const Feature& derived, bool all) {
    PlannedFeature planned;
    planned.feature = derived;
    planned.sequence.feature_id = derived.id;
    planned.sequence.floor_z_mm = reachedZ(record, derived);
    if (isDone(record, derived.id)) planned.sequence.steps.emplace_back();
    const double depth_mm = derived.top_z_mm - planned.sequence.floor_z_mm;
    for (const Residual& recorded : record.features.at(derived.id).residual) {
        if (!all && recorded.reason == Reason::LeftBetweenPasses) continue;
        Residual residual = recorded;
        if (!residual.region.empty()) residual.area_mm2 = area(residual.region);
        residual.volume_mm3 = unrounded(residual, depth_mm, derived.depth_mm() - depth_mm);
        planned.sequence.residual.push_back(std::move(residual));
    }
    return planned;
}

/// Compares what was derived for one setup with what the record says of it.
class SetupComparison {
  public:
    SetupComparison(const PlanRecord& record, const RecordedSetup& setup, const Tolerances& tol,
                    std::vector<ProofFailure>& failures)
        : record_(record), setup_(setup), tol_(tol), failures_(failures) {}

    void compare(const Stage& derived, const std::vector<Feature>& features) {
        comparePlace(derived.setup);
        compareClamping(derived.clamping);
        compareFixtures(derived.setup.fixtures);
        for (const Feature& feature : features) {
            const bool known =
                std::count(setup_.feature_ids.begin(), setup_.feature_ids.end(), feature.id) > 0;
            if (known)
                compareFeature(record_.features.at(feature.id).feature, feature);
            else
                fail(feature.id, fmt::format("the part has this feature, {:.6g} mm3, the plan does not",
                                             feature.volume_mm3));
        }
        for (const std::string& id : setup_.feature_ids)
            if (std::none_of(features.begin(), features.end(),
                             [&](const Feature& feature) { return feature.id == id; }))
                fail(id, "the plan has this feature, the part does not");
    }

  private:
    void fail(const std::string& place, const std::string& text) {
        failures_.push_back({"plan.json", 0, place, text});
    }

    void length(const std::string& place, const char* what, double recorded, double derived) {
        if (!sameLength(recorded, derived))
            fail(place, fmt::format("{} is {:.6f}, by the part {:.6f}", what, recorded, derived));
    }

    void region(const std::string& place, const char* what, const Region& recorded, const Region& derived) {
        if (feature::sameRegion(recorded, derived, tol_)) return;
        const Box2 box = boundingBox(derived.empty() ? recorded : derived);
        fail(place,
             fmt::format("{} is not the part's: {:.6g} instead of {:.6g} mm2, within X{:.3f} Y{:.3f} to "
                         "X{:.3f} Y{:.3f}",
                         what, area(recorded), area(derived), box.min().x(), box.min().y(), box.max().x(),
                         box.max().y()));
    }

    void comparePlace(const Setup& derived) {
        const Vec3 size = derived.stock_bbox_mm.sizes();
        for (int i = 0; i < 3; ++i)
            length(setup_.id, "the stock's size", setup_.stock_size_mm[i], size[i]);
        const Eigen::Matrix4d off = setup_.part_to_setup.matrix() - derived.part_to_setup.matrix();
        if (off.cwiseAbs().maxCoeff() > kSameWrittenHeightMm)
            fail(setup_.id, "the transform is not the setup's");
        if (derived.stock.isRaw() && !sameVolume(record_.stock_volume_mm3, derived.stock.volume_mm3))
            fail("stock", fmt::format("its volume is {:.6f}, by part and margins {:.6f}",
                                      record_.stock_volume_mm3, derived.stock.volume_mm3));
    }

    void compareClamping(const Clamping& derived) {
        const Clamping& recorded = setup_.clamping;
        if (recorded.kind != derived.kind)
            return fail(setup_.id, fmt::format("is held by {}, by the part {}", toString(recorded.kind),
                                               toString(derived.kind)));
        length(setup_.id, "the jaws' opening", recorded.opening_mm, derived.opening_mm);
        length(setup_.id, "the grip's depth", recorded.depth_mm, derived.depth_mm);
        length(setup_.id, "the parallels' height", recorded.parallels_mm, derived.parallels_mm);
        length(setup_.id, "the held stock's height", recorded.held_mm, derived.held_mm);
    }

    void compareFixtures(const std::vector<Fixture>& derived) {
        if (setup_.fixtures.size() != derived.size())
            return fail(setup_.id,
                        fmt::format("{} fixtures, expected {}", setup_.fixtures.size(), derived.size()));
        for (std::size_t i = 0; i < derived.size(); ++i) {
            const std::string place = fmt::format("{} fixture {}", setup_.id, derived[i].name);
            length(place, "the bottom", setup_.fixtures[i].bottom_z_mm, derived[i].bottom_z_mm);
            length(place, "the top", setup_.fixtures[i].top_z_mm, derived[i].top_z_mm);
            if (setup_.fixtures[i].kind != derived[i].kind)
                fail(place, "is a " + toString(setup_.fixtures[i].kind));
            region(place, "the section", setup_.fixtures[i].section, derived[i].section);
        }
    }

    void compareFeature(const Feature& recorded, const Feature& derived) {
        length(derived.id, "the top", recorded.top_z_mm, derived.top_z_mm);
        length(derived.id, "the floor", recorded.floor_z_mm, derived.floor_z_mm);
        region(derived.id, "the target", recorded.target, derived.target);
        region(derived.id, "the obstruction", recorded.obstruction, derived.obstruction);
        if (recorded.parents != derived.parents)
            fail(derived.id, "waits for other features than the part says");
        length(derived.id, "the drill's point under the floor", recorded.point_mm, derived.point_mm);
        length(derived.id, "the room below the floor", recorded.room_below_mm.value_or(0),
               derived.room_below_mm.value_or(0));
        if (recorded.feature_class != derived.feature_class)
            fail(derived.id, fmt::format("is a {}, not a {}", toString(derived.feature_class),
                                         toString(recorded.feature_class)));
        compareObstacles(recorded, derived);
    }

    void compareObstacles(const Feature& recorded, const Feature& derived) {
        if (recorded.obstacles.size() != derived.obstacles.size())
            return fail(derived.id, fmt::format("{} obstacles, expected {}", recorded.obstacles.size(),
                                                derived.obstacles.size()));
        for (std::size_t i = 0; i < derived.obstacles.size(); ++i) {
            length(derived.id, "an obstacle's bottom", recorded.obstacles[i].bottom_z_mm,
                   derived.obstacles[i].bottom_z_mm);
            length(derived.id, "an obstacle's top", recorded.obstacles[i].top_z_mm,
                   derived.obstacles[i].top_z_mm);
            region(derived.id, "an obstacle", recorded.obstacles[i].section, derived.obstacles[i].section);
        }
    }

    const PlanRecord& record_;
    const RecordedSetup& setup_;
    const Tolerances& tol_;
    std::vector<ProofFailure>& failures_;
};

SetupRequest setupRequest(const PlanRecord& record, const ClaimSources& sources) {
    SetupRequest request;
    for (const RecordedSetup& setup : record.setups)
        request.axes.push_back(setup.axis.normalized());
    request.margin = record.request->margin;
    request.stock_sizes_mm = record.request->stock_sizes_mm;
    request.stock_tolerance_mm = record.stock.tolerance_mm;
    request.stock_part = sources.stock;
    return request;
}

/// What the planner took of the library.
ToolLibrary usedLibrary(const PlanRecord& record, const ToolLibrary& library,
                        const std::vector<Setup>& setups) {
    SequenceOptions options;
    options.material = record.material;
    options.finish = record.request->finish;
    return usableLibrary(library, options, record.machine, tallestStockMm(setups)).library;
}

/// A setup as derived, for the books.
struct DerivedSetup {
    PlannedSetup planned;
    LayerStack layers;
    StageAir air;
    std::vector<Prism> removed;
    StockStep stock;
};

/// Derives setup after setup on the stock that the record's operations leave.
class ClaimWalk {
  public:
    ClaimWalk(const PlanRecord& record, const ClaimSources& sources, const Tolerances& tol,
              std::vector<ProofFailure>& failures)
        : record_(record),
          sources_(sources),
          tol_(tol),
          failures_(failures),
          wishes_(sources.holes, sources.part, tol) {}

    void run() {
        compareShop();
        if (!failures_.empty()) return;
        const std::vector<Setup> setups = chooseSetups(sources_.part, setupRequest(record_, sources_));
        library_ = usedLibrary(record_, sources_.library, setups);
        SetupWalk walk(setups, SliceOptions{}, tol_, reserves(setups));
        while (std::optional<Stage> stage = walk.next()) {
            derive(std::move(*stage), walk);
            if (!failures_.empty()) return;
        }
        compareBooks(setups.front().stock.volume_mm3 - sources_.part.volume_mm3);
        if (threads_missing_ != record_.threads_missing)
            failures_.push_back({"plan.json", 0, "threads missing",
                                 fmt::format("{}, by part and hole table {} holes have none",
                                             record_.threads_missing, threads_missing_)});
    }

  private:
    /// What is left for later setups is up to the plan: the books say whether they take it. Their frames turn
    /// as the setups do: in the record slanted axes are rounded.
    std::vector<CutPrisms> reserves(const std::vector<Setup>& setups) const {
        std::vector<CutPrisms> reserves;
        for (std::size_t i = 0; i < std::min(setups.size(), record_.setups.size()); ++i) {
            Eigen::Isometry3d frame = setups[i].part_to_setup;
            frame.translation() = record_.setups[i].part_to_setup.translation();
            reserves.push_back({frame, record_.setups[i].reserve});
        }
        return reserves;
    }

    /// The vise and the plate are the shop's.
    void compareShop() {
        const Vise& recorded = *record_.request->vise;
        const Vise& shop = sources_.fixtures.vise;
        const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
            return std::equal(a.begin(), a.end(), b.begin(), b.end(), sameLength);
        };
        const bool alike = same({recorded.opening_mm, recorded.jaw_width_mm, recorded.jaw_height_mm,
                                 recorded.jaw_thickness_mm, recorded.grip_mm, recorded.jaw_clearance_mm},
                                {shop.opening_mm, shop.jaw_width_mm, shop.jaw_height_mm,
                                 shop.jaw_thickness_mm, shop.grip_mm, shop.jaw_clearance_mm}) &&
                           same(recorded.parallels_mm, shop.parallels_mm);
        if (!alike) failures_.push_back({"plan.json", 0, "request", "the vise is not the shop's"});
        if (!sameLength(record_.request->plate_mm, sources_.fixtures.plate_mm))
            failures_.push_back({"plan.json", 0, "request", "the plate is not as thick as the shop's"});
    }

    /// One setup, if it is as the record says.
    void derive(Stage stage, SetupWalk& walk) {
        const RecordedSetup& recorded = record_.setups[derived_.size()];
        holdStage(stage, sources_.fixtures,
                  {record_.request->hold, record_.request->break_edges_mm,
                   fixtureGrowthMm(sources_.fixtures, sources_.library)},
                  tol_);
        if (const auto& leaves = record_.request->roughing)
            stage.found = withAllowance(std::move(stage.found), *leaves, library_, record_.material, tol_);
        stage.found = renamed(std::move(stage.found), recorded.names);
        const std::vector<Feature> features =
            besideGrounds(inBands(stage.found.features, library_, record_.material), recorded);
        if (!failures_.empty()) return;
        SetupComparison(record_, recorded, tol_, failures_).compare(stage, features);
        if (!failures_.empty()) return;
        DerivedSetup& derived = derived_.emplace_back();
        std::vector<PlannedFeature> planned;
        for (const Feature& feature : features) {
            planned.push_back(asPlanned(record_, feature, false));
            derived.planned.features.push_back(asPlanned(record_, feature, true));
        }
        for (const PlannedFeature& feature : derived.planned.features)
            threads_missing_ +=
                verify::compareHole(record_, wishes_, {feature, stage.setup}, tol_, failures_);
        derived.removed = removedBy(planned, tol_);
        derived.stock = walk.cut(stage, derived.removed);
        derived.air = airOf(stage);
        for (const std::string& id : recorded.operation_ids)
            if (!record_.operations.at(id).takes.empty()) {
                derived.planned.operations.emplace_back();
                derived.planned.operations.back().takes = record_.operations.at(id).takes;
            }
        compareForms(stage, recorded.id, derived.planned);
        derived.planned.setup = stage.setup;
        derived.planned.unplanned = stage.found.unplanned;
        derived.layers = std::move(stage.layers);
    }

    void compareForms(const Stage& stage, const std::string& setup_id, PlannedSetup& derived) {
        const auto form = record_.forms.find(formGroundId(setup_id));
        if (form != record_.forms.end()) {
            verify::compareForm(form->second, nullptr, stage.setup, stage.layers, tol_, failures_);
            derived.form = form->second;
        }
        const auto edges = record_.forms.find(edgeGroundId(setup_id));
        if (edges == record_.forms.end()) return;
        const double width_mm = record_.request->break_edges_mm;
        if (width_mm <= 0 || !sameLength(edges->second.edges_mm, width_mm)) {
            failures_.push_back(
                {"plan.json", 0, edges->first, "breaks edges by another width than was asked for"});
            return;
        }
        const EdgeBreaks breaks(stage.layers, width_mm, tol_);
        verify::compareForm(edges->second, &breaks, stage.setup, stage.layers, tol_, failures_);
    }

    /// The features with the grounds that the record takes out of them: which ground is up to the plan, as
    /// long as all its levels have it.
    std::vector<Feature> besideGrounds(std::vector<Feature> features, const RecordedSetup& recorded) {
        for (const std::string& id : recorded.feature_ids) {
            const Feature& feature = record_.features.at(id).feature;
            if (feature.ground_of.empty()) continue;
            const CommonGround ground{id, feature.ground_of, feature.target, feature.floor_z_mm};
            if (isCommonGround(features, ground, tol_)) {
                features = withCommonGround(std::move(features), ground, tol_);
                continue;
            }
            failures_.push_back({"plan.json", 0, id, "is no ground that its levels share"});
            break;
        }
        return features;
    }

    /// What the plan says of the whole follows from its features and what stays of them.
    void compareBooks(double stock_minus_part_mm3) {
        std::vector<SetupAccount> accounts;
        for (const DerivedSetup& derived : derived_)
            accounts.push_back(
                {&derived.planned, &derived.layers, derived.stock, derived.air, derived.removed});
        const VolumeBalance books = booksOf(accounts, stock_minus_part_mm3, tol_).part;
        const double rounding_mm3 = std::max(kVolumeRoundingMm3, tol_.volume_share * stock_minus_part_mm3);
        const auto compare = [&](const char* what, double recorded, double derived) {
            if (std::abs(recorded - derived) > rounding_mm3)
                failures_.push_back({"plan.json", 0, "volume balance",
                                     fmt::format("{} is {:.3f} mm3, by features and residuals {:.3f}", what,
                                                 recorded, derived)});
        };
        compare("stock minus part", record_.books.stock_minus_part_mm3, stock_minus_part_mm3);
        compare("planned", record_.books.planned_mm3, books.planned_mm3);
        compare("what stays", record_.books.residual_mm3, books.residual_mm3);
        compare("what no setup reaches", record_.books.unreachable_mm3, books.unreachable_mm3);
    }

    const PlanRecord& record_;
    const ClaimSources& sources_;
    const Tolerances& tol_;
    std::vector<ProofFailure>& failures_;
    HoleWishes wishes_;
    int threads_missing_ = 0;
    ToolLibrary library_;
    std::deque<DerivedSetup> derived_;
};

}  // namespace

std::vector<ProofFailure> compareWithPart(const PlanRecord& record, const ClaimSources& sources,
                                          const Tolerances& tol) {
    if (!record.request)
        throw Error(ErrorCode::InvalidCatalog, "plan.json#/request",
                    "expected what was asked for; without it nothing can be derived from the part");
    if (!record.request->vise)
        throw Error(ErrorCode::InvalidCatalog, "plan.json#/request",
                    "expected the shop's vise; the plan was made by an older version: plan it again");
    std::vector<ProofFailure> failures;
    if (!sameVolume(record.part_volume_mm3, sources.part.volume_mm3))
        failures.push_back({"plan.json", 0, "part",
                            fmt::format("its volume is {:.6f}, by the file {:.6f}", record.part_volume_mm3,
                                        sources.part.volume_mm3)});
    if (failures.empty()) ClaimWalk(record, sources, tol, failures).run();
    return failures;
}

}  // namespace stepmill
