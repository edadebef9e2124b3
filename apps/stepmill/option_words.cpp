#include "option_words.h"

#include <array>
#include <filesystem>

#include <fmt/ranges.h>

#include "plan_job.h"
#include "stepmill/catalog/fixture.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {

namespace {

/// An app with the options that change a plan alone.
struct PlanningApp {
    PlanningApp() {
        addPlanningOptions(app, options);
        addOfferOptions(app, options);
    }

    template <typename Words>
    void parse(Words&& words) {
        try {
            app.parse(std::forward<Words>(words));
        } catch (const CLI::ParseError& stop) {
            throw Error(ErrorCode::Usage, "options", stop.what());
        }
    }

    PlanOptions options;
    CLI::App app;
};

/// Options whose value is a file, if it is no word of their own.
bool namesFile(const std::string& name, const std::string& value) {
    constexpr std::array kFiles = {"tools", "machine", "fixtures", "holes", "stock", "buy"};
    const bool takes_file = std::find(kFiles.begin(), kFiles.end(), name) != kFiles.end();
    return takes_file && !(name == "stock" && (value == "box" || value == "auto"));
}

/// The name of a file stands in plan.json, its folder does not. Of fixtures the files of their solids count.
std::string withContent(const std::string& option, const std::string& file, std::uintmax_t max_file_bytes) {
    const std::filesystem::path path(file);
    std::string words = path.filename().string() + " " + sha256(readFile(path, max_file_bytes));
    if (option != "fixtures") return words;
    for (const auto& [setup, solids] : readFixtures(path, max_file_bytes).solids)
        for (const FixtureSolid& solid : solids)
            words += fmt::format(" {}", sha256(readFile(path.parent_path() / solid.file, max_file_bytes)));
    return words;
}

std::vector<std::string> lineOf(const OptionWords& words) {
    std::vector<std::string> line;
    for (const auto& [name, values] : words)
        for (const std::string& value : values)
            line.push_back(fmt::format("--{}={}", name, value));
    return line;
}

}  // namespace

OptionWords optionWords(const CLI::App& command) {
    const PlanningApp planning;
    OptionWords words;
    for (const CLI::Option* known : planning.app.get_options()) {
        const std::string& name = known->get_lnames().front();
        const CLI::Option* option = command.get_option_no_throw("--" + name);
        if (name == "help" || option == nullptr || option->empty()) continue;
        words[name] = option->results();
    }
    return words;
}

OptionWords optionWords(const std::string& line) {
    PlanningApp planning;
    planning.parse(line);
    return optionWords(planning.app);
}

OptionWords merged(OptionWords all, const OptionWords& own) {
    for (const auto& [name, values] : own)
        all[name] = values;
    return all;
}

PlanOptions planOptions(const OptionWords& words) {
    PlanningApp planning;
    std::vector<std::string> line = lineOf(words);
    std::reverse(line.begin(), line.end());  // as CLI11 wants it
    planning.parse(line);
    return planning.options;
}

std::string sha256Of(const OptionWords& words, std::uintmax_t max_file_bytes) {
    const PlanningApp planning;
    std::string text;
    for (const auto& [name, values] : words) {
        const std::string usual = planning.app.get_option("--" + name)->get_default_str();
        if (fmt::format("{}", fmt::join(values, " ")) == usual) continue;
        for (const std::string& value : values)
            text += fmt::format("{}={}\n", name,
                                namesFile(name, value) ? withContent(name, value, max_file_bytes) : value);
    }
    return sha256(text);
}

}  // namespace stepmill
