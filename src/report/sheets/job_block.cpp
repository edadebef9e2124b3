// The head of the first sheet: what the job is, and all its setups.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "report/page/program_lines.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/sheets/sheet_sections.h"
#include "report/viewer/packed_path.h"

namespace stepmill::report {
namespace {

/// So many digits of a file's SHA-256 tell two files apart for people.
constexpr std::size_t kShaDigits = 12;

/// A label with what stands there; nothing: a line to write on.
Element field(const char* label, const std::string& value) {
    return Element(
        "div.field", Element("span", label),
        value.empty() ? Element("b.blank").with("aria-label", "to be filled in") : Element("b", value));
}

const std::string& either(const std::string& first, const std::string& second) {
    return first.empty() ? second : first;
}

std::string revisionWords(const SheetSubject& subject) {
    const Part& part = subject.plan().part;
    const std::string file = fmt::format("{}, sha256 {}", part.file, part.sha256.substr(0, kShaDigits));
    return subject.job.revision.empty() ? file : subject.job.revision + " (" + file + ")";
}

std::string materialWords(const SheetSubject& subject) {
    const std::string& material = subject.plan().material;
    return subject.job.material.empty()
               ? material
               : fmt::format("{} (cutting data: {})", subject.job.material, material);
}

/// What the programs of a setup say of themselves.
struct RunFigures {
    double highest_mm = 0;
    double lowest_mm = 0;
    double feed_mm_per_min = 0;
    double speed_rpm = 0;
    double cut_mm = 0;
    double rapid_mm = 0;
    std::set<int> tools;
};

RunFigures figuresOf(const Plan& plan, const PlannedSetup& setup) {
    RunFigures run;
    for (const Operation& operation : setup.operations) {
        const Toolpath& path = operation.path;
        run.highest_mm = std::max(run.highest_mm, path.start.z());
        for (const Move& move : path.moves) {
            run.highest_mm = std::max(run.highest_mm, move.to.z());
            run.lowest_mm = std::min(run.lowest_mm, move.to.z());
        }
        run.feed_mm_per_min = std::max(run.feed_mm_per_min, fastestFeed(path));
        run.speed_rpm = std::max(run.speed_rpm, operation.speed_rpm);
        run.cut_mm += path.totals.cut_length_mm;
        run.rapid_mm += path.totals.air_length_mm;
        run.tools.insert(plan.library.tool(operation.tool_id).number);
    }
    return run;
}

std::string toolNumbers(const std::set<int>& tools) {
    std::vector<std::string> words;
    words.reserve(tools.size());
    for (const int tool : tools)
        words.push_back(fmt::format("T{}", tool));
    return listed(words);
}

std::string programWords(const PostedProgram* program) {
    if (program == nullptr) return "none is written";
    const auto lines = std::count(program->text.begin(), program->text.end(), '\n');
    return fmt::format("{}, {} lines, {} kB", program->file, lines, program->text.size() / 1000 + 1);
}

std::vector<Element> notes(const JobDetails& job) {
    std::vector<Element> paragraphs;
    for (const std::string& note : job.notes)
        paragraphs.push_back(Element("p", Element("b", "Note: "), note));
    return paragraphs;
}

}  // namespace

Element jobBlock(const SheetSubject& subject) {
    const JobDetails& job = subject.job;
    const Plan& plan = subject.plan();
    const std::string count = job.quantity > 0 ? std::to_string(job.quantity) : std::string();
    return Element("div.job", field("Part", either(job.part, plan.part.name)),
                   field("Part no.", job.part_number), field("Revision (file)", revisionWords(subject)),
                   field("Document no.", job.document), field("Description", job.description),
                   field("Job or order", job.order), field("Customer", job.customer),
                   field("Quantity", count), field("Material", materialWords(subject)),
                   field("Programmer", job.programmer),
                   field("Machine", either(job.machine, plan.machine.name)), field("Date", job.date),
                   field("Controller", either(job.controller, toString(subject.proven.files.dialect))),
                   field("Set up by", ""), notes(job));
}

Element runTable(const SheetSubject& subject) {
    const Measures& in = subject.measures;
    const Plan& plan = subject.plan();
    const std::string unit = in.unit();
    Table table({"setup",
                 "program",
                 "part's axis up",
                 "tools",
                 numbers("operations"),
                 {"highest Z " + unit, true},
                 {"lowest Z " + unit, true},
                 {std::string("fastest feed ") + in.feedUnit(), true},
                 numbers("highest rpm"),
                 numbers("cut"),
                 numbers("rapid"),
                 numbers("time")});
    for (const PlannedSetup* setup : subject.setups) {
        const RunFigures run = figuresOf(plan, *setup);
        table.row(setup->setup.id, programWords(programOf(subject.proven, *setup)),
                  axisName(setup->setup.axis), toolNumbers(run.tools),
                  std::to_string(setup->operations.size()), in.number(run.highest_mm),
                  in.number(run.lowest_mm), in.feed(run.feed_mm_per_min), fixed(run.speed_rpm, 0),
                  in.way(run.cut_mm), in.way(run.rapid_mm), clockTime(setup->motion_s));
    }
    const std::string total =
        fmt::format("All setups {}, {} tool changes of {:g} s, rapids at {} {}, clamping not counted.",
                    clockTime(plan.totals.motion_s), plan.totals.tool_changes, plan.machine.tool_change_s,
                    in.feed(plan.machine.rapid_mm_per_min), in.feedUnit());
    return titled("The whole job", Element("div", std::move(table).element(), Element("p.soft", total)));
}

}  // namespace stepmill::report
