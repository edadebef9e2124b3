#include "support/plan_json.h"

#include <array>

#include <fmt/format.h>

namespace stepmill::test {

using Json = nlohmann::json;

CutterProfile cutterOf(const Json& tool) {
    ToolAssembly cutter;
    cutter.diameter_mm = tool.at("diameter_mm");
    cutter.corner_radius_mm = tool.at("corner_radius_mm");
    cutter.tip_diameter_mm = tool.value("tip_diameter_mm", 0.0);
    cutter.included_angle_deg = tool.value("included_angle_deg", 0.0);
    cutter.point_angle_deg = tool.value("point_angle_deg", 118.0);
    for (const ToolType type : {ToolType::Drill, ToolType::Chamfer})
        if (tool.at("type") == toString(type)) cutter.type = type;
    return profileOf(cutter);
}

Eigen::Isometry3d transformOf(const Json& setup) {
    const auto rows = setup.at("transform").get<std::array<double, 16>>();
    Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            transform(row, column) = rows[static_cast<std::size_t>(4 * row + column)];
    return transform;
}

Box3 rawStockIn(const Json& plan, const Eigen::Isometry3d& part_to_setup) {
    const auto corners = plan.at("stock").at("bbox_mm").get<std::array<std::array<double, 3>, 2>>();
    const Box3 raw(Vec3(corners[0].data()), Vec3(corners[1].data()));
    Box3 box;
    for (int corner = 0; corner < 8; ++corner)
        box.extend(Vec3(part_to_setup * raw.corner(static_cast<Box3::CornerType>(corner))));
    return box;
}

std::string toolTableOf(const Json& plan) {
    std::string table;
    for (const Json& tool : plan.at("tools"))
        table += fmt::format("T{0} P{0} Z0 D0.1 ;\n", tool.at("number").get<int>());
    return table;
}

}  // namespace stepmill::test
