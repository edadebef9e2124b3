// From a part to what it takes to mill it.

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/feature/face_owner.h"
#include "stepmill/plan/hold_stage.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/stages.h"
#include "stepmill/study/inspection.h"

namespace stepmill {

namespace {

constexpr const char* kOnStock = "stock";
constexpr const char* kNotMachined = "not machined";

/// A face's best owner so far.
struct Owner {
    std::string feature;
    std::string feature_class;
    double share = 0;
};

class Inspector {
  public:
    Inspector(Inspection& inspection, const InspectRequest& request, const Tolerances& tol)
        : inspection_(inspection),
          request_(request),
          tol_(tol),
          graph_(faceGraph(inspection.part, tol)),
          owners_(graph_.faces.size()) {}

    std::vector<Prism> visit(const Stage& stage) {
        FeatureSet found = stage.found;
        const Eigen::Isometry3d& frame = stage.setup.part_to_setup;
        if (inspection_.setups.empty()) on_stock_ = facesOnStock(graph_, frame, stage.layers);
        nameEngravings(found, request_.smallest_cutter_mm, tol_);
        for (const FaceShare& share : assignFaces(graph_, frame, stage.layers, found))
            remember(share, found.features[share.feature]);
        for (const std::string& remark : stage.layers.remarks)
            inspection_.warnings.push_back(stage.setup.id + ": " + remark);
        InspectedSetup inspected{stage.setup, clampingOf(stage, {}, {}, tol_), {}, found.unplanned, {}, 0};
        inspected.features.resize(found.features.size());
        std::vector<std::string> failures(found.features.size());
        parallelFor(found.features.size(), [&](std::size_t i) {
            inspected.features[i].feature = found.features[i];
            try {
                inspected.features[i].measures =
                    measureFeature(found.features[i], stage.layers, graph_, frame, tol_);
            } catch (const Error& error) {
                failures[i] = error.what();
            }
        });
        for (std::size_t i = 0; i < failures.size(); ++i)
            if (!failures[i].empty())
                inspection_.warnings.push_back(found.features[i].id + ": not measured: " + failures[i]);
        inspection_.setups.push_back(std::move(inspected));
        airs_.push_back(airOf(stage));
        return featurePrisms(found);
    }

    /// Of every stage visited.
    const std::vector<StageAir>& airs() const { return airs_; }

    void finish() {
        inspection_.forms = partForms(graph_, on_stock_, tol_);
        inspection_.holes = findHoles(graph_, tol_);
        nameHoles();
        nameFaces();
    }

  private:
    void remember(const FaceShare& share, const Feature& feature) {
        Owner& owner = owners_[share.face];
        if (share.share > owner.share) owner = {feature.id, toString(feature.feature_class), share.share};
    }

    /// A feature is a step of the hole whose walls it makes.
    void nameHoles() {
        for (InspectedSetup& setup : inspection_.setups)
            for (InspectedFeature& inspected : setup.features) {
                const FeatureClass feature_class = inspected.feature.feature_class;
                if (!isHole(feature_class)) continue;
                for (const Hole& hole : inspection_.holes)
                    if (std::any_of(hole.faces.begin(), hole.faces.end(), [&](int face) {
                            return std::binary_search(inspected.feature.faces.begin(),
                                                      inspected.feature.faces.end(), face);
                        }))
                        inspected.holes.push_back(hole.id);
            }
    }

    void nameFaces() {
        std::vector<const PartForm*> form_of(graph_.faces.size(), nullptr);
        for (const PartForm& form : inspection_.forms)
            for (const int face : form.faces)
                form_of[face] = &form;
        std::vector<const Hole*> hole_of(graph_.faces.size(), nullptr);
        for (const Hole& hole : inspection_.holes)
            for (const int face : hole.faces)
                hole_of[face] = &hole;
        for (const PartFace& face : inspection_.part.faces) {
            FaceRow row{face.index, face.step_name, owners_[face.index].feature, {}, {}, {}};
            const PartForm* form = form_of[face.index];
            if (form != nullptr) row.form = form->id;
            row.face_class = classOf(face.index, form, hole_of[face.index]);
            row.mfcad_class = on_stock_[face.index] ? std::optional<std::string>(kOnStock)
                              : form != nullptr     ? mfcadClass(*form)
                                                    : std::nullopt;
            inspection_.faces.push_back(std::move(row));
        }
    }

