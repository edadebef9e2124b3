#include "stepmill/plan/hole_wishes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plan/plan_warnings.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/part/face_graph.h"

namespace stepmill {
namespace {

/// An axis this near to a hole's is that hole's [mm]: what slicing and rounding leave of equality.
constexpr double kSameAxisMm = 0.01;
/// Bores that differ less are one [mm].
constexpr double kSameBoreMm = 0.01;
/// Cosine of the angle up to which two axes are parallel.
constexpr double kParallel = 1 - 1e-9;

bool namesHoles(const HoleTable& table) {
    return std::any_of(table.entries.begin(), table.entries.end(), [](const HoleEntry& entry) {
        return std::any_of(entry.ids.begin(), entry.ids.end(),
                           [](const std::string& id) { return id.front() == 'H'; });
    });
}

/// Is the feature's hole at that place the narrowest bore of the part's hole?
bool isBoreOf(const Hole& hole, const Feature& feature, const Vec2& place, const Setup& setup) {
    const Vec3 axis = setup.part_to_setup.linear() * hole.axis;
    const Vec3 entry = setup.part_to_setup * hole.entry;
    return std::abs(axis.z()) >= kParallel && (Vec2(entry.head<2>()) - place).norm() <= kSameAxisMm &&
           std::abs(hole.diameter_mm() - 2 * holeRadiusMm(feature)) <= kSameBoreMm;
}

}  // namespace

HoleWishes::HoleWishes(const HoleTable& table, const Part& part, const Tolerances& tol) : table_(table) {
    if (namesHoles(table)) holes_ = findHoles(faceGraph(part, tol), tol);
}

bool HoleWishes::names(const HoleEntry& entry, const Feature& feature, const Vec2& place,
                       const Setup& setup) const {
    return std::any_of(entry.ids.begin(), entry.ids.end(), [&](const std::string& id) {
        if (id.front() != 'H') return id == wholeOf(feature);
        return std::any_of(holes_.begin(), holes_.end(), [&](const Hole& hole) {
            return hole.id == id && isBoreOf(hole, feature, place, setup);
        });
    });
}

bool HoleWishes::chooses(const HoleEntry& entry, const Feature& feature, const Vec2& place,
                         const Setup& setup) const {
    if (entry.diameter && !entry.diameter->holds(2 * holeRadiusMm(feature))) return false;
    if (entry.depth && !entry.depth->holds(feature.depth_mm())) return false;
    return entry.ids.empty() || names(entry, feature, place, setup);
}

std::vector<HoleWish> HoleWishes::of(const Feature& feature, const Setup& setup) const {
    std::vector<HoleWish> wishes;
    if (table_.entries.empty() || !isHole(feature.feature_class) || feature.target.empty()) return wishes;
    std::vector<Vec2> left = holeCentres(feature);
    const std::size_t all = left.size();
    for (const HoleEntry& entry : table_.entries) {
        HoleWish wish{&entry, {}, false};
        std::vector<Vec2> others;
        for (const Vec2& place : left)
            (chooses(entry, feature, place, setup) ? wish.places : others).push_back(place);
        left = std::move(others);
        wish.whole = wish.places.size() == all;
        if (!wish.places.empty()) wishes.push_back(std::move(wish));
    }
    return wishes;
}

const HoleEntry* HoleWishes::entryOf(const Feature& feature, const Setup& setup) const {
    const std::vector<HoleWish> wishes = of(feature, setup);
    return wishes.size() == 1 && wishes.front().whole ? wishes.front().entry : nullptr;
}

std::vector<Warning> HoleWishes::unused(const std::vector<PlannedSetup>& setups) const {
    std::map<const HoleEntry*, std::vector<Warning>> of_entry;  // of those that choose something
    for (const PlannedSetup& setup : setups)
        for (const PlannedFeature& planned : setup.features)
            for (const HoleWish& wish : of(planned.feature, setup.setup)) {
                std::vector<Warning>& warnings = of_entry[wish.entry];
                if (wish.whole || wish.entry->make == HoleMaking::Tap) continue;
                warnings.push_back({"hole-table", planned.feature.id,
                                    fmt::format("{}{} chooses {} of {} equal holes, which are made alike: "
                                                "it is not heeded there",
                                                table_.file, wish.entry->pointer, wish.places.size(),
                                                holeCentres(planned.feature).size())});
            }
    std::vector<Warning> warnings;
    for (const HoleEntry& entry : table_.entries) {
        const auto found = of_entry.find(&entry);
        if (found != of_entry.end())
            append(warnings, found->second);
        else
            warnings.push_back({"hole-table", table_.file + entry.pointer,
                                fmt::format("{}{} chooses no hole of the part", table_.file, entry.pointer)});
    }
    return warnings;
}

}  // namespace stepmill
