// How much of the removable volume a tool sees from one direction.

#include "setup/reach.h"

namespace stepmill::setup {

namespace {

constexpr int kColumns = 256;

/// Lowest and highest surface over a grid of columns; NaN-free: low > high where there is none.
struct HeightMap {
    std::vector<double> low = std::vector<double>(kColumns * kColumns, 1e300);
    std::vector<double> high = std::vector<double>(kColumns * kColumns, -1e300);
};

/// Facets into columns, each column at its middle.
HeightMap heightMap(const Facets& facets, const Eigen::Matrix3d& rotation, const Box3& box) {
    HeightMap map;
    const Vec3 size = box.sizes();
    for (const auto& facet : facets) {
        std::array<Vec3, 3> p;
        for (int k = 0; k < 3; ++k) {
            p[k] = rotation * facet[k] - box.min();
            p[k].x() *= kColumns / size.x();
            p[k].y() *= kColumns / size.y();
        }
        const Vec3 u = p[1] - p[0];
        const Vec3 v = p[2] - p[0];
        const double det = u.x() * v.y() - u.y() * v.x();
        if (std::abs(det) < 1e-12) continue;
        const auto range = [&](int axis) {
            const double from = std::min({p[0][axis], p[1][axis], p[2][axis]});
            const double to = std::max({p[0][axis], p[1][axis], p[2][axis]});
            return std::pair<int, int>(std::max(0, static_cast<int>(std::ceil(from - 0.5))),
                                       std::min(kColumns - 1, static_cast<int>(std::floor(to - 0.5))));
        };
        const auto [x0, x1] = range(0);
        const auto [y0, y1] = range(1);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const double dx = x + 0.5 - p[0].x();
                const double dy = y + 0.5 - p[0].y();
                const double s = (dx * v.y() - dy * v.x()) / det;
                const double t = (u.x() * dy - u.y() * dx) / det;
                if (s < -1e-9 || t < -1e-9 || s + t > 1 + 1e-9) continue;
                const double z = p[0].z() + s * u.z() + t * v.z();
                double& low = map.low[y * kColumns + x];
                double& high = map.high[y * kColumns + x];
                low = std::min(low, z);
                high = std::max(high, z);
            }
    }
    return map;
}

}  // namespace

double reachableShare(const Facets& part, const Facets& stock, const Eigen::Matrix3d& rotation,
                      const Box3& turned_stock, double removable_mm3) {
    if (removable_mm3 <= 0) return 0;
    const HeightMap part_map = heightMap(part, rotation, turned_stock);
    const bool box = stock.empty();
    const HeightMap stock_map = box ? HeightMap{} : heightMap(stock, rotation, turned_stock);
    double heights = 0;
    for (int i = 0; i < kColumns * kColumns; ++i) {
        const double top = box ? turned_stock.sizes().z() : stock_map.high[i];
        const double bottom = std::max(box ? 0 : stock_map.low[i], part_map.high[i]);
        heights += std::max(0.0, top - bottom);
    }
    const Vec3 size = turned_stock.sizes();
    const double reachable = heights * size.x() * size.y() / (kColumns * kColumns);
    return std::clamp(reachable / removable_mm3, 0.0, 1.0);
}

}  // namespace stepmill::setup
