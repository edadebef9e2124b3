#include <nlohmann/json.hpp>

#include "stepmill/batch/part_figures.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

using json::Json;
using json::number;

Json toolJson(const ToolUse& use) {
    return {{"id", use.tool_id},
            {"diameter_mm", number(use.diameter_mm)},
            {"operations", use.operations},
            {"visits", use.visits},
            {"cutting_s", number(use.cutting_s)},
            {"life_used", number(use.life_used)}};
}

ToolUse toolFrom(const Json& json) {
    return {json.at("id"),     json.at("diameter_mm"), json.at("operations"),
            json.at("visits"), json.at("cutting_s"),   json.at("life_used")};
}

/// A list of ways, each [cost, tools].
Json taskJson(const ToolTask& task) {
    return json::listOf(task.ways, [](const ToolWay& way) {
        return Json::array({number(way.cost), way.tools});
    });
}

ToolTask taskFrom(const Json& json) {
    ToolTask task;
    for (const Json& way : json)
        task.ways.push_back({way.at(1).get<std::vector<std::string>>(), way.at(0)});
    return task;
}

Json offerJson(const OfferWorth& offer) {
    return {{"id", offer.tool_id},
            {"diameter_mm", number(offer.diameter_mm)},
            {"price", number(offer.price)},
            {"features", offer.features},
            {"saves_s", number(offer.saves_s)},
            {"saves_cost", number(offer.saves_cost)},
            {"more_mm3", number(offer.more_mm3)}};
}

OfferWorth offerFrom(const Json& json) {
    return {json.at("id"),      json.at("diameter_mm"), json.at("price"),   json.at("features"),
            json.at("saves_s"), json.at("saves_cost"),  json.at("more_mm3")};
}

Json asJson(const PartFigures& figures) {
    return {{"size_mm", json::point(figures.size_mm)},
            {"material", figures.material},
            {"solids", figures.solids},
            {"setups", figures.setups},
            {"features", figures.features},
            {"time_s", number(figures.time_s)},
            {"motion_s", number(figures.motion_s)},
            {"cost", number(figures.cost)},
            {"currency", figures.currency},
            {"lower_bound_s", number(figures.lower_bound_s)},
            {"stock_minus_part_mm3", number(figures.stock_minus_part_mm3)},
            {"stays_mm3", number(figures.stays_mm3)},
            {"reason", figures.reason},
            {"tools", json::listOf(figures.tools, toolJson)},
            {"tasks", json::listOf(figures.tasks, taskJson)},
            {"tasks_in_money", figures.tasks_in_money},
            {"offers", json::listOf(figures.offers, offerJson)},
            {"reports", figures.reports},
            {"picture", figures.picture}};
}

PartFigures figuresFrom(const Json& json) {
    PartFigures figures;
    for (Eigen::Index i = 0; i < 3; ++i)
        figures.size_mm[i] = json.at("size_mm").at(static_cast<std::size_t>(i));
    figures.material = json.at("material");
    figures.solids = json.at("solids");
    figures.setups = json.at("setups");
    figures.features = json.at("features");
    figures.time_s = json.at("time_s");
    figures.motion_s = json.at("motion_s");
    figures.cost = json.at("cost");
    figures.currency = json.at("currency");
    figures.lower_bound_s = json.at("lower_bound_s");
    figures.stock_minus_part_mm3 = json.at("stock_minus_part_mm3");
    figures.stays_mm3 = json.at("stays_mm3");
    figures.reason = json.at("reason");
    for (const Json& tool : json.at("tools"))
        figures.tools.push_back(toolFrom(tool));
    for (const Json& task : json.at("tasks"))
        figures.tasks.push_back(taskFrom(task));
    figures.tasks_in_money = json.at("tasks_in_money");
    for (const Json& offer : json.at("offers"))
        figures.offers.push_back(offerFrom(offer));
    figures.reports = json.at("reports").get<std::vector<std::string>>();
    figures.picture = json.at("picture");
    return figures;
}

}  // namespace

std::string figuresJson(const PartFigures& figures) {
    return asJson(figures).dump(-1, ' ', false, Json::error_handler_t::replace);
}

PartFigures figuresFromJson(std::string_view text) {
    try {
        return figuresFrom(Json::parse(text));
    } catch (const nlohmann::json::exception& why) {
        throw Error(ErrorCode::InvalidCatalog, "figures of a part", why.what());
    }
}

}  // namespace stepmill
