#include "stepmill/crib/import_tools.h"

#include <algorithm>

#include <fmt/format.h>

#include "crib/tool_maker.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/catalog/write_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/crib/fill_tool.h"

namespace stepmill {
namespace {

/// As docs/tool-library.md says.
constexpr int kMostNumber = 99999;
constexpr std::size_t kMostTools = 1000;

/// What our libraries must have and a file may lack; without it a tool is left out.
std::vector<std::string> missing(const ToolAssembly& tool) {
    std::vector<std::string> lacks;
    if (tool.flute_length_mm == 0) lacks.push_back("the flutes' length");
    if (tool.stick_out_mm == 0) lacks.push_back("the stick-out");
    return lacks;
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (std::size_t i = 0; i < words.size(); ++i)
        all += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return all;
}

/// What plans would use and the file does not say.
std::vector<std::string> gapsOf(const ToolAssembly& tool) {
    std::vector<std::string> gaps;
    if (tool.holder.empty())
        gaps.push_back("no holder: nothing keeps it off the part; measure it and put it under \"holder\"");
    if (tool.shank.diameter_mm == 0)
        gaps.push_back("no shank: taken as thick as the cutter; put it under \"shank\"");
    if (tool.cutting.empty())
        gaps.push_back(tool.flutes == 0 && !tool.isForHoles()
                           ? "no cutting data, so that no plan takes it; a feed per tooth needs \"flutes\""
                           : "no cutting data, so that no plan takes it; put it under \"cutting\"");
    if (!tool.isForHoles() && !tool.centre_cutting)
        gaps.push_back("not told to cut at its centre: it goes down by ramps alone; say \"centre_cutting\"");
    if (tool.life_min == 0) gaps.push_back("no tool life: its wear costs nothing; put it under \"life_min\"");
    return gaps;
}

/// Data that a mill cannot be planned with go, with a note.
void dropHalfCutting(ToolAssembly& tool, std::vector<std::string>& gaps) {
    if (tool.isForHoles()) return;
    const auto lacks = [](const CuttingData& data) {
        return data.step_over_mm == 0 || data.step_down_mm == 0;
    };
    for (const CuttingData& data : tool.cutting)
        if (lacks(data))
            gaps.push_back(
                fmt::format("cutting data for '{}' left out: they have no {}; --cutting-data fills "
                            "it",
                            data.material, data.step_over_mm == 0 ? "step-over" : "step-down"));
    std::erase_if(tool.cutting, lacks);
}

class Importer {
  public:
    Importer(const ForeignLibrary& foreign, const UsualValues* usual) : foreign_(foreign), usual_(usual) {}

    ImportedLibrary import() {
        imported_.library.file = foreign_.file;
        imported_.library.unit = unit();
        imported_.notes = foreign_.notes;
        for (const ForeignTool& tool : foreign_.tools)
            if (tool.tool.number > 0 && tool.unfit.empty()) told_numbers_.insert(tool.tool.number);
        for (const ForeignTool& tool : foreign_.tools)
            imported_.tools.push_back(importOne(tool));
        if (imported_.library.tools.empty()) fail();
        return std::move(imported_);
    }

  private:
    std::string unit() const {
        const auto usable_in_mm = [](const ForeignTool& tool) { return tool.unfit.empty() && !tool.is_inch; };
        const bool any = std::any_of(foreign_.tools.begin(), foreign_.tools.end(),
                                     [](const ForeignTool& tool) { return tool.unfit.empty(); });
        return any && std::none_of(foreign_.tools.begin(), foreign_.tools.end(), usable_in_mm) ? "inch"
                                                                                               : "mm";
    }

    [[noreturn]] void fail() const {
        std::string why = "it holds none";
        if (!imported_.tools.empty())
            why = fmt::format("of {} none can be taken; {}: {}", imported_.tools.size(),
                              imported_.tools.front().place, imported_.tools.front().left_out);
        throw Error(ErrorCode::InvalidCatalog, foreign_.file,
                    fmt::format("expected tools that Stepmill plans with, but {}", why));
    }

