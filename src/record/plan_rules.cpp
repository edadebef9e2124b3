// A plan.json that keeps its schema may still contradict itself.

#include "record/plan_rules.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "stepmill/catalog/fit.h"
#include "stepmill/catalog/thread.h"
#include "stepmill/core/error.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/post/post.h"

namespace stepmill::record {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers in plan.json have six decimals.
constexpr double kWritten = 1e-6;
/// A corner radius meant to be half the diameter, as both are written [mm].
constexpr double kSameRadiusMm = 2 * kWritten;
/// An area or a volume and what it is of agree to this share: both come from one computation and are rounded.
constexpr double kSameShare = 1e-6;

/// Three numbers of six decimals are of length 1 to this.
constexpr double kUnitLength = 1e-5;

std::string pointerTo(const char* list, std::size_t index, const char* field = nullptr) {
    return field == nullptr ? fmt::format("#/{}/{}", list, index)
                            : fmt::format("#/{}/{}/{}", list, index, field);
}

void checkUnique(const Json& plan, const char* list, const char* field) {
    std::map<Json, std::size_t> seen;
    for (std::size_t i = 0; i < plan[list].size(); ++i) {
        const auto [first, is_new] = seen.emplace(plan[list][i][field], i);
        if (!is_new)
            failAt(pointerTo(list, i, field),
                   fmt::format("expected a value that no other has, found {} as in {}",
                               plan[list][i][field].dump(-1, ' ', true), pointerTo(list, first->second)));
    }
}

/// Every entry of `plan[list]` stands once in the list of that name of its own setup, and nothing else does.
void checkListed(const Json& plan, const char* list) {
    std::map<std::string, std::string> setup_of;
    for (const Json& entry : plan[list])
        setup_of[entry["id"]] = entry["setup"];
    std::set<std::string> listed;
    for (std::size_t i = 0; i < plan["setups"].size(); ++i) {
        const Json& setup = plan["setups"][i];
        for (const Json& name : setup[list]) {
            const std::string id = name;
            const auto found = setup_of.find(id);
            if (found == setup_of.end() || found->second != setup["id"].get<std::string>())
                failAt(pointerTo("setups", i, list), fmt::format("'{}' is none of this setup", id));
            if (!listed.insert(id).second)
                failAt(pointerTo("setups", i, list), fmt::format("'{}' stands twice", id));
        }
    }
    for (std::size_t i = 0; i < plan[list].size(); ++i)
        if (listed.count(plan[list][i]["id"]) == 0)
            failAt(pointerTo(list, i, "setup"),
                   fmt::format("no setup lists '{}'", plan[list][i]["id"].get<std::string>()));
}

using BandName = std::pair<std::string, int>;

BandName nameOf(const Json& name) {
    return {name["feature"], name["band"]};
}

std::string wordsOf(const BandName& band) {
    return fmt::format("band {} of '{}'", band.second, band.first);
}

/// The bands of a plan with the setups they are cut in.
std::map<BandName, std::string> setupsOfBands(const Json& plan) {
    std::map<BandName, std::string> setups;
    for (const Json& feature : plan["features"])
        for (const Json& band : feature["bands"])
            setups[{feature["id"], band["band"]}] = feature["setup"];
    return setups;
}

/// Is it a band of a known feature of the setup?
/// \param name  with the members "feature" and "band"
bool isBand(const Json& name, const Json& setup, const std::map<BandName, std::string>& setups) {
    const auto found = setups.find(nameOf(name));
    return found != setups.end() && found->second == setup;
}

/// No band waits for itself, by way of others or not: those whose parents are done are taken away until none
/// is left.
void checkNoCircle(const Json& plan) {
    std::map<BandName, std::size_t> waits_for;
    std::map<BandName, std::vector<BandName>> children;
    std::vector<BandName> ready;
    for (const Json& feature : plan["features"])
        for (const Json& band : feature["bands"]) {
            const BandName name{feature["id"], band["band"]};
            waits_for[name] = band["parents"].size();
            if (band["parents"].empty()) ready.push_back(name);
            for (const Json& parent : band["parents"])
                children[nameOf(parent)].push_back(name);
        }
    while (!ready.empty()) {
        const BandName done = ready.back();
        ready.pop_back();
        waits_for.erase(done);
        for (const BandName& child : children[done])
            if (--waits_for.at(child) == 0) ready.push_back(child);
    }
    if (!waits_for.empty())
        failAt("#/features", fmt::format("{} waits for itself", wordsOf(waits_for.begin()->first)));
}

/// Ratings mean nothing without the forces of the material and the power of the spindle.
void checkRatings(const Json& plan) {
    const bool tells_forces = plan.contains("cut_material") && plan["machine"].contains("spindle");
    for (std::size_t i = 0; i < plan["operations"].size() && !tells_forces; ++i)
        if (plan["operations"][i].contains("rating"))
            failAt(pointerTo("operations", i, "rating"),
                   "expected none in a plan without cut_material or the machine's spindle");
}

/// Nothing is driven at another pace than its cutting data's but for a cycle time that was asked for, and
/// beyond it only what has a rating.
void checkPaces(const Json& plan) {
    const bool asked = plan.contains("request") && plan["request"].contains("cycle_times");
    if (plan.contains("cycle_time") != asked)
        failAt("#/cycle_time", "expected outcomes where request.cycle_times asks for times, and there alone");
    for (std::size_t i = 0; i < plan["operations"].size(); ++i) {
        const Json& operation = plan["operations"][i];
        if (!operation.contains("pace")) continue;
        if (!asked) failAt(pointerTo("operations", i, "pace"), "expected none without request.cycle_times");
        if (operation["pace"] > 1 && !operation.contains("rating"))
            failAt(pointerTo("operations", i, "pace"), "expected no more than 1 without a rating");
    }
}

/// Parents are other bands of the same setup.
void checkParents(const Json& plan) {
    const std::map<BandName, std::string> setups = setupsOfBands(plan);
    for (std::size_t i = 0; i < plan["features"].size(); ++i) {
        const Json& feature = plan["features"][i];
        for (std::size_t k = 0; k < feature["bands"].size(); ++k)
            for (const Json& parent : feature["bands"][k]["parents"])
                if (!isBand(parent, feature["setup"], setups))
                    failAt(fmt::format("{}/{}/parents", pointerTo("features", i, "bands"), k),
                           fmt::format("{} is none of this setup", wordsOf(nameOf(parent))));
    }
    checkNoCircle(plan);
}

/// Features that keep names keep different ones.
void checkKeptNames(const Json& plan) {
    for (std::size_t i = 0; i < plan["setups"].size(); ++i) {
        const Json& setup = plan["setups"][i];
        if (!setup.contains("kept_names")) continue;
        for (const char* column : {"number", "id"}) {
            std::set<std::string> seen;
            for (const Json& kept : setup["kept_names"])
                if (!seen.insert(kept[column]).second)
                    failAt(pointerTo("setups", i, "kept_names"),
                           fmt::format("'{}' stands twice", kept[column].get<std::string>()));
        }
    }
}

/// Every list of a table by column has an entry for each of its rows.
void checkColumns(const Json& table, const std::string& pointer) {
    const std::size_t rows = table.front().size();
    for (const auto& [name, column] : table.items())
        if (column.size() != rows)
            failAt(fmt::format("{}/{}", pointer, name),
                   fmt::format("expected {} entries as in the other columns, found {}", rows, column.size()));
}

void checkSame(const Json& feature, const char* field, double by_bands, double slack,
               const std::string& pointer) {
    const double told = feature[field];
    if (std::abs(told - by_bands) > slack)
        failAt(fmt::format("{}/{}", pointer, field),
               fmt::format("expected what its bands say, {:.6f}, found {:.6f}", by_bands, told));
}

/// The floors of ground that is cut before the rest of one band, by the band's id.
using UpperParts = std::map<std::string, std::set<double>>;

UpperParts upperParts(const Json& plan) {
    UpperParts floors;
    for (const Json& feature : plan["features"])
        if (feature.contains("ground_of") && feature["ground_of"].size() == 1)
            floors[feature["ground_of"].front()].insert(feature["floor_z_mm"].get<double>());
    return floors;
}

bool beginsBelowAPart(const Json& feature, const Json& band, const UpperParts& parts) {
    const auto found = parts.find(bandId(feature["id"], band["band"], feature["levels"]));
    return found != parts.end() && found->second.count(band["top_z_mm"].get<double>()) > 0;
}

/// Bands are numbered from above, each where the one above it ends, or what of the band is cut before it;
/// common ground may have taken some.
void checkBandAbove(const Json& above, const Json& band, bool below_a_part, const std::string& pointer) {
    const int apart = band["band"].get<int>() - above["band"].get<int>();
    if (apart < 1) failAt(pointer + "/band", "expected a number above that of the band above");
    const double gap_mm = above["floor_z_mm"].get<double>() - band["top_z_mm"].get<double>();
    const bool follows = apart > 1 || below_a_part ? gap_mm > 0 : gap_mm == 0;
    if (!follows) failAt(pointer + "/top_z_mm", "expected the floor of the band above");
}

/// A feature is what its bands make up.
void checkBands(const Json& feature, const UpperParts& parts, const std::string& pointer) {
    const Json& bands = feature["bands"];
    double volume_mm3 = 0;
    for (std::size_t i = 0; i < bands.size(); ++i) {
        volume_mm3 += bands[i]["volume_mm3"].get<double>();
        checkColumns(bands[i]["tools"], fmt::format("{}/bands/{}/tools", pointer, i));
        checkColumns(bands[i]["dag"]["edges"], fmt::format("{}/bands/{}/dag/edges", pointer, i));
        if (i > 0)
            checkBandAbove(bands[i - 1], bands[i], beginsBelowAPart(feature, bands[i], parts),
                           fmt::format("{}/bands/{}", pointer, i));
    }
    if (bands.back()["band"] > feature["levels"])
        failAt(pointer + "/levels", "expected no less than the number of the lowest band");
    const double slack = kWritten * static_cast<double>(bands.size() + 1);
    const double top_z_mm = bands.front()["top_z_mm"];
    const double floor_z_mm = bands.back()["floor_z_mm"];
    checkSame(feature, "top_z_mm", top_z_mm, 0, pointer);
    checkSame(feature, "floor_z_mm", floor_z_mm, 0, pointer);
    checkSame(feature, "depth_mm", top_z_mm - floor_z_mm, slack, pointer);
    checkSame(feature, "volume_mm3", volume_mm3, slack + kSameShare * volume_mm3, pointer);
}

/// A tap's name tells its thread, and that its diameter.
void checkTap(const Json& tool, const std::string& pointer) {
    const bool tap = tool["type"] == "tap";
    const bool leads = tap || tool["type"] == "reamer" || tool["type"] == "boring";
    if (tap != tool.contains("thread") || leads != tool.contains("lead_mm"))
        failAt(pointer,
               "expected thread and lead of a tap, a lead of a reamer or boring head, and of nothing else");
    if (!tap) return;
    const std::optional<Thread> thread = threadFrom(tool["thread"].get<std::string>());
    if (!thread)
        failAt(pointer + "/thread", fmt::format("expected a thread, found {}", tool["thread"].dump()));
    if (std::abs(thread->diameter_mm - tool["diameter_mm"].get<double>()) > kWritten)
        failAt(pointer + "/diameter_mm", fmt::format("expected that of {}, {:.6f}, found {}", thread->name,
                                                     thread->diameter_mm, tool["diameter_mm"].dump()));
}

void checkTool(const Json& tool, const std::string& pointer) {
    checkTap(tool, pointer);
    const std::string type = tool["type"];
    const double corner_mm = tool["corner_radius_mm"];
    const double radius_mm = tool["diameter_mm"].get<double>() / 2;
    const bool fits = type == "ball"   ? std::abs(corner_mm - radius_mm) <= kSameRadiusMm
                      : type == "bull" ? corner_mm > 0 && corner_mm <= radius_mm + kSameRadiusMm
                      : type == "face" ? corner_mm <= radius_mm + kSameRadiusMm
                                       : corner_mm == 0;
    if (!fits)
        failAt(pointer + "/corner_radius_mm",
               fmt::format("{} mm is no corner of a {} cutter of {} mm", corner_mm, type, 2 * radius_mm));
    const bool cone = type == "chamfer" || type == "countersink";
    if (cone != tool.contains("included_angle_deg") || cone != tool.contains("tip_diameter_mm"))
        failAt(pointer, "expected tip and angle of a chamfer mill or countersink, and of nothing else");
    if (cone && tool["tip_diameter_mm"].get<double>() >= 2 * radius_mm)
        failAt(pointer + "/tip_diameter_mm", "expected less than the diameter");
    double below_mm = tool["stick_out_mm"];
    for (std::size_t i = 0; i < tool["holder"].size(); ++i) {
        const Json& cylinder = tool["holder"][i];
        const double bottom_mm = cylinder["bottom_mm"];
        const double top_mm = cylinder["top_mm"];
        if (bottom_mm < below_mm - kWritten || top_mm <= bottom_mm)
            failAt(fmt::format("{}/holder/{}", pointer, i), "expected cylinders from below to above");
        below_mm = top_mm;
    }
}

/// A tap cuts its own thread, in holes.
void checkThread(const Json& operation, const Json& tool, const std::string& pointer) {
    const bool taps = operation["role"] == "tap";
    if (taps != (tool["type"] == "tap"))
        failAt(pointer + "/role", fmt::format("'{}' is no work of a {}", operation["role"].get<std::string>(),
                                              tool["type"].get<std::string>()));
    if (taps != operation.contains("thread"))
        failAt(pointer, "expected a thread of an operation of role tap, and of no other");
    if (!taps) return;
    const Json& thread = operation["thread"];
    if (thread["name"] != tool["thread"])
        failAt(pointer + "/thread/name", fmt::format("expected that of the tap, {}, found {}",
                                                     tool["thread"].dump(), thread["name"].dump()));
    if (operation.value("holes", std::size_t{0}) != thread["places"].size())
        failAt(pointer + "/holes", fmt::format("expected as many as places, {}", thread["places"].size()));
}

/// Tools for holes have each a role of their own, which no other tool has.
void checkHoleRole(const Json& operation, const Json& tool, const std::string& pointer) {
    static const std::map<std::string, std::string> kRoles{
        {"drill", "drill"}, {"spot", "spot"}, {"reamer", "ream"}, {"boring", "bore"}};
    for (const auto& [type, role] : kRoles)
        if ((tool["type"] == type) != (operation["role"] == role))
            failAt(pointer + "/role",
                   fmt::format("'{}' is no work of a {}", operation["role"].get<std::string>(),
                               tool["type"].get<std::string>()));
    // A cone in any other role would be proven by another form than it has.
    const bool cone = tool["type"] == "countersink" || tool["type"] == "chamfer";
    if (cone && operation["role"] != "form")
        failAt(pointer + "/role", fmt::format("expected 'form' of a {}", tool["type"].get<std::string>()));
}

/// What brings a bore to its fit says which.
void checkFit(const Json& operation, const std::string& pointer) {
    const bool sizes = operation["role"] == "ream" || operation["role"] == "bore";
    if (sizes != operation.contains("fit"))
        failAt(pointer, "expected a fit of an operation of role ream or bore, and of no other");
    if (sizes && !fitFrom(operation["fit"].get<std::string>()))
        failAt(pointer + "/fit", fmt::format("expected a fit such as H7, found {}", operation["fit"].dump()));
}

void checkOperation(const Json& operation, const std::map<std::string, Json>& tools,
                    const std::map<BandName, std::string>& setups_of_work, const std::string& pointer) {
    const auto tool = tools.find(operation["tool"]);
    if (tool == tools.end())
        failAt(pointer + "/tool",
               fmt::format("expected a tool of this plan, found '{}'", operation["tool"].get<std::string>()));
    checkHoleRole(operation, tool->second, pointer);
    checkThread(operation, tool->second, pointer);
    checkFit(operation, pointer);
    const bool form = operation["role"] == "form";
    const std::string type = tool->second["type"];
    if (form && type != "ball" && type != "bull" && type != "chamfer" && type != "countersink")
        failAt(pointer + "/role", fmt::format("'form' is no work of a {}", type));
    if (form != isFormGround(operation["feature"], operation["setup"]))
        failAt(pointer + "/role", "expected 'form' on a form ground and there alone");
    if (!isBand(operation, operation["setup"], setups_of_work))
        failAt(pointer + "/feature", fmt::format("expected a feature of this plan and setup, found {}",
                                                 wordsOf(nameOf(operation))));
    if (operation["z_top_mm"].get<double>() <= operation["z_floor_mm"].get<double>())
        failAt(pointer + "/z_top_mm", "expected a top above the floor");
}

/// Form grounds, each as the only band of its own, with the setups they are in.
std::map<BandName, std::string> setupsOfForms(const Json& plan) {
    std::map<BandName, std::string> setups;
    if (!plan.contains("forms")) return setups;
    for (std::size_t i = 0; i < plan["forms"].size(); ++i) {
        const Json& form = plan["forms"][i];
        if (!isFormGround(form["id"], form["setup"]))
            failAt(pointerTo("forms", i, "id"), "expected the id of a ground of its setup");
        if ((form["id"] == edgeGroundId(form["setup"])) != form.contains("edges_mm"))
            failAt(pointerTo("forms", i, "id"), "expected the width of a ground of edges, and of no other");
        if (!setups.emplace(BandName{form["id"], 1}, form["setup"]).second)
            failAt(pointerTo("forms", i, "id"), "expected a setup that no other form has");
    }
    return setups;
}

void checkAxes(const Json& plan) {
    for (std::size_t i = 0; i < plan["setups"].size(); ++i) {
        const Json& axis = plan["setups"][i]["axis"];
        const double length = std::hypot(axis[0].get<double>(), axis[1].get<double>(), axis[2].get<double>());
        if (std::abs(length - 1) > kUnitLength)
            failAt(pointerTo("setups", i, "axis"),
                   fmt::format("expected a unit vector, found one of length {:g}", length));
    }
}

void checkPrograms(const Json& plan) {
    const std::optional<Dialect> dialect =
        dialectFrom(plan["machine"].value("dialect", toString(Dialect::LinuxCnc)));
    for (std::size_t i = 0; i < plan["setups"].size(); ++i) {
        const std::string name = programName(plan["setups"][i]["id"], *dialect);
        if (plan["setups"][i]["program"] != name)
            failAt(pointerTo("setups", i, "program"),
                   fmt::format("expected {}, found '{}'", name,
                               plan["setups"][i]["program"].get<std::string>()));
    }
}

/// Corners are set on a grid as fine as what is written: each edge may move by that.
double areaSlackMm2(const Region& region) {
    return kWritten * (1 + perimeter(region));
}

bool isAreaOf(const Region& region, double area_mm2) {
    return std::abs(area(region) - area_mm2) <= areaSlackMm2(region) + kSameShare * area_mm2;
}

}  // namespace

