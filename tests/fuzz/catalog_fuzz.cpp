// Tool libraries, machines, fixtures and tables of cutters from strangers: each text is read or refused with
// Error(InvalidCatalog); what is read keeps the limits that planning counts on. The first byte says which.

#include <cstdint>
#include <cstdlib>

#include <fmt/core.h>

#include "stepmill/catalog/access_table.h"
#include "stepmill/catalog/fixture.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

void require(bool holds, const char* law) {
    if (holds) return;
    fmt::print(stderr, "law broken: {}\n", law);
    std::abort();
}

void readTools(std::string_view text) {
    for (const ToolAssembly& tool : toolLibraryFromText(text, "tools.json").tools) {
        require(!tool.id.empty() && tool.number >= 1, "a tool has a name and a number");
        require(tool.diameter_mm > 0.009 && tool.diameter_mm < 501, "a diameter is a cutter's");
        for (const CuttingData& data : tool.cutting)
            require(data.speed_rpm >= 1 && data.feed_mm_per_min > 0.99, "a tool that cuts turns and moves");
    }
}

void readMachineText(std::string_view text) {
    const Machine machine = machineFromText(text, "machine.json");
    require(machine.magazine_size >= 1 && machine.safe_height_mm > 0, "a machine has a place for a tool");
}

void readFixtureText(std::string_view text) {
    for (const auto& [setup, fixtures] : fixturesFromText(text, "fixtures.json").setups)
        for (const Fixture& fixture : fixtures)
            require(fixture.top_z_mm > fixture.bottom_z_mm && !diagnose(fixture.section),
                    "a fixture is a block");
}

void readTable(std::string_view text) {
    const std::vector<AccessRow> rows = accessTableFromText(text, "table.csv");
    require(!rows.empty(), "a table has a cutter");
    const std::vector<AccessRow> again = accessTableFromText(accessTableCsv(rows), "table.csv");
    require(again.size() == rows.size(), "a table reads back");
    for (std::size_t i = 0; i < rows.size(); ++i)
        require(again[i].diameter_mm == rows[i].diameter_mm && again[i].volume_cm3 == rows[i].volume_cm3,
                "a table reads back bit for bit");
}

}  // namespace
}  // namespace stepmill

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace stepmill;
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        switch (data[0]) {
            case 'm':
                readMachineText(text);
                break;
            case 'f':
                readFixtureText(text);
                break;
            case 'c':
                readTable(text);
                break;
            default:
                readTools(text);
        }
    } catch (const Error& error) {
        if (error.code() != ErrorCode::InvalidCatalog) throw;
    }
    return 0;
}