    ImportedTool importOne(const ForeignTool& foreign) {
        ImportedTool result{foreign.place, nameOf(foreign.tool), foreign.unfit, {}, foreign.notes, {}};
        if (!result.left_out.empty()) return result;
        ToolAssembly tool = foreign.tool;
        if (usual_ != nullptr) result.filled = fillFrom(*usual_, tool);
        if (const auto lacks = missing(tool); !lacks.empty()) {
            result.left_out =
                fmt::format("the file does not say {}; --cutting-data FILE fills it", joined(lacks));
            result.filled.clear();
            return result;
        }
        dropHalfCutting(tool, result.gaps);
        for (std::string& gap : gapsOf(tool))
            result.gaps.push_back(std::move(gap));
        if (tool.shank.diameter_mm == 0)
            tool.shank = {tool.diameter_mm, tool.flute_length_mm, tool.stick_out_mm};
        tool.shank.bottom_mm = std::min(tool.shank.bottom_mm, tool.stick_out_mm);
        name(tool, result);
        result.left_out = brokenRule(tool);
        if (!result.left_out.empty()) {
            result.filled.clear();
            return result;
        }
        ids_.insert(tool.id);
        numbers_.insert(tool.number);
        imported_.library.tools.push_back(std::move(tool));
        return result;
    }

    static std::string nameOf(const ToolAssembly& tool) {
        if (!tool.id.empty()) return tool.id;
        if (!tool.description.empty()) return tool.description;
        return tool.number > 0 ? fmt::format("T{}", tool.number) : "a tool";
    }

    /// A number and a name of its own.
    void name(ToolAssembly& tool, ImportedTool& result) {
        const int told = tool.number;
        if (told == 0 || numbers_.contains(told)) {
            tool.number = freeNumber();
            result.notes.push_back(
                told == 0 ? fmt::format("no tool number: T{} is given", tool.number)
                          : fmt::format("T{} is another tool's: T{} is given", told, tool.number));
        }
        const std::string wished = tool.id.empty() ? fmt::format("T{}", tool.number) : tool.id;
        tool.id = wished;
        for (int copy = 2; ids_.contains(tool.id); ++copy)
            tool.id = fmt::format("{} ({})", crib::fieldText(wished, 90), copy);
        result.name = tool.id;
    }

    int freeNumber() {
        while (numbers_.contains(next_number_) || told_numbers_.contains(next_number_))
            ++next_number_;
        if (next_number_ > kMostNumber)
            throw Error(ErrorCode::InvalidCatalog, foreign_.file, "expected fewer tools than tool numbers");
        return next_number_;
    }

    /// The rules of tool libraries, as their reader checks them; empty: all kept.
    std::string brokenRule(const ToolAssembly& tool) const {
        if (imported_.library.tools.size() == kMostTools)
            return fmt::format("a library holds at most {} tools", kMostTools);
        ToolLibrary alone;
        alone.unit = imported_.library.unit;
        alone.tools.push_back(tool);
        try {
            toolLibraryFromText(toolLibraryJson(alone, ""), "");
        } catch (const Error& error) {
            constexpr std::string_view kPlace = "#/tools/0/";
            const std::string what = error.what();
            return what.starts_with(kPlace) ? what.substr(kPlace.size()) : what;
        }
        return {};
    }

    const ForeignLibrary& foreign_;
    const UsualValues* usual_;
    ImportedLibrary imported_;
    std::set<int> told_numbers_;
    std::set<int> numbers_;
    std::set<std::string> ids_;
    int next_number_ = 1;
};

}  // namespace

bool ImportedLibrary::complete() const {
    return std::all_of(tools.begin(), tools.end(),
                       [](const ImportedTool& tool) { return tool.left_out.empty(); });
}

FilledFields ImportedLibrary::filled() const {
    FilledFields fields;
    for (const ImportedTool& tool : tools)
        if (tool.left_out.empty() && !tool.filled.empty()) fields[tool.name] = tool.filled;
    return fields;
}

ImportedLibrary importTools(const ForeignLibrary& foreign, const UsualValues* usual) {
    return Importer(foreign, usual).import();
}

}  // namespace stepmill
