#include "options.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "output.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/layers/fixture_solids.h"
#include "stepmill/part/square_up.h"

namespace stepmill {

namespace {

/// Stock that stands over the part by more is a unit gone wrong [mm].
constexpr double kMostMarginMm = 1000;
/// Solids that are together less than this share of the largest are crumbs that came off it.
constexpr double kCrumbSolidsShare = 0.01;
/// What of a wrong value a message repeats.
constexpr std::size_t kLongestQuote = 40;

double parseLength(const std::string& text, const std::string& option) {
    std::size_t used = 0;
    double value = 0;
    try {
        value = std::stod(text, &used);
    } catch (const std::exception&) {
        used = std::string::npos;
    }
    if (used != text.size() || !(value >= 0 && value <= kMostMarginMm))
        throw Error(ErrorCode::Usage, option,
                    fmt::format("expected a length of 0 to {:g} mm, found '{}'", kMostMarginMm,
                                text.substr(0, kLongestQuote)));
    return value;
}

StockMargin parseMargin(const std::string& text) {
    std::vector<double> values;
    std::stringstream stream(text);
    for (std::string item; std::getline(stream, item, ',');)
        values.push_back(parseLength(item, "--stock-margin"));
    if (values.size() != 3)
        throw Error(ErrorCode::Usage, "--stock-margin",
                    fmt::format("expected three lengths side,top,bottom in mm, found '{}'",
                                text.substr(0, kLongestQuote)));
    return {values[0], values[1], values[2]};
}

Vec3 parseAxisOption(const std::string& text, const std::string& option) {
    const std::optional<Vec3> axis = parseAxis(text);
    if (!axis)
        throw Error(ErrorCode::Usage, option,
                    fmt::format("expected {}+x, -x, +y, -y, +z, -z or x,y,z; found '{}'",
                                option == "--setup" ? "auto, " : "", text));
    return *axis;
}

bool isBox(const std::string& stock) {
    return stock == "box" || stock == "auto";
}

double stockTolerance(const PlanOptions& options) {
    if (!options.stock_tolerance_mm) return isBox(options.stock) ? kSawnToleranceMm : 0;
    const double tolerance_mm = *options.stock_tolerance_mm;
    if (!(tolerance_mm >= 0 && tolerance_mm <= kMostStockToleranceMm))
        throw Error(ErrorCode::Usage, "--stock-tolerance",
                    fmt::format("expected 0 to {:g} mm, found {:g}", kMostStockToleranceMm, tolerance_mm));
    return tolerance_mm;
}

FixtureFile fixturesOf(const PlanOptions& options) {
    if (options.fixtures_file.empty()) return {};
    return readFixturesWithSolids(options.fixtures_file, options.limits.maxFileBytes(), Tolerances());
}

/// The margins that were asked for, or with `auto` what the shop saws, with stock for the vise below the
/// part.
void setMargins(const PlanOptions& options, SetupRequest& request) {
    if (options.stock_margin && !isBox(options.stock))
        throw Error(ErrorCode::Usage, "--stock-margin",
                    "has no meaning beside a stock file, which is as large as it is");
    if (options.stock_margin) request.margin = parseMargin(*options.stock_margin);
    if (options.stock != "auto") return;
    const FixtureFile shop = options.fixtures_file.empty()
                                 ? FixtureFile{}
                                 : readFixtures(options.fixtures_file, options.limits.maxFileBytes());
    request.stock_sizes_mm = shop.blank.sizes_mm;
    if (!options.stock_margin)
        request.margin = {shop.blank.side_mm, shop.blank.top_mm,
                          shop.vise.leastHoldMm().value_or(shop.vise.grip_mm) + shop.vise.jaw_clearance_mm +
                              kGripOverlapMm};
}

bool isNumber(const std::string& text) {
    return !text.empty() && text.size() < 6 && text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

void addStockOptions(CLI::App& command, PlanOptions& options) {
    command
        .add_option("--stock", options.stock,
                    "box; auto: a blank one can saw and hold, with stock for the vise below the part; or a "
                    "STEP file in the part's coordinates")
        ->capture_default_str();
    command.add_option("--stock-margin", options.stock_margin,
                       "side,top,bottom over the part's box [mm]; default: 0,0,0, of auto what the shop's "
                       "fixture file says");
    command
        .add_option("--stock-tolerance", options.stock_tolerance_mm,
                    "how much larger on every side the blank may be [mm]; default: 0.5 of a box, 0 of a file")
        ->type_name("MM");
    command
        .add_option("--setup", options.setups,
                    "tool axis: +z, -z, +x, -x, +y, -y or x,y,z; several in machining order; "
                    "auto (the default): as few as reach all")
        ->type_name("AXIS")
        ->allow_extra_args(false);
    command.add_option("--no-setup", options.no_setups, "tool axis never to be chosen; may be repeated")
        ->type_name("AXIS")
        ->allow_extra_args(false);
    command.add_option("--solid", options.solid, "which solid of a file with several: a number, or all");
    command.add_option("--unit", options.unit, "read lengths in this unit, whatever the file says")
        ->check(CLI::IsMember({"mm", "inch", "m", "cm"}));
    addDrawingOptions(command, options.drawing);
}

void addPartOptions(CLI::App& command, PlanOptions& options, const std::string& folder_suffix) {
    options.folder_suffix = folder_suffix;
    command
        .add_option("PART", options.part_file, "STEP file (AP203, AP214 or AP242), or a drawing (.dxf, .svg)")
        ->required();
    command.add_option("-o,--output", options.out_dir, "folder to write to; default: <part>" + folder_suffix);
    addStockOptions(command, options);
    command.add_option("--jobs", options.jobs, "threads; 0: one per core")->check(numberFrom(0, 1024, ""));
    addLimitOptions(command, options.limits);
}

void addImportOption(CLI::App& command, PlanOptions& options) {
    command.add_flag("--report-import", options.report_import,
                     "print what the file holds, what was read and healed of it and what was left out");
}

void reportImport(const std::vector<Part>& parts, const PlanOptions& options) {
    if (!options.report_import) return;
    for (const Part& part : parts)
        (options.json ? printErr : printOut)(importText(part) + "\n");
}

namespace {

/// The library's name for what --material asks for, which may be another that the materials know it by.
std::string materialIn(const Shop& shop, const PlanOptions& options) {
    const std::vector<std::string> known = shop.library.materials();
    std::vector<std::string> names{options.material};
    if (const Material* material = shop.materials.find(options.material)) {
        names.push_back(material->name);
        names.insert(names.end(), material->also_called.begin(), material->also_called.end());
    }
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) != known.end()) return name;
    throw Error(ErrorCode::Usage, "--material",
                fmt::format("no tool in {} has cutting data for '{}'; it knows {}", shop.library.file,
                            options.material, fmt::join(known, ", ")));
}

}  // namespace

Shop loadShop(const PlanOptions& options) {
    Shop shop;
    const std::uintmax_t max_bytes = options.limits.maxFileBytes();
    shop.library =
        options.tools_file.empty() ? defaultToolLibrary() : readToolLibrary(options.tools_file, max_bytes);
    shop.machine =
        options.machine_file.empty() ? defaultMachine() : readMachine(options.machine_file, max_bytes);
    shop.materials = options.materials_file.empty() ? defaultMaterials()
                                                    : readMaterials(options.materials_file, max_bytes);
    shop.material = materialIn(shop, options);
    return shop;
}

SetupRequest setupRequest(const PlanOptions& options) {
    SetupRequest request;
    const bool choose = options.setups.empty() || options.setups == std::vector<std::string>{"auto"};
    if (!choose)
        for (const std::string& text : options.setups)
            request.axes.push_back(parseAxisOption(text, "--setup"));
    for (const std::string& text : options.no_setups)
        request.forbidden.push_back(parseAxisOption(text, "--no-setup"));
    if (!request.axes.empty() && !request.forbidden.empty())
        throw Error(ErrorCode::Usage, "--no-setup", "has no meaning where --setup says every axis");
    setMargins(options, request);
    request.stock_tolerance_mm = stockTolerance(options);
    if (!isBox(options.stock)) {
        ReadOptions read;
        read.max_file_bytes = options.limits.maxFileBytes();
        std::vector<Part> stocks = readStep(options.stock, read);
        if (stocks.size() != 1)
            throw Error(ErrorCode::Usage, "--stock",
                        fmt::format("expected one solid in {}, found {}", options.stock, stocks.size()));
        request.stock_part = std::move(stocks.front());
    }
    return request;
}

namespace {

/// \throws Error(Usage) naming the option where it is neither none nor within the limits [mm]
double zeroOrWithin(double mm, double least_mm, double most_mm, const char* option) {
    if (mm == 0 || (mm >= least_mm && mm <= most_mm)) return mm;
    throw Error(ErrorCode::Usage, option,
                fmt::format("expected 0 or {:g} to {:g} mm, found {:g}", least_mm, most_mm, mm));
}

double allowance(double mm, const char* option) {
    return zeroOrWithin(mm, kLeastAllowanceMm, kMostAllowanceMm, option);
}

std::vector<Pattern> patternsFrom(const std::vector<std::string>& words) {
    std::vector<Pattern> patterns;
    for (const std::string& word : words) {
        const std::optional<Pattern> pattern = patternFrom(word);
        if (!pattern || *pattern == Pattern::Best)
            throw Error(ErrorCode::Usage, "--patterns",
                        fmt::format("expected names of patterns, found \"{}\"; --help lists them", word));
        patterns.push_back(*pattern);
    }
    return patterns;
}

/// What the material's cuts ask for, unless feeds are to be the library's or it is not known.
void setMaterial(const PlanOptions& options, const Shop& shop, PlanRequest& request) {
    if (options.library_feeds) return;
    request.materials_file = shop.materials.file;
    if (const Material* known = shop.materials.find(options.material)) request.sequence.cut_material = *known;
}

}  // namespace

PlanRequest planRequest(const PlanOptions& options, const Shop& shop) {
    PlanRequest request;
    request.unit = options.unit;
    request.setup = setupRequest(options);
    request.sequence.material = shop.material;
    request.sequence.objective = objectiveFrom(options.objective).value();
    request.sequence.surrogates = surrogateRuleFrom(options.surrogates).value();
    request.sequence.cost_model = costModelFrom(options.cost_model).value();
    request.sequence.patterns = patternsFrom(options.patterns);
    request.sequence.retract_mm = shop.machine.safe_height_mm;
    request.assign = options.reserve;
    request.fixtures = fixturesOf(options);
    if (options.hold != "auto") request.hold = holdKindFrom(options.hold).value();
    if (!options.holes_file.empty())
        request.holes = readHoleTable(options.holes_file, options.limits.maxFileBytes());
    request.sequence.finish = {allowance(options.finish_walls_mm, "--finish-walls"),
                               allowance(options.finish_floors_mm, "--finish-floors")};
    if (options.rough)
        request.roughing = {
            allowance(options.allowance_mm, "--allowance"),
            allowance(options.floor_allowance_mm.value_or(options.allowance_mm), "--floor-allowance")};
    request.quantity = options.quantity;
    request.scallop_mm = zeroOrWithin(options.scallop_mm, kLeastScallopMm, kMostScallopMm, "--scallop");
    request.break_edges_mm =
        zeroOrWithin(options.break_edges_mm, kLeastEdgeBreakMm, kMostEdgeBreakMm, "--break-edges");
    setMaterial(options, shop, request);
    return request;
}

namespace {

/// The one solid that the others are crumbs beside, such as islands of engraved letters that came loose;
/// nothing where several are parts. It says what was left out.
std::optional<Part> onlyRealPart(const std::vector<Part>& parts) {
    const auto largest = std::max_element(
        parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.volume_mm3 < b.volume_mm3; });
    double others_mm3 = -largest->volume_mm3;
    for (const Part& part : parts)
        others_mm3 += part.count * part.volume_mm3;
    if (others_mm3 >= kCrumbSolidsShare * largest->volume_mm3) return std::nullopt;
    Part only = *largest;
    only.remarks.push_back(
        {kInputDoubt,
         fmt::format("the file holds {} different solids; {} is planned, the others have {:.3g} mm3 "
                     "together, {:.2g} % of it: --solid chooses another",
                     parts.size(), only.name, others_mm3, 100 * others_mm3 / only.volume_mm3)});
    return only;
}

std::vector<Part> solidsToPlan(const PlanOptions& options) {
    if (isDrawn(options.part_file, options.drawing))
        return {
            readDrawnPart(options.part_file, options.drawing, options.unit, options.limits.maxFileBytes())};
    ReadOptions read;
    read.unit = options.unit;
    read.max_file_bytes = options.limits.maxFileBytes();
    const bool all = options.solid == "all";
    if (!all && !options.solid.empty() && !isNumber(options.solid))
        throw Error(ErrorCode::Usage, "--solid",
                    fmt::format("expected a number or all, found '{}'", options.solid));
    std::vector<Part> parts = readStep(options.part_file, read);
    if (all || (options.solid.empty() && parts.size() == 1)) return parts;

    if (options.solid.empty()) {
        if (auto only = onlyRealPart(parts)) return {std::move(*only)};
        std::string names;
        for (const Part& part : parts)
            names += fmt::format("\n  --solid {}: {} ({} times, {:.1f} x {:.1f} x {:.1f} mm)",
                                 part.solid_index, part.name, part.count, part.bbox_mm.sizes().x(),
                                 part.bbox_mm.sizes().y(), part.bbox_mm.sizes().z());
        throw Error(
            ErrorCode::Usage, options.part_file,
            fmt::format("holds {} different solids; choose one, or --solid all{}", parts.size(), names));
    }
    const int wanted = std::stoi(options.solid);
    for (Part& part : parts)
        if (part.solid_index == wanted) return {std::move(part)};
    throw Error(ErrorCode::Usage, "--solid",
                fmt::format("{} has solids 0 to {}, not {}", options.part_file, parts.size() - 1, wanted));
}

}  // namespace

std::vector<Part> chooseParts(const PlanOptions& options) {
    std::vector<Part> parts = solidsToPlan(options);
    for (Part& part : parts)
        part = squaredUp(std::move(part));
    return parts;
}

}  // namespace stepmill