    std::string classOf(int face, const PartForm* form, const Hole* hole) const {
        if (on_stock_[face]) return kOnStock;
        if (hole != nullptr) return holeName(*hole);
        if (form != nullptr) {
            switch (form->form_class) {
                case FormClass::Chamfer:
                case FormClass::EdgeFillet:
                case FormClass::InnerFillet:
                case FormClass::FreeForm:
                    return toString(form->form_class);
                default:
                    break;
            }
        }
        const Owner& owner = owners_[face];
        return owner.feature.empty() ? kNotMachined : owner.feature_class;
    }

    Inspection& inspection_;
    const InspectRequest& request_;
    const Tolerances& tol_;
    FaceGraph graph_;
    std::vector<Owner> owners_;
    std::vector<bool> on_stock_;
    std::vector<StageAir> airs_;
};

/// Takes a volume off all entries, in proportion.
void lessen(std::vector<Unplanned>& unplanned, double by_mm3) {
    double sum_mm3 = 0;
    for (const Unplanned& entry : unplanned)
        sum_mm3 += entry.volume_mm3;
    if (sum_mm3 <= 0) return;
    const double keep = std::max(0.0, 1 - by_mm3 / sum_mm3);
    for (Unplanned& entry : unplanned)
        entry.volume_mm3 *= keep;
}

/// What the last setup's stock still has over the part, by reason.
void closeBooks(Inspection& inspection, const std::vector<StageAir>& airs) {
    InspectedBooks& books = inspection.books;
    books.stock_minus_part_mm3 = inspection.stock.volume_mm3 - inspection.part.volume_mm3;
    for (std::size_t i = 0; i < inspection.setups.size(); ++i) {
        InspectedSetup& setup = inspection.setups[i];
        const SettledAir air = settleAir(airs.at(i), setup.stock.prisms_mm3, setup.stock.removed_mm3);
        lessen(setup.unplanned, air.left_mm3);
        if (air.back_mm3 > 0)
            setup.unplanned.push_back(
                {{Reason::LeaningWall, {}}, air.back_mm3, 0, setup.setup.stock_bbox_mm.min().z(), {}});
        // What the features took of the stock itself: where an earlier setup left the stock's walls leaning
        // their prisms hold air too.
        books.features_mm3 += setup.stock.removed_mm3;
        setup.gap_mm3 = setup.stock.arrives_mm3 - inspection.part.volume_mm3 - setup.stock.removed_mm3;
        for (const Unplanned& unplanned : setup.unplanned)
            setup.gap_mm3 -= unplanned.volume_mm3;
    }
    for (const Unplanned& unplanned : inspection.setups.back().unplanned) {
        const auto known = std::find_if(books.left.begin(), books.left.end(), [&](const ReasonVolume& left) {
            return left.reason == unplanned.reason;
        });
        if (known == books.left.end())
            books.left.push_back({unplanned.reason, unplanned.volume_mm3});
        else
            known->volume_mm3 += unplanned.volume_mm3;
    }
}

}  // namespace

double InspectedBooks::gapShare() const {
    if (stock_minus_part_mm3 <= kVolumeRoundingMm3) return 0;
    double gap = stock_minus_part_mm3 - features_mm3;
    for (const ReasonVolume& entry : left)
        gap -= entry.volume_mm3;
    return std::abs(gap) / stock_minus_part_mm3;
}

Inspection inspectPart(const Part& part, const InspectRequest& request, const Tolerances& tol,
                       const std::function<void(const std::string& stage, double share)>& progress) {
    const auto report = [&](const std::string& stage, double share) {
        if (progress) progress(stage, share);
    };
    Inspection inspection;
    inspection.part = part;
    for (const Remark& remark : part.remarks)
        if (remark.code != "part") inspection.warnings.push_back(part.file + ": " + remark.text);
    report("faces of " + part.name, 0);
    Inspector inspector(inspection, request, tol);
    report("setups", 0.1);
    const std::vector<Setup> setups = chooseSetups(part, request.setup);
    STEPMILL_CHECK(!setups.empty(), "a part has at least one setup");
    inspection.stock = setups.front().stock;
    SetupWalk walk(setups, request.slicing, tol);
    while (const std::optional<Stage> stage = walk.next()) {
        report("features of " + stage->setup.id, 0.5);
        const std::vector<Prism> removed = inspector.visit(*stage);
        inspection.setups.back().stock = walk.cut(*stage, removed);
    }
    inspector.finish();
    closeBooks(inspection, inspector.airs());
    return inspection;
}

}  // namespace stepmill
