#include "stepmill/feature/face_owner.h"

#include <algorithm>
#include <map>

namespace stepmill {
namespace {

/// Samples are looked at this far in front of their face [mm]: clear of rounding and of slivers, nearer than
/// any wall.
constexpr double kInFrontMm = 0.01;
/// A normal that rises by less belongs to a wall.
constexpr double kLevelNormal = 1e-6;
/// A face lies on the stock when so many of its samples do: its neighbour's edge may take a few.
constexpr double kNearlyAll = 0.9;

/// The features' volumes, to be asked for points.
class Volumes {
  public:
    explicit Volumes(const std::vector<Feature>& features) : features_(features) {
        for (const Feature& feature : features)
            boxes_.push_back(boundingBox(feature.target));
    }

    /// The feature that holds the point, or -1.
    int at(const Vec3& p) const {
        for (std::size_t i = 0; i < features_.size(); ++i)
            if (p.z() > features_[i].floor_z_mm && p.z() < features_[i].top_z_mm && over(i, p))
                return static_cast<int>(i);
        return -1;
    }

    /// The lowest feature straight above the point, or -1.
    int above(const Vec3& p) const {
        int best = -1;
        for (std::size_t i = 0; i < features_.size(); ++i) {
            if (features_[i].top_z_mm <= p.z() || !over(i, p)) continue;
            if (best < 0 || features_[i].floor_z_mm < features_[best].floor_z_mm) best = static_cast<int>(i);
        }
        return best;
    }

  private:
    bool over(std::size_t i, const Vec3& p) const {
        const Box2& box = boxes_[i];
        return p.x() >= box.min().x() && p.x() <= box.max().x() && p.y() >= box.min().y() &&
               p.y() <= box.max().y() && contains(features_[i].target, p.head<2>());
    }
    const std::vector<Feature>& features_;
    std::vector<Box2> boxes_;
};

/// Is the part between the point and that height straight above it? Slabs whose walls lean do not tell: there
/// the part is a hull.
bool isPartBetween(const LayerStack& layers, const Vec3& from, double to_z_mm) {
    return std::any_of(layers.layers.begin(), layers.layers.end(), [&](const Layer& layer) {
        return layer.vertical_walls && layer.bottom_z_mm >= from.z() && layer.top_z_mm <= to_z_mm &&
               contains(layer.part, from.head<2>());
    });
}

struct Votes {
    int direct = 0;
    int leaning = 0;
};

}  // namespace

std::vector<FaceShare> assignFaces(const FaceGraph& graph, const Eigen::Isometry3d& part_to_setup,
                                   const LayerStack& layers, FeatureSet& found) {
    const Volumes volumes(found.features);
    std::vector<FaceShare> shares;
    for (const FaceShape& face : graph.faces) {
        std::map<int, Votes> votes;
        for (const FaceSample& sample : face.samples) {
            const Vec3 normal = part_to_setup.linear() * sample.normal;
            const Vec3 front = part_to_setup * sample.at + kInFrontMm * normal;
            if (const int feature = volumes.at(front); feature >= 0) {
                ++votes[feature].direct;
            } else if (normal.z() > kLevelNormal) {
                const int above = volumes.above(front);
                if (above >= 0 && !isPartBetween(layers, front, found.features[above].floor_z_mm))
                    ++votes[above].leaning;
            }
        }
        for (const auto& [feature, count] : votes) {
            found.features[feature].faces.push_back(face.index);
            shares.push_back(
                {face.index, feature,
                 static_cast<double>(count.direct + count.leaning) / static_cast<double>(face.samples.size()),
                 count.direct < count.leaning});
        }
    }
    return shares;
}

std::vector<bool> facesOnStock(const FaceGraph& graph, const Eigen::Isometry3d& part_to_setup,
                               const LayerStack& layers) {
    const auto outside = [&](const Vec3& p) {
        return std::none_of(layers.layers.begin(), layers.layers.end(), [&](const Layer& layer) {
            return p.z() < layer.top_z_mm && p.z() >= layer.bottom_z_mm && contains(layer.stock, p.head<2>());
        });
    };
    std::vector<bool> on_stock;
    for (const FaceShape& face : graph.faces) {
        const auto count =
            std::count_if(face.samples.begin(), face.samples.end(), [&](const FaceSample& sample) {
                return outside(part_to_setup * sample.at +
                               kInFrontMm * (part_to_setup.linear() * sample.normal));
            });
        on_stock.push_back(!face.samples.empty() &&
                           static_cast<double>(count) >=
                               kNearlyAll * static_cast<double>(face.samples.size()));
    }
    return on_stock;
}

}  // namespace stepmill
