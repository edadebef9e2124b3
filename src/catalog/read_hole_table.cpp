#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/schema_check.h"
#include "stepmill/catalog/hole_table.h"
#include "stepmill/catalog/json_text.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using nlohmann::json;

/// Sizes in a table come from a drawing or a report of three decimals [mm].
constexpr double kDrawnMm = 5e-4;

constexpr EnumWord<HoleMaking> kMakings[] = {{HoleMaking::Tap, "tap"},
                                             {HoleMaking::Ream, "ream"},
                                             {HoleMaking::Bore, "bore"},
                                             {HoleMaking::Drill, "drill"},
                                             {HoleMaking::Leave, "leave"}};

/// Reads a document that keeps the schema.
class HoleTableReader {
  public:
    HoleTableReader(const json& from, std::string file_name)
        : from_(from),
          file_name_(std::move(file_name)),
          mm_per_unit_(from["unit"] == "inch" ? kMillimetresPerInch : 1.0) {}

    HoleTable read() const {
        HoleTable table;
        table.file = file_name_;
        for (std::size_t i = 0; i < from_["holes"].size(); ++i)
            table.entries.push_back(entry(from_["holes"][i], fmt::format("#/holes/{}", i)));
        return table;
    }

  private:
    [[noreturn]] void fail(const std::string& pointer, const std::string& what) const {
        throw Error(ErrorCode::InvalidCatalog, file_name_ + pointer, what);
    }

    std::optional<SizeRange> range(const json& from, const char* field, const std::string& pointer) const {
        if (!from.contains(field)) return std::nullopt;
        const json& ends = from[field];
        const SizeRange range{ends["min"].get<double>() * mm_per_unit_,
                              ends["max"].get<double>() * mm_per_unit_};
        if (range.most_mm < range.least_mm)
            fail(fmt::format("{}/{}/max", pointer, field),
                 fmt::format("expected no less than min, {}, found {}", ends["min"].dump(),
                             ends["max"].dump()));
        return range;
    }

    HoleEntry entry(const json& from, const std::string& pointer) const {
        HoleEntry entry;
        entry.pointer = pointer;
        entry.diameter = range(from, "diameter", pointer);
        entry.depth = range(from, "depth", pointer);
        entry.ids = from.value("ids", std::vector<std::string>{});
        if (!entry.diameter && !entry.depth && entry.ids.empty())
            fail(pointer, "expected at least one of diameter, depth and ids, found none");
        entry.make = valueOf(kMakings, from["make"].get<std::string>()).value();
        readThread(from, pointer, entry);
        readFit(from, pointer, entry);
        return entry;
    }

    void readFit(const json& from, const std::string& pointer, HoleEntry& entry) const {
        const bool sizes = entry.make == HoleMaking::Ream || entry.make == HoleMaking::Bore;
        if (sizes && !from.contains("fit"))
            fail(pointer, "expected the field \"fit\" of a hole to be reamed or bored, found none");
        if (!sizes && from.contains("fit"))
            fail(pointer + "/fit", "expected with \"make\": \"ream\" or \"bore\" alone");
        if (!sizes) return;
        entry.fit = fitFrom(from["fit"].get<std::string>());
        if (!entry.fit)
            fail(pointer + "/fit",
                 fmt::format("expected a fit of F, G, H or JS and a grade from 6 to 11 such as "
                             "H7, found {}",
                             from["fit"].dump()));
    }

    void readThread(const json& from, const std::string& pointer, HoleEntry& entry) const {
        const bool taps = entry.make == HoleMaking::Tap;
        if (taps && !from.contains("thread"))
            fail(pointer, "expected the field \"thread\" of a hole to be tapped, found none");
        for (const char* field : {"thread", "thread_depth"})
            if (!taps && from.contains(field))
                fail(fmt::format("{}/{}", pointer, field), "expected with \"make\": \"tap\" alone");
        if (!taps) return;
        const std::string name = from["thread"];
        entry.thread = threadFrom(name);
        if (!entry.thread)
            fail(pointer + "/thread",
                 fmt::format("expected a thread such as M8, M8x1 or 1/4-20 UNC, found {}",
                             from["thread"].dump()));
        entry.thread_depth_mm = from.value("thread_depth", 0.0) * mm_per_unit_;
    }

    const json& from_;
    std::string file_name_;
    double mm_per_unit_;
};

}  // namespace

bool SizeRange::holds(double value_mm) const {
    return value_mm >= least_mm - kDrawnMm && value_mm <= most_mm + kDrawnMm;
}

HoleTable holeTableFromText(std::string_view text, const std::string& file_name) {
    const ParsedJson parsed = checkedJson(text, schemaJson(SchemaName::Holes));
    throwFirstError(parsed.findings, file_name);
    HoleTable table = HoleTableReader(parsed.value, file_name).read();
    table.sha256 = sha256(text);
    return table;
}

HoleTable readHoleTable(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return holeTableFromText(readFile(path, max_bytes), path.filename().string());
}

}  // namespace stepmill
