// Features of a part that was revised, by the names they had before.

#include "stepmill/plan/earlier_plan.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "plan/id_number.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Sizes agree to this share: a hole that moved has the area it had, but for rounding.
constexpr double kSameSize = 1e-4;

/// One of `found`, all its bands together.
struct WholeGround {
    std::string number;  ///< the id by it
    FeatureClass feature_class = FeatureClass::ClosedPocket;
    double top_z_mm = 0;
    double floor_z_mm = 0;
    Region target;
};

std::vector<WholeGround> wholeGrounds(const FeatureSet& found) {
    std::vector<WholeGround> wholes;
    std::map<std::string, std::size_t> place;
    for (const Feature& band : found.features) {
        const auto [known, is_new] = place.emplace(wholeOf(band), wholes.size());
        if (is_new)
            wholes.push_back(
                {wholeOf(band), band.feature_class, band.top_z_mm, band.floor_z_mm, band.target});
        wholes[known->second].floor_z_mm = band.floor_z_mm;
    }
    return wholes;
}

bool sameHeights(const WholeGround& one, const EarlierFeature& other, const Tolerances& tol) {
    return std::abs(one.top_z_mm - other.top_z_mm) <= tol.linear_mm &&
           std::abs(one.floor_z_mm - other.floor_z_mm) <= tol.linear_mm;
}

double commonDepthMm(const WholeGround& one, const EarlierFeature& other) {
    return std::min(one.top_z_mm, other.top_z_mm) - std::max(one.floor_z_mm, other.floor_z_mm);
}

/// What both have of each other's ground, 1 where it is the same; 0 where they are not alike at all.
double likeness(const WholeGround& one, const EarlierFeature& other, const Tolerances& tol) {
    if (other.target.empty() || commonDepthMm(one, other) <= 0) return 0;
    if (!boundingBox(one.target).intersects(boundingBox(other.target))) return 0;
    const double both_mm2 = area(one.target) + area(other.target);
    const double shared = 2 * area(intersect(one.target, other.target, tol)) / both_mm2;
    const double depth =
        2 * commonDepthMm(one, other) / (one.top_z_mm - one.floor_z_mm + other.top_z_mm - other.floor_z_mm);
    constexpr double kOtherKind = 0.25;
    return shared * depth * (one.feature_class == other.feature_class ? 1 : kOtherKind);
}

/// The same at another place: 1 / (1 + way in mm), so that the nearest is taken.
double movedLikeness(const WholeGround& one, const EarlierFeature& other, const Tolerances& tol) {
    if (other.target.empty() || one.feature_class != other.feature_class) return 0;
    const double area_mm2 = area(other.target);
    if (!sameHeights(one, other, tol) || std::abs(area(one.target) - area_mm2) > kSameSize * area_mm2)
        return 0;
    return 1 / (1 + (boundingBox(one.target).center() - boundingBox(other.target).center()).norm());
}

/// Finds for each feature the earlier one it is, the surest first.
class NameSearch {
  public:
    NameSearch(const EarlierSetup& earlier, const FeatureSet& found, const Tolerances& tol)
        : earlier_(earlier),
          wholes_(wholeGrounds(found)),
          tol_(tol),
          names_(wholes_.size()),
          taken_(earlier.features.size(), false) {}

    FeatureNames names() {
        takeTheSame();
        takeBest(likeness);
        takeBest(movedLikeness);
        takeByNumber();
        nameTheRest();
        FeatureNames names;
        for (std::size_t i = 0; i < wholes_.size(); ++i)
            if (*names_[i] != wholes_[i].number) names[wholes_[i].number] = *names_[i];
        return names;
    }

  private:
    using Likeness = double (*)(const WholeGround&, const EarlierFeature&, const Tolerances&);

    void take(std::size_t whole, std::size_t earlier) {
        names_[whole] = earlier_.features[earlier].id;
        taken_[earlier] = true;
    }

    void takeTheSame() {
        for (std::size_t i = 0; i < wholes_.size(); ++i)
            for (std::size_t k = 0; k < taken_.size() && !names_[i]; ++k)
                if (!taken_[k] && sameHeights(wholes_[i], earlier_.features[k], tol_) &&
                    feature::sameRegion(wholes_[i].target, earlier_.features[k].target, tol_))
                    take(i, k);
    }

    void takeBest(Likeness likeness_of) {
        struct Pair {
            double likeness = 0;
            std::size_t whole = 0;
            std::size_t earlier = 0;
        };
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < wholes_.size(); ++i)
            for (std::size_t k = 0; k < taken_.size(); ++k)
                if (!names_[i] && !taken_[k])
                    if (const double like = likeness_of(wholes_[i], earlier_.features[k], tol_); like > 0)
                        pairs.push_back({like, i, k});
        std::stable_sort(pairs.begin(), pairs.end(),
                         [](const Pair& a, const Pair& b) { return a.likeness > b.likeness; });
        for (const Pair& pair : pairs)
            if (!names_[pair.whole] && !taken_[pair.earlier]) take(pair.whole, pair.earlier);
    }

    /// Of those that are known by name alone.
    void takeByNumber() {
        for (std::size_t i = 0; i < wholes_.size(); ++i)
            for (std::size_t k = 0; k < taken_.size() && !names_[i]; ++k)
                if (!taken_[k] && earlier_.features[k].target.empty() &&
                    earlier_.features[k].id == wholes_[i].number)
                    take(i, k);
    }

    void nameTheRest() {
        int last = 0;
        for (const EarlierFeature& feature : earlier_.features)
            last = std::max(last, numberOfId(feature.id));
        for (std::optional<std::string>& name : names_)
            if (!name) name = fmt::format("{}.F{}", earlier_.id, ++last);
    }

    const EarlierSetup& earlier_;
    std::vector<WholeGround> wholes_;
    Tolerances tol_;
    std::vector<std::optional<std::string>> names_;
    std::vector<bool> taken_;
};

/// The band's id with its feature's name.
/// \param whole  the feature's id by its number
std::string renamedId(const std::string& id, const std::string& whole, const FeatureNames& names) {
    const auto name = names.find(whole);
    return name == names.end() ? id : name->second + id.substr(whole.size());
}

}  // namespace

const EarlierSetup* earlierOf(const Setup& setup, const std::vector<EarlierSetup>& earlier) {
    for (const EarlierSetup& one : earlier)
        if (one.id == setup.id && isSameAxis(one.axis, setup.axis)) return &one;
    return nullptr;
}

FeatureNames namesFrom(const EarlierSetup& earlier, const FeatureSet& found, const Tolerances& tol) {
    return NameSearch(earlier, found, tol).names();
}

FeatureSet renamed(FeatureSet found, const FeatureNames& names) {
    if (names.empty()) return found;
    std::map<std::string, std::string> ids;
    for (const Feature& band : found.features)
        ids[band.id] = renamedId(band.id, wholeOf(band), names);
    for (Feature& band : found.features) {
        for (std::string& parent : band.parents)
            parent = ids.at(parent);
        if (band.band) band.band->of = renamedId(band.band->of, band.band->of, names);
        band.id = ids.at(band.id);
    }
    return found;
}

}  // namespace stepmill
