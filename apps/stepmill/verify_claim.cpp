#include "verify_claim.h"

#include <fmt/core.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/layers/fixture_solids.h"
#include "stepmill/part/square_up.h"
#include "stepmill/verify/claim.h"

namespace stepmill {

namespace {

/// The file of an option is the one that was planned with, byte by byte.
void requireSame(const char* option, const std::string& path, const RecordedFile& recorded,
                 std::uintmax_t max_bytes) {
    if (!recorded.sha256.empty() && sha256(readFile(path, max_bytes)) == recorded.sha256) return;
    throw Error(ErrorCode::Usage, fmt::format("{} {}", option, path),
                recorded.sha256.empty()
                    ? "the plan was made without such a file"
                    : "is not the file that was planned with: its SHA-256 differs from that of " +
                          recorded.file + " in plan.json");
}

/// Where the plan was made with such a file, it must be given.
void requireGiven(const char* option, const std::string& path, const RecordedFile& recorded,
                  std::uintmax_t max_bytes) {
    if (path.empty() && !recorded.sha256.empty())
        throw Error(ErrorCode::Usage, option, "the plan was made with " + recorded.file + ": give that file");
    if (!path.empty()) requireSame(option, path, recorded, max_bytes);
}

ToolLibrary libraryOf(const ClaimOptions& options, const PlanRecord& record, std::uintmax_t max_bytes) {
    if (options.tools_file.empty()) {
        ToolLibrary library = defaultToolLibrary();
        if (library.sha256 == record.library.sha256) return library;
    }
    requireGiven("--tools", options.tools_file, record.library, max_bytes);
    return readToolLibrary(options.tools_file, max_bytes);
}

/// \throws Error(Usage) where the plan was made for another machine than the built-in one and none is given
std::vector<ProofFailure> machineFailures(const ClaimOptions& options, const RecordedPlan& plan,
                                          std::uintmax_t max_bytes) {
    if (!options.machine_file.empty())
        return compareWithMachine(plan, readMachine(options.machine_file, max_bytes));
    const std::vector<ProofFailure> failures = compareWithMachine(plan, defaultMachine());
    if (failures.empty()) return {};
    throw Error(ErrorCode::Usage, "--machine",
                fmt::format("the plan was not made for the built-in machine: give its file ({} {})",
                            failures.front().operation, failures.front().text));
}

ReadOptions readOptions(int solid, const std::string& unit, std::uintmax_t max_bytes) {
    ReadOptions options;
    options.solid = solid;
    options.unit = unit;
    options.max_file_bytes = max_bytes;
    return options;
}

Part onlySolid(const std::string& path, const ReadOptions& options) {
    std::vector<Part> parts = readStep(path, options);
    if (parts.size() != 1)
        throw Error(ErrorCode::InvalidCatalog, "plan.json#/request/solid",
                    fmt::format("{} has no solid {}", path, options.solid));
    return std::move(parts.front());
}

/// What the plan claims of part, stock and fixtures, derived anew.
std::vector<ProofFailure> claimFailures(const ClaimOptions& options, const PlanRecord& record,
                                        const ToolLibrary& library, std::uintmax_t max_bytes,
                                        const Tolerances& tol) {
    requireSame("--part", options.part_file, {record.part_file, record.part_sha256}, max_bytes);
    const RecordedRequest request = record.request.value_or(RecordedRequest{});
    requireGiven("--stock", options.stock_file, request.stock, max_bytes);
    requireGiven("--fixtures", options.fixtures_file, request.fixtures, max_bytes);
    requireGiven("--holes", options.holes_file, request.holes, max_bytes);
    ClaimSources sources;
    sources.part =
        isDrawn(options.part_file, options.drawing)
            ? readDrawnPart(options.part_file, options.drawing, request.unit, max_bytes)
            : squaredUp(onlySolid(options.part_file, readOptions(request.solid, request.unit, max_bytes)));
    sources.library = library;
    if (!options.stock_file.empty())
        sources.stock = onlySolid(options.stock_file, readOptions(-1, "", max_bytes));
    if (!options.fixtures_file.empty())
        sources.fixtures = readFixturesWithSolids(options.fixtures_file, max_bytes, tol);
    if (!options.holes_file.empty()) sources.holes = readHoleTable(options.holes_file, max_bytes);
    return compareWithPart(record, sources, tol);
}

}  // namespace

void addClaimOptions(CLI::App& verify, ClaimOptions& options) {
    CLI::Option* const part = verify.add_option(
        "--part", options.part_file,
        "STEP file or drawing that was planned: the plan's setups and features are derived anew from it");
    verify.add_option("--tools", options.tools_file,
                      "tool library that was planned with: the plan's tools and cutting data are compared");
    verify.add_option(
        "--machine", options.machine_file,
        "machine file that was planned with; with --part or --tools, without it: the built-in one");
    verify
        .add_option("--stock", options.stock_file, "with --part: the stock's STEP file, where there is one")
        ->needs(part);
    verify
        .add_option("--fixtures", options.fixtures_file, "with --part: the fixture file, where there is one")
        ->needs(part);
    verify
        .add_option("--holes", options.holes_file,
                    "with --part: the hole table, where there is one; threads are derived anew from it")
        ->needs(part);
    addDrawingOptions(verify, options.drawing);
}

void verifyClaim(const ClaimOptions& options, const RecordedPlan& plan, std::uintmax_t max_bytes,
                 const Tolerances& tol, Verification& verification) {
    if (options.part_file.empty() && options.tools_file.empty() && options.machine_file.empty()) return;
    const auto add = [&](const std::vector<ProofFailure>& failures) {
        verification.failures.insert(verification.failures.end(), failures.begin(), failures.end());
    };
    add(machineFailures(options, plan, max_bytes));
    if (options.part_file.empty() && options.tools_file.empty()) return;
    const ToolLibrary library = libraryOf(options, plan.record, max_bytes);
    add(compareWithLibrary(plan.record, library));
    if (!options.part_file.empty()) add(claimFailures(options, plan.record, library, max_bytes, tol));
}

}  // namespace stepmill