void failAt(const std::string& pointer, const std::string& what) {
    throw Error(ErrorCode::InvalidCatalog, "plan.json" + pointer, what);
}

void checkPlanRules(const Json& plan) {
    for (const char* list : {"setups", "tools", "features", "operations"})
        checkUnique(plan, list, "id");
    checkUnique(plan, "tools", "number");
    const UpperParts parts = upperParts(plan);
    for (std::size_t i = 0; i < plan["features"].size(); ++i)
        checkBands(plan["features"][i], parts, pointerTo("features", i));
    checkParents(plan);
    checkKeptNames(plan);
    checkRatings(plan);
    checkPaces(plan);
    std::map<std::string, Json> tools;
    for (std::size_t i = 0; i < plan["tools"].size(); ++i) {
        checkTool(plan["tools"][i], pointerTo("tools", i));
        tools[plan["tools"][i]["id"]] = plan["tools"][i];
    }
    std::map<BandName, std::string> setups_of_work = setupsOfBands(plan);
    setups_of_work.merge(setupsOfForms(plan));
    for (std::size_t i = 0; i < plan["operations"].size(); ++i)
        checkOperation(plan["operations"][i], tools, setups_of_work, pointerTo("operations", i));
    checkListed(plan, "features");
    checkListed(plan, "operations");
    checkAxes(plan);
    checkPrograms(plan);
}

