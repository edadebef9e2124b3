#include "replan/compare_inputs.h"

#include <fmt/format.h>

#include "stepmill/record/plan_json.h"

namespace stepmill::replan {
namespace {

std::string sourceWords(const RecordedFile& file) {
    constexpr std::size_t kShownOfHash = 12;
    if (file.sha256.empty()) return "none";
    return fmt::format("{} ({})", file.file, file.sha256.substr(0, kShownOfHash));
}

/// Collects what differs.
class Inputs {
  public:
    void file(const char* what, const RecordedFile& before, const RecordedFile& after) {
        if (before.sha256 != after.sha256) add(what, sourceWords(before), sourceWords(after));
    }
    void word(const char* what, const std::string& before, const std::string& after) {
        if (before != after) add(what, before, after);
    }
    void length(const char* what, double before_mm, double after_mm) {
        if (before_mm != after_mm)
            add(what, fmt::format("{:g} mm", before_mm), fmt::format("{:g} mm", after_mm));
    }
    void add(const std::string& what, const std::string& before, const std::string& after) {
        changes.push_back({what, before, after});
    }

    std::vector<InputChange> changes;
};

std::string reserveWord(bool reserve) {
    return reserve ? "where it pays" : "none";
}

std::string holdWord(const std::optional<HoldKind>& hold) {
    return hold ? toString(*hold) : "what will do";
}

std::string cycleWords(const std::vector<CycleTarget>& targets) {
    std::string words;
    for (const CycleTarget& target : targets)
        words += fmt::format("{}{}{:g} s", words.empty() ? "" : ", ",
                             target.of.empty() ? "" : target.of + " ", target.time_s);
    return words.empty() ? "none" : words;
}

}  // namespace

std::vector<InputChange> inputChanges(const RecordedPlan& before, const RecordedPlan& after) {
    const RecordedRequest was = before.record.request.value_or(RecordedRequest{});
    const RecordedRequest is = after.record.request.value_or(RecordedRequest{});
    Inputs inputs;
    inputs.file("tool library", before.record.library, after.record.library);
    for (const MachineDifference& other : machineDifferences(before.files.plan_json, after.record.machine))
        inputs.add("machine " + other.pointer, other.recorded, other.expected);
    inputs.word("material", before.record.material, after.record.material);
    inputs.file("fixtures", was.fixtures, is.fixtures);
    inputs.file("hole table", was.holes, is.holes);
    inputs.file("stock", was.stock, is.stock);
    inputs.length("stock margin at the sides", was.margin.side_mm, is.margin.side_mm);
    inputs.length("stock margin on top", was.margin.top_mm, is.margin.top_mm);
    inputs.length("stock margin below", was.margin.bottom_mm, is.margin.bottom_mm);
    inputs.word("held by", holdWord(was.hold), holdWord(is.hold));
    inputs.length("finish of walls", was.finish.walls_mm, is.finish.walls_mm);
    inputs.length("finish of floors", was.finish.floors_mm, is.finish.floors_mm);
    inputs.length("edges broken by", was.break_edges_mm, is.break_edges_mm);
    inputs.word("stock left for later setups", reserveWord(was.reserve), reserveWord(is.reserve));
    inputs.word("cycle times", cycleWords(was.cycle_times), cycleWords(is.cycle_times));
    inputs.word("made least", toString(was.objective), toString(is.objective));
    return inputs.changes;
}

}  // namespace stepmill::replan
