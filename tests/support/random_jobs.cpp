#include "support/random_jobs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/random_parts.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kShopTools = "shop_metric_tools";

Json sampleLibrary(const std::string& name) {
    std::ifstream file(fs::path(STEPMILL_SOURCE_DIR) / "samples" / (name + ".json"));
    return Json::parse(file);
}

bool isMill(const Json& tool) {
    return tool["type"] == "flat" || tool["type"] == "face";
}

/// Every tool with the same chance; at least one mill stays.
void keepSome(Json& library, Dice& dice) {
    Json kept = Json::array();
    const double share = dice.between(0.2, 0.9);
    for (const Json& tool : library["tools"])
        if (dice.chance(share)) kept.push_back(tool);
    if (std::none_of(kept.begin(), kept.end(), isMill))
        for (const Json& tool : library["tools"])
            if (tool["type"] == "flat" && tool["diameter"] == 6) kept.push_back(tool);
    library["tools"] = kept;
}

/// Sets the tool out by so much more. Flutes and shank stay out of the holder.
void setOut(Json& tool, double more) {
    double least = tool["flute_length"];
    if (tool.contains("shank")) least = std::max(least, tool["shank"]["from"].get<double>());
    const double stick_out = std::max(least, std::round(tool["stick_out"].get<double>() + more));
    more = stick_out - tool["stick_out"].get<double>();
    tool["stick_out"] = stick_out;
    for (Json& cylinder : tool["holder"]) {
        cylinder["bottom"] = cylinder["bottom"].get<double>() + more;
        cylinder["top"] = cylinder["top"].get<double>() + more;
    }
}

/// Some tools longer, some shorter, some with a range; some holders wider.
void changeHolders(Json& library, Dice& dice) {
    for (Json& tool : library["tools"]) {
        if (dice.chance(0.5)) setOut(tool, dice.between(-10, 30, 1));
        if (dice.chance(0.2) && tool.contains("holder"))
            for (Json& cylinder : tool["holder"])
                cylinder["diameter"] = std::round(cylinder["diameter"].get<double>() * 1.4);
        if (!dice.chance(0.15)) continue;
        const double longest = tool["stick_out"];
        double least = tool["flute_length"];
        if (tool.contains("shank")) least = std::max(least, tool["shank"]["from"].get<double>());
        if (least < longest - 1) tool["stick_out"] = Json{{"min", std::ceil(least)}, {"max", longest}};
    }
}

struct Library {
    std::string name;
    std::string text;
};

Library randomLibrary(Dice& dice) {
    const std::size_t which = dice.below(10);
    if (which < 3) return {"built-in tools", ""};
    if (which == 3) return {"dsouza2006 tools", sampleLibrary("dsouza2006_tools").dump(1)};
    if (which == 4) return {"common pocket tools", sampleLibrary("common_pocket_tools").dump(1)};
    Json library = sampleLibrary(kShopTools);
    std::string name = "all shop tools";
    if (which > 5) {
        keepSome(library, dice);
        name = fmt::format("{} of the shop tools", library["tools"].size());
    }
    if (which < 9) {
        changeHolders(library, dice);
        name += ", other holders";
    }
    return {name, library.dump(1)};
}

Json blockOn(const std::string& name, double x0, double y0, double x1, double y1, double bottom, double top) {
    return {{"name", name},
            {"outline", Json::array({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})},
            {"bottom", bottom},
            {"top", top}};
}

/// Nothing, or clamps over the left edge of the first setup and a stop before it.
Library randomFixtures(Dice& dice) {
    const std::size_t which = dice.below(10);
    if (which < 6) return {"vise", ""};
    Json setups = Json::array();
    std::string name = "nothing in the way";
    for (int i = 1; i <= 6; ++i)
        setups.push_back({{"setup", fmt::format("S{}", i)}, {"fixtures", Json::array()}});
    if (which >= 8) {
        name = "clamps";
        const double y = dice.between(0, 20, 1);
        const double over = dice.between(2, 12, 0.5);
        setups[0]["fixtures"].push_back(blockOn("clamp", -30, y, over, y + 15, 0, dice.between(5, 25, 1)));
        setups[0]["fixtures"].push_back(blockOn("stop", 5, -25, 25, -0.5, -30, dice.between(-5, 3, 1)));
    }
    return {name, Json{{"format", 1}, {"unit", "mm"}, {"setups", setups}}.dump(1)};
}

void addOption(std::vector<std::string>& words, const std::string& option, const std::string& value) {
    words.push_back(option);
    words.push_back(value);
}

std::vector<std::string> randomOptions(Dice& dice, bool may_be_steel) {
    std::vector<std::string> words;
    if (dice.chance(0.4))
        addOption(words, "--stock-margin",
                  fmt::format("{},{},{}", dice.between(0, 3, 0.5), dice.between(0, 3, 0.5),
                              dice.between(0, 3, 0.5)));
    if (dice.chance(0.15)) {
        addOption(words, "--setup", "+z");
        if (dice.chance(0.5)) addOption(words, "--setup", "-z");
    } else if (dice.chance(0.1)) {
        addOption(words, "--no-setup", dice.oneOf({"-z", "+x", "-y"}));
    }
    if (dice.chance(0.2)) addOption(words, "--finish-walls", dice.oneOf({"0.1", "0.2", "0.5"}));
    if (dice.chance(0.15)) addOption(words, "--finish-floors", dice.oneOf({"0.1", "0.2", "0.5"}));
    if (may_be_steel && dice.chance(0.2)) addOption(words, "--material", "steel");
    if (dice.chance(0.15)) addOption(words, "--objective", "cost");
    if (dice.chance(0.1)) addOption(words, "--surrogates", "single");
    if (dice.chance(0.1)) addOption(words, "--cost-model", dice.oneOf({"yao", "lim"}));
    return words;
}

}  // namespace

RandomJob randomJob(std::uint64_t seed) {
    Dice dice(seed);
    RandomJob job;
    job.seed = seed;
    job.part = randomPart(fmt::format("random_{:04}", seed), dice);
    const Library tools = randomLibrary(dice);
    const Library fixtures = randomFixtures(dice);
    job.tools_json = tools.text;
    job.fixtures_json = fixtures.text;
    job.options = randomOptions(dice, tools.name.find("shop") != std::string::npos || tools.text.empty());
    job.about = fmt::format("{}; {}; {}", job.part.about, tools.name, fixtures.name);
    return job;
}

std::vector<std::string> writeJob(const RandomJob& job, const std::string& folder) {
    const auto write = [&](const std::string& name, const std::string& text) {
        const std::string file = (fs::path(folder) / name).string();
        std::ofstream(file, std::ios::binary) << text;
        return file;
    };
    std::vector<std::string> words{"plan", write(job.part.name + ".step", sampleStepText(job.part))};
    if (!job.tools_json.empty()) addOption(words, "--tools", write("tools.json", job.tools_json));
    if (!job.fixtures_json.empty()) addOption(words, "--fixtures", write("fixtures.json", job.fixtures_json));
    words.insert(words.end(), job.options.begin(), job.options.end());
    return words;
}

}  // namespace stepmill::test