void checkUpright(const Json& prism, const std::string& pointer) {
    if (prism["top_z_mm"].get<double>() <= prism["bottom_z_mm"].get<double>())
        failAt(pointer + "/top_z_mm", "expected a top above the bottom");
}

void checkBand(const RecordedFeature& recorded, const std::string& pointer) {
    const Feature& feature = recorded.feature;
    if (feature.top_z_mm <= feature.floor_z_mm)
        failAt(pointer + "/top_z_mm", "expected a top above the floor");
    if (feature.target.empty()) failAt(pointer + "/target", "expected an area to clear, found none");
    if (!isAreaOf(feature.target, feature.area_mm2))
        failAt(pointer + "/area_mm2", fmt::format("expected the target's area, {:.6f}, found {:.6f}",
                                                  area(feature.target), feature.area_mm2));
    for (std::size_t i = 0; i < recorded.residual.size(); ++i) {
        const Residual& residual = recorded.residual[i];
        const std::string at = fmt::format("{}/residual/{}", pointer, i);
        if (!residual.region.empty() && !isAreaOf(residual.region, residual.area_mm2))
            failAt(at + "/area_mm2", fmt::format("expected the region's area, {:.6f}, found {:.6f}",
                                                 area(residual.region), residual.area_mm2));
        // A whole feature stays with its own volume, which joined slabs may set a little off area times
        // depth.
        const double box_mm3 =
            (residual.area_mm2 + areaSlackMm2(residual.region)) * feature.depth_mm() + kWritten;
        const double most_mm3 = std::max(box_mm3, feature.volume_mm3);
        if (residual.volume_mm3 > most_mm3 * (1 + kSameShare))
            failAt(at + "/volume_mm3",
                   fmt::format("expected no more than area times depth, {:.6f}, found {:.6f}", most_mm3,
                               residual.volume_mm3));
    }
}

