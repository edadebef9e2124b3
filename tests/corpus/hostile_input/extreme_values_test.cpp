// Numbers that the schemas allow, at their ends and between: a plan, gaps or a refusal, never a bug.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include "catalog/schema_check.h"
#include "catalog/schema_words.h"
#include "stepmill/core/file.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::string kPart = kSource + "/step_parts/shoulder_block.step";
constexpr const char* kTimeLimitS = "15";

/// A number of a document that its schema bounds.
struct Number {
    std::string file;
    json::json_pointer place;
    double least = 0;
    double most = 0;
    bool whole = false;
};

using Job = std::map<std::string, json>;

/// Three tools that plan the part, one with all fields.
json smallLibrary() {
    json library = json::parse(readFile(kSource + "/samples/shop_metric_tools.json"));
    json tools = json::array();
    for (const json& tool : library["tools"])
        if (tool["id"] == "FM50" || tool["id"] == "EM10" || tool["type"] == "drill")
            if (tools.size() < 3) tools.push_back(tool);
    for (json& tool : tools) {
        json cutting = json::array();
        for (const json& data : tool["cutting"])
            if (data["material"] == "aluminium") cutting.push_back(data);
        tool["cutting"] = cutting;
    }
    library["tools"] = tools;
    return library;
}

Job goodJob() {
    json machine = json::parse(readFile(kSource + "/samples/machine_vmc.json"));
    machine["junction_deviation_mm"] = 0.01;
    const json clamp{{"name", "clamp"},
                     {"outline", {{-30, 0}, {-10, 0}, {-10, 20}, {-30, 20}}},
                     {"bottom", -20},
                     {"top", -5}};
    return {{"tools", smallLibrary()},
            {"machine", machine},
            {"fixtures",
             {{"format", 1},
              {"unit", "mm"},
              {"growth", 0.05},
              {"setups", {{{"setup", "S1"}, {"fixtures", {clamp}}}}}}}};
}

void collect(const std::string& file, const json& schema, const json& value, const json::json_pointer& place,
             std::vector<std::string> steps, std::vector<Number>& numbers) {
    if (value.is_structured()) {
        for (const auto& [name, item] : value.items()) {
            std::vector<std::string> deeper = steps;
            deeper.push_back(name);
            const json::json_pointer there =
                value.is_array() ? place / static_cast<std::size_t>(std::stoul(name)) : place / name;
            collect(file, schema, item, there, deeper, numbers);
        }
        return;
    }
    const json* limits = value.is_number() ? SchemaWords(schema).find(steps) : nullptr;
    if (limits == nullptr || !limits->contains("minimum")) return;
    numbers.push_back(
        {file, place, (*limits)["minimum"], (*limits)["maximum"], (*limits)["type"] == "integer"});
}

std::vector<Number> numbersOf(const Job& job) {
    std::vector<Number> numbers;
    for (const auto& [file, name] :
         {std::pair("tools", SchemaName::Tools), std::pair("machine", SchemaName::Machine),
          std::pair("fixtures", SchemaName::Fixtures)})
        collect(file, schemaJson(name), job.at(file), json::json_pointer(), {}, numbers);
    return numbers;
}

void set(Job& job, const Number& number, double value) {
    json& place = job[number.file][number.place];
    if (number.whole)
        place = std::llround(value);
    else
        place = value;
}

/// Between the limits, every power of ten as likely.
double logRandom(const Number& number, std::mt19937& random) {
    const double least = std::max(number.least, 1e-9);
    std::uniform_real_distribution<double> power(std::log(least), std::log(number.most));
    const double size = std::clamp(std::exp(power(random)), least, number.most);
    return number.least < 0 && random() % 2 == 0 ? -size : size;
}

double draw(const Number& number, std::mt19937& random) {
    switch (random() % 4) {
        case 0:
            return number.least;
        case 1:
            return number.most;
        default:
            return logRandom(number, random);
    }
}

void expectNoBug(const Job& job, const std::string& what) {
    const TemporaryFolder folder;
    std::vector<std::string> words{stepmillBinary(),      "plan", kPart, "--timeout", kTimeLimitS, "-o",
                                   folder.path() + "/job"};
    for (const auto& [file, document] : job) {
        const std::string path = folder.path() + "/" + file + ".json";
        std::ofstream(path) << document.dump();
        words.insert(words.end(), {"--" + file, path});
    }
    const ProgramRun run = runProgram(words);
    EXPECT_TRUE(run.exit_code >= 0 && run.exit_code <= 2) << what << ": " << run.exit_code << "\n" << run.err;
    if (run.exit_code == 2) {
        EXPECT_LT(run.err.size(), 1000U) << what;
    }
}

std::string wordsFor(const Number& number, double value) {
    return fmt::format("{}{} = {:g}", number.file, number.place.to_string(), value);
}

TEST(ExtremeValues, AtEitherEndAreNoBugs) {
    const Job good = goodJob();
    for (const Number& number : numbersOf(good)) {
        for (const double value : {number.least, number.most}) {
            Job job = good;
            set(job, number, value);
            expectNoBug(job, wordsFor(number, value));
        }
    }
}

int draws() {
    const char* asked = std::getenv("STEPMILL_EXTREME_DRAWS");
    return asked != nullptr ? std::atoi(asked) : 60;
}

TEST(ExtremeValues, DrawnAndCombinedAreNoBugs) {
    const Job good = goodJob();
    const std::vector<Number> numbers = numbersOf(good);
    for (int seed = 1; seed <= draws(); ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        Job job = good;
        std::string what = fmt::format("seed {}:", seed);
        const std::size_t count = 1 + random() % 4;
        for (std::size_t i = 0; i < count; ++i) {
            const Number& number = numbers[random() % numbers.size()];
            const double value = draw(number, random);
            set(job, number, value);
            what += " " + wordsFor(number, value);
        }
        expectNoBug(job, what);
    }
}

TEST(ExtremeValues, OnTheCommandLineAreNoBugs) {
    for (const char* option : {"--stock-margin", "--finish-walls", "--finish-floors"}) {
        for (const char* value :
             {"nan", "inf", "-inf", "1e308", "1e999", "-1", "1e-300", "0x1p3", "1e5", ""}) {
            const TemporaryFolder folder;
            const std::string text = std::string(option) == "--stock-margin"
                                         ? fmt::format("{},{},{}", value, value, value)
                                         : std::string(value);
            const ProgramRun run = runProgram({stepmillBinary(), "plan", kPart, option, text, "--timeout",
                                               kTimeLimitS, "-o", folder.path() + "/job"});
            EXPECT_LE(run.exit_code, 2) << option << " " << value << ": " << run.err;
            EXPECT_GE(run.exit_code, 0) << option << " " << value;
            EXPECT_LT(run.err.size(), 400U) << run.err;
        }
    }
}

}  // namespace
}  // namespace stepmill::test
