// Units and precision: what the numbers of the file mean.

#include <numbers>

#include <fmt/format.h>

#include "part/step/checks.h"
#include "part/step/kinds.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// Exporters round the inch to 25.4 and the degree to 0.01745.
constexpr double kUnitShare = 1e-3;

/// Readers merge what lies closer than the file's uncertainty: beyond this features are lost [mm].
constexpr double kLargestUncertainty_mm = 1;

struct NamedUnit {
    std::string_view name;
    double size;  ///< in metres or radians
};

constexpr NamedUnit kNamedUnits[] = {{"'INCH'", kMillimetresPerInch * 1e-3},
                                     {"'FOOT'", 12 * kMillimetresPerInch * 1e-3},
                                     {"'DEGREE'", std::numbers::pi / 180},
                                     {"'DEGREES'", std::numbers::pi / 180}};

std::string upper(std::string_view text) {
    std::string result;
    for (const char c : text)
        result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return result;
}

std::optional<double> prefixFactor(const StepValue& prefix) {
    static const std::map<std::string_view, double> kFactors = {{".KILO.", 1e3},   {".DECI.", 1e-1},
                                                                {".CENTI.", 1e-2}, {".MILLI.", 1e-3},
                                                                {".MICRO.", 1e-6}, {".NANO.", 1e-9}};
    if (prefix.is(StepValue::Kind::Omitted)) return 1.0;
    const auto found = kFactors.find(prefix.text());
    return found == kFactors.end() ? std::nullopt : std::optional(found->second);
}

class ContextCheck {
  public:
    ContextCheck(const StepScreen& screen, StepText& text) : screen_(screen), text_(text) {}

    void checkUnit(const StepEntity& unit) {
        const StepRecord* conversion = find(unit, "CONVERSION_BASED_UNIT");
        if (!conversion) return;
        const std::string name = upper(values(*conversion)[0].text());
        const std::optional<double> size = sizeOf(unit, 0);
        for (const NamedUnit& known : kNamedUnits)
            if (name == known.name && size && std::abs(*size / known.size - 1) > kUnitShare)
                doubt(unit,
                      fmt::format("calls a unit {} that is {:.6g} times as large", name, *size / known.size));
    }

    void checkUncertainty(const StepEntity& entity) {
        const StepRecord* record = find(entity, "UNCERTAINTY_MEASURE_WITH_UNIT");
        if (!record) return;
        const std::vector<double> numbers = values(*record).numbers();
        const std::optional<double> unit_m = unitSize(values(*record)[1], 0);
        if (numbers.empty() || !unit_m) return;
        const double uncertainty_mm = numbers.front() * *unit_m * 1e3;
        if (!(numbers.front() > 0) || uncertainty_mm > kLargestUncertainty_mm)
            doubt(entity, fmt::format("says that lengths are uncertain by {:g} mm; above 0 and up to {:g} "
                                      "expected, or the reader merges what lies close",
                                      uncertainty_mm, kLargestUncertainty_mm));
    }

    /// A solid outside every representation has no unit.
    void checkRepresented() {
        std::set<std::uint32_t> items;
        for (const StepEntity& entity : screen_.model.entities())
            for (const StepRecord& record : screen_.model.recordsOf(entity))
                if (record.keyword.ends_with("REPRESENTATION"))
                    for (const std::uint32_t id : itemsOf(record))
                        items.insert(id);
        for (const StepBody& body : text_.bodies)
            if (!items.contains(body.id))
                doubt(*screen_.model.find(body.id), "stands in no representation: its unit is not known");
    }

  private:
    /// A unit made of units made of units is nonsense; the depth ends circles.
    static constexpr int kDeepestUnit = 4;

    void doubt(const StepEntity& entity, const std::string& message) {
        text_.doubts.push_back(fmt::format("line {}: {} {}", entity.line, screen_.nameOf(entity), message));
    }

    const StepRecord* find(const StepEntity& entity, std::string_view keyword) const {
        return screen_.model.record(entity, keyword);
    }
    StepValues values(const StepRecord& record) const { return screen_.model.valuesOf(record); }

    std::vector<std::uint32_t> itemsOf(const StepRecord& record) const {
        std::vector<std::uint32_t> ids = values(record).list(0).references();
        for (const std::uint32_t id : values(record).list(1).references())
            ids.push_back(id);
        return ids;
    }

    /// In metres or radians; nothing for a unit this does not know.
    std::optional<double> sizeOf(const StepEntity& unit, int depth) const {
        if (depth > kDeepestUnit) return std::nullopt;
        if (const StepRecord* si = find(unit, "SI_UNIT")) return prefixFactor(values(*si)[0]);
        const StepRecord* conversion = find(unit, "CONVERSION_BASED_UNIT");
        if (!conversion) return std::nullopt;
        const StepEntity* measure = screen_.model.find(values(*conversion)[1].word);
        if (!measure) return std::nullopt;
        for (const StepRecord& record : screen_.model.recordsOf(*measure)) {
            if (!record.keyword.ends_with("MEASURE_WITH_UNIT")) continue;
            const std::vector<double> numbers = values(record).numbers();
            const std::optional<double> base = unitSize(values(record)[1], depth + 1);
            if (!numbers.empty() && base) return numbers.front() * *base;
        }
        return std::nullopt;
    }

    std::optional<double> unitSize(const StepValue& reference, int depth) const {
        const StepEntity* unit =
            reference.is(StepValue::Kind::Reference) ? screen_.model.find(reference.word) : nullptr;
        return unit ? sizeOf(*unit, depth) : std::nullopt;
    }

    const StepScreen& screen_;
    StepText& text_;
};

}  // namespace

void checkContext(const StepScreen& screen, StepText& text) {
    ContextCheck check(screen, text);
    for (const StepEntity& entity : screen.model.entities()) {
        check.checkUnit(entity);
        check.checkUncertainty(entity);
    }
    check.checkRepresented();
}

}  // namespace stepmill
