// Tools in a table of any program's columns.

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "crib/tool_maker.h"
#include "crib/type_words.h"
#include "stepmill/core/csv_reader.h"
#include "stepmill/core/error.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

using crib::fieldText;

/// What a column may hold: the words of docs/tool-library.md, and four of this table alone.
constexpr std::array kFields = {"id",
                                "number",
                                "type",
                                "description",
                                "diameter",
                                "corner_radius",
                                "tip_diameter",
                                "included_angle_deg",
                                "point_angle_deg",
                                "thread",
                                "pitch",
                                "flute_length",
                                "flutes",
                                "stick_out",
                                "shank_diameter",
                                "shank_from",
                                "holder",
                                "cutter_material",
                                "centre_cutting",
                                "material",
                                "step_over",
                                "step_down",
                                "feed",
                                "plunge_feed",
                                "speed_rpm",
                                "ramp_angle_deg",
                                "price",
                                "life_min",
                                "vendor",
                                "product_id",
                                "unit"};

/// Where each field stands in the rows.
class Columns {
  public:
    Columns(const CsvRow& heads, const std::string& file, const ForeignOptions& options) {
        for (const auto& [field, head] : options.columns)
            if (std::find(kFields.begin(), kFields.end(), field) == kFields.end())
                throw Error(ErrorCode::Usage, "--column",
                            fmt::format("expected one of {}; found '{}'", fmt::join(kFields, ", "),
                                        fieldText(field, 40)));
        for (const char* field : kFields)
            place(field, heads, file, options);
        for (std::size_t column = 0; column < heads.cells.size(); ++column)
            if (std::none_of(at_.begin(), at_.end(), [&](const auto& at) { return at.second == column; }))
                unused_.push_back(fieldText(heads.cells[column], 60));
        if (!has("diameter") || !has("type"))
            crib::refuse(file, fmt::format("line {}", heads.line),
                         "expected columns diameter and type, or --column FIELD=HEAD that names them");
    }

    bool has(const std::string& field) const { return at_.contains(field); }
    const std::vector<std::string>& unused() const { return unused_; }

    /// Empty where the row has no such cell.
    std::string cell(const CsvRow& row, const std::string& field) const {
        const auto at = at_.find(field);
        return at == at_.end() || at->second >= row.cells.size() ? std::string() : row.cells[at->second];
    }

  private:
    void place(const std::string& field, const CsvRow& heads, const std::string& file,
               const ForeignOptions& options) {
        const auto told = options.columns.find(field);
        const std::string& head = told == options.columns.end() ? field : told->second;
        const auto found = std::find(heads.cells.begin(), heads.cells.end(), head);
        if (found != heads.cells.end())
            at_[field] = static_cast<std::size_t>(found - heads.cells.begin());
        else if (told != options.columns.end())
            throw Error(ErrorCode::Usage, "--column",
                        fmt::format("expected a column that {} has, found '{}'", file, fieldText(head, 40)));
    }

    std::map<std::string, std::size_t> at_;
    std::vector<std::string> unused_;
};

class CsvTool {
  public:
    CsvTool(const CsvRow& row, const Columns& columns, const std::string& file, const ForeignOptions& options)
        : row_(row), columns_(columns), file_(file), options_(options) {
        foreign_.place = fmt::format("line {}", row.line);
    }

    ForeignTool read() {
        takeUnit();
        takeWords();
        if (foreign_.unfit.empty()) {
            takeSizes();
            takeHolder();
            takeCutting();
        }
        crib::finishTool(foreign_, mm("pitch"), file_, options_);
        return std::move(foreign_);
    }

  private:
    std::string text(const char* field, std::size_t most) const {
        return fieldText(columns_.cell(row_, field), most);
    }

    double number(const char* field) const {
        const std::string cell = columns_.cell(row_, field);
        if (cell.empty()) return 0;
        const std::optional<double> value = crib::numberOf(cell);
        if (!value || *value < 0)
            crib::refuse(file_, fmt::format("{}, {}", foreign_.place, field),
                         fmt::format("expected a number of 0 or more, found '{}'", fieldText(cell, 40)));
        return *value;
    }

    double mm(const char* field) const { return mm_per_unit_ * number(field); }

    void takeUnit() {
        const std::string unit = columns_.cell(row_, "unit");
        const std::optional<double> known = crib::mmPerUnit(unit);
        if (!unit.empty() && !known)
            crib::refuse(file_, foreign_.place + ", unit",
                         fmt::format("expected mm or inch, found '{}'", fieldText(unit, 40)));
        mm_per_unit_ = known ? *known : crib::toldUnitMm(options_, file_);
        foreign_.is_inch = mm_per_unit_ != 1;
    }