namespace {

/// What stays of the residuals is what the part's books say stays; plans of older versions do not tell.
void checkStaying(const Json& plan, double rounding_mm3) {
    double staying_mm3 = 0;
    bool told = false;
    for (const Json& feature : plan["features"])
        for (const Json& band : feature["bands"])
            for (const Json& residual : band["residual"]) {
                if (!residual.contains("stays_mm3")) return;
                told = true;
                staying_mm3 += residual["stays_mm3"].get<double>();
            }
    const Json& books = plan["volume_balance"];
    if (!told || !books.contains("residual_by_reason")) return;
    double booked_mm3 = 0;
    for (const Json& entry : books["residual_by_reason"])
        if (!isLeftUncut(stayReasonFrom(entry["reason"].get<std::string>())))
            booked_mm3 += entry["volume_mm3"].get<double>();
    if (std::abs(staying_mm3 - booked_mm3) > rounding_mm3)
        failAt("#/volume_balance/residual_mm3",
               fmt::format("expected what stays of the residuals, {:.3f}, found {:.3f}", staying_mm3,
                           booked_mm3));
}

}  // namespace

void checkBooks(const Json& plan, const Tolerances& tol) {
    const double removable_mm3 =
        plan["stock"]["volume_mm3"].get<double>() - plan["part"]["volume_mm3"].get<double>();
    const double told_mm3 = plan["volume_balance"]["stock_minus_part_mm3"];
    const double rounding_mm3 = std::max(kVolumeRoundingMm3, tol.volume_share * std::abs(removable_mm3));
    if (std::abs(told_mm3 - removable_mm3) > rounding_mm3)
        failAt("#/volume_balance/stock_minus_part_mm3",
               fmt::format("expected stock less part, {:.3f}, found {:.3f}", removable_mm3, told_mm3));
    for (const char* account : {"residual", "unreachable"}) {
        const std::string list = fmt::format("{}_by_reason", account);
        if (!plan["volume_balance"].contains(list)) continue;
        double sum_mm3 = 0;
        for (const Json& entry : plan["volume_balance"][list])
            sum_mm3 += entry["volume_mm3"].get<double>();
        const double account_mm3 = plan["volume_balance"][fmt::format("{}_mm3", account)];
        if (std::abs(sum_mm3 - account_mm3) > rounding_mm3)
            failAt("#/volume_balance/" + list,
                   fmt::format("adds up to {:.3f}, not {:.3f}", sum_mm3, account_mm3));
    }
    checkStaying(plan, rounding_mm3);
    std::map<std::string, double> volume_of;
    for (const Json& feature : plan["features"])
        volume_of[feature["setup"]] += feature["volume_mm3"].get<double>();
    for (const Json& operation : plan["operations"])
        if (operation.contains("takes"))
            for (const Json& taken : operation["takes"])
                volume_of[operation["setup"]] += taken["volume_mm3"].get<double>();
    for (std::size_t i = 0; i < plan["setups"].size(); ++i) {
        const Json& setup = plan["setups"][i];
        if (!setup.contains("volume_balance")) continue;
        const double planned_mm3 = setup["volume_balance"]["planned_mm3"];
        const std::string pointer = pointerTo("setups", i, "volume_balance/planned_mm3");
        if (planned_mm3 > volume_of[setup["id"]] + rounding_mm3)
            failAt(pointer, fmt::format("{:.3f} is more than its features hold, {:.3f}", planned_mm3,
                                        volume_of[setup["id"]]));
        if (planned_mm3 > rounding_mm3 && setup["operations"].empty())
            failAt(pointer, fmt::format("{:.3f} is to be cut, by no operation", planned_mm3));
    }
}

}  // namespace stepmill::record