    void takeWords() {
        ToolAssembly& tool = foreign_.tool;
        const std::string type = columns_.cell(row_, "type");
        const crib::TypeWord word = crib::typeOfWords(type);
        if (word.type) crib::setType(tool, *word.type);
        if (!word.type)
            foreign_.unfit = !word.unfit.empty() ? word.unfit
                                                 : fmt::format("'{}' is no type of tool that Stepmill knows",
                                                               fieldText(type, 60));
        tool.id = text("id", 100);
        tool.description = text("description", 900);
        tool.vendor = text("vendor", 900);
        tool.product_id = text("product_id", 900);
        tool.number = static_cast<int>(std::min(number("number"), 99999.0));
        tool.cutter_material =
            cutterMaterialFrom(columns_.cell(row_, "cutter_material")).value_or(CutterMaterial::Carbide);
        const std::string centre = columns_.cell(row_, "centre_cutting");
        tool.centre_cutting = centre == "yes" || centre == "true" || centre == "1";
    }

    void takeSizes() {
        ToolAssembly& tool = foreign_.tool;
        tool.diameter_mm = mm("diameter");
        tool.corner_radius_mm = mm("corner_radius");
        tool.tip_diameter_mm = mm("tip_diameter");
        tool.included_angle_deg = number("included_angle_deg");
        if (number("point_angle_deg") > 0) tool.point_angle_deg = number("point_angle_deg");
        tool.flute_length_mm = mm("flute_length");
        tool.flutes = static_cast<int>(std::min(number("flutes"), 100.0));
        tool.stick_out_mm = mm("stick_out");
        tool.price = number("price");
        tool.life_min = number("life_min");
        tool.shank = {mm("shank_diameter"), std::max(mm("shank_from"), tool.flute_length_mm),
                      tool.stick_out_mm};
        const std::string thread = columns_.cell(row_, "thread");
        tool.thread = threadFrom(thread);
        if (!thread.empty() && !tool.thread)
            crib::refuse(
                file_, foreign_.place + ", thread",
                fmt::format("expected a thread such as M8 or 1/4-20 UNC, found '{}'", fieldText(thread, 40)));
    }

    /// "42x21 46x45": diameter x height of its cylinders, from below to above.
    void takeHolder() {
        std::stringstream cylinders(columns_.cell(row_, "holder"));
        for (std::string cylinder; cylinders >> cylinder;) {
            const std::size_t cross = cylinder.find('x');
            const auto diameter = crib::numberOf(cylinder.substr(0, cross));
            const auto height =
                cross == std::string::npos ? std::nullopt : crib::numberOf(cylinder.substr(cross + 1));
            if (!diameter || !height || !(*diameter > 0) || !(*height > 0))
                crib::refuse(file_, foreign_.place + ", holder",
                             fmt::format("expected cylinders such as 42x21 46x45, found '{}'",
                                         fieldText(cylinder, 40)));
            foreign_.tool.holder.push_back({mm_per_unit_ * *diameter, 0, mm_per_unit_ * *height});
        }
        crib::stackHolder(foreign_.tool);
    }

    void takeCutting() {
        if (number("feed") == 0 && number("speed_rpm") == 0) return;
        CuttingData data;
        data.material = crib::materialName(options_, "", columns_.cell(row_, "material"));
        data.step_over_mm = mm("step_over");
        data.step_down_mm = mm("step_down");
        data.feed_mm_per_min = mm("feed");
        data.plunge_feed_mm_per_min = mm("plunge_feed");
        data.ramp_angle_deg = number("ramp_angle_deg");
        data.speed_rpm = number("speed_rpm");
        crib::addCutting(foreign_, data.material, data);
    }

    const CsvRow& row_;
    const Columns& columns_;
    const std::string& file_;
    const ForeignOptions& options_;
    double mm_per_unit_ = 1;
    ForeignTool foreign_;
};

}  // namespace

ForeignLibrary csvFromText(std::string_view text, const std::string& name, const ForeignOptions& options) {
    const std::vector<CsvRow> rows = readCsv(name, text);
    if (rows.empty()) crib::refuse(name, "line 1", "expected a row of heads, found the end of the file");
    const Columns columns(rows.front(), name, options);
    if (rows.size() - 1 > crib::kMostTools)
        crib::refuse(name, fmt::format("line {}", rows.back().line),
                     fmt::format("expected at most {} tools", crib::kMostTools));
    ForeignLibrary library{name, {}};
    for (std::size_t i = 1; i < rows.size(); ++i)
        library.tools.push_back(CsvTool(rows[i], columns, name, options).read());
    if (!columns.unused().empty())
        library.notes.push_back(fmt::format("columns left aside: {}", fmt::join(columns.unused(), ", ")));
    return library;
}

}  // namespace stepmill
