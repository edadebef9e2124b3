#include "stepmill/part/part.h"

#include <fmt/format.h>

#include "part/measure.h"
#include "part/step/elementary_solid.h"
#include "part/step/heal.h"
#include "part/step/import.h"
#include "part/step/text.h"
#include "stepmill/core/file.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"
#include "stepmill/part/step_curves.h"

namespace stepmill {
namespace {

/// Longer than the travel of common machining centres, shorter than what a cutter can follow: taken, but
/// a wrong unit is likelier than such a part.
constexpr double kDoubtfulLarge_mm = 3000;
constexpr double kDoubtfulSmall_mm = 2;

std::string lower(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Short name of a length unit as STEP files spell it; the spelling itself if unknown.
std::string shortUnit(const std::string& name) {
    static const std::map<std::string, std::string> kNames = {
        {"millimetre", "mm"}, {"millimeter", "mm"}, {"mm", "mm"},   {"centimetre", "cm"},
        {"centimeter", "cm"}, {"cm", "cm"},         {"metre", "m"}, {"meter", "m"},
        {"m", "m"},           {"inch", "inch"},     {"in", "inch"}, {"inches", "inch"},
        {"foot", "foot"},     {"feet", "foot"},     {"ft", "foot"}, {"micrometre", "um"},
        {"micron", "um"}};
    const auto found = kNames.find(lower(name));
    return found == kNames.end() ? name : found->second;
}

std::optional<double> mmPerUnit(const std::string& unit) {
    if (unit == "mm") return 1.0;
    if (unit == "cm") return 10.0;
    if (unit == "m") return 1000.0;
    if (unit == "um") return 1e-3;
    if (unit == "inch") return kMillimetresPerInch;
    if (unit == "foot") return 12 * kMillimetresPerInch;
    return std::nullopt;
}

/// Factor that turns the reader's millimetres into those of the unit the user says.
double overrideFactor(const std::string& unit, const std::vector<std::string>& in_file,
                      const std::string& file) {
    if (unit.empty()) return 1;
    const std::optional<double> wanted = mmPerUnit(shortUnit(unit));
    if (!wanted)
        throw Error(ErrorCode::Usage, "--unit",
                    "\"" + unit + "\" is no length unit; mm, cm, m or inch expected");
    if (in_file.empty()) return *wanted;  // the reader took the numbers as millimetres
    if (in_file.size() > 1)
        throw Error(ErrorCode::Usage, "--unit",
                    file + " mixes several length units, which one override cannot replace");
    const std::optional<double> from = mmPerUnit(shortUnit(in_file[0]));
    if (!from)
        throw Error(
            ErrorCode::Usage, "--unit",
            "the unit \"" + in_file[0] + "\" in " + file + " is not known, so it cannot be overridden");
    return *wanted / *from;
}

std::string schemaName(const std::vector<std::string>& schemas) {
    if (schemas.empty()) return "none";
    const std::string& text = schemas.front();
    const auto has = [&](std::string_view what) { return text.find(what) != std::string::npos; };
    if (has("AP242") || has("MANAGED_MODEL_BASED_3D_ENGINEERING")) return "AP242";
    if (has("AUTOMOTIVE_DESIGN")) return "AP214";
    if (has("CONFIG_CONTROL_DESIGN") || has("CONFIGURATION_CONTROL") || has("AP203")) return "AP203";
    return text.substr(0, text.find_first_of(" {"));
}

[[noreturn]] void refuseWithoutSolid(const StepText& text, const StepImport& import,
                                     const std::string& file) {
    const Strays& strays = import.strays;
    const bool nothing = strays.shells + strays.faces + strays.edges + strays.points == 0;
    if (nothing && !text.external_files.empty()) {
        std::string names;
        for (const std::string& name : text.external_files)
            names += (names.empty() ? "" : ", ") + name;
        throw Error(ErrorCode::NoSolid, file,
                    "an assembly that only refers to other files (" + names + "); plan those instead");
    }
    if (nothing) throw Error(ErrorCode::NoSolid, file, "no geometry came out of the file; a solid is needed");
    const std::string found =
        fmt::format("{} shells with {} faces and {} free edges, {} loose faces, {} loose edges",
                    strays.shells, strays.shell_faces, strays.shell_free_edges, strays.faces, strays.edges);
    if (text.solid_bodies > 0 && strays.shell_free_edges > 0)
        throw Error(ErrorCode::OpenShell, file, "the solid is not closed: " + found + "; faces are missing");
    throw Error(ErrorCode::NoSolid, file,
                "no solid, only " + found +
                    (strays.shell_faces + strays.faces == 0 && strays.edges > 0
                         ? "; curves of profiles are a part with --outline, --thickness and --depth"
                         : "; knit the surfaces into a solid and export again"));
}

std::string plural(int count, const std::string& one) {
    return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

/// Annotations are wires, points and open shells the file itself keeps apart; other shells and faces may be
/// what became of a solid.
void remarkStrays(const Strays& strays, int open_shells, std::vector<Remark>& remarks) {
    std::string list;
    const auto add = [&](int count, const std::string& one) {
        if (count > 0) list += (list.empty() ? "" : ", ") + plural(count, one);
    };
    add(strays.shells, "free shell");
    add(strays.faces, "free face");
    add(strays.edges, "wire edge");
    add(strays.points, "point");
    const bool doubtful = strays.shells > open_shells || strays.faces > 0;
    if (!list.empty())
        remarks.push_back({doubtful ? kInputDoubt : kForTheRecord, "ignored beside the solids: " + list});
}

std::vector<Remark> fileRemarks(const StepText& text, const StepImport& import, const ReadOptions& options) {
    std::vector<Remark> remarks;
    for (const std::string& remark : text.remarks)
        remarks.push_back({kForTheRecord, remark});
    for (const std::string& doubt : text.doubts)
        remarks.push_back({kInputDoubt, doubt});
    remarkStrays(import.strays, text.open_shells, remarks);
    if (import.units.empty() && options.unit.empty())
        remarks.push_back(
            {kUnitDoubt,
             "the file names no length unit; millimetre assumed, --unit inch if inches were meant"});
    if (import.units.size() > 1)
        remarks.push_back({kForTheRecord, "the file mixes length units; each shape is converted by its own"});
    if (const std::string schema = schemaName(text.schemas); !schema.starts_with("AP"))
        remarks.push_back({kInputDoubt, fmt::format("unknown schema {}; read as AP214", schema)});
    return remarks;
}

void checkSize(Part& part, const ReadOptions& options, const std::string& subject) {
    const Vec3 size = part.bbox_mm.sizes();
    const std::string shown = fmt::format("{:.4g} x {:.4g} x {:.4g} mm", size.x(), size.y(), size.z());
    if (size.maxCoeff() > options.largest_mm)
        throw Error(ErrorCode::ImplausibleSize, subject,
                    fmt::format("{} is larger than any mill ({:g} mm); if the unit {} is wrong, give --unit",
                                shown, options.largest_mm, part.unit_in_file));
    if (size.minCoeff() < options.smallest_mm)
        throw Error(
            ErrorCode::ImplausibleSize, subject,
            fmt::format(
                "{} is smaller than any cutter can make ({:g} mm); if the unit {} is wrong, give --unit",
                shown, options.smallest_mm, part.unit_in_file));
    const bool large = size.maxCoeff() > kDoubtfulLarge_mm;
    if (!large && size.maxCoeff() > kDoubtfulSmall_mm) return;
    part.remarks.push_back(
        {kUnitDoubt,
         fmt::format("doubtful size: unit {} makes the part {}; --unit {} if {} were meant",
                     part.unit_in_file, shown, large ? "mm" : "inch", large ? "millimetres" : "inches")});
}

void checkFit(Part& part, ImportReport& report, const std::string& subject) {
    const double limit_mm = largestGap(part.bbox_mm);
    const double doubtful_mm = doubtfulGap(part.bbox_mm);
    const Misfit misfit = measureMisfit(part.shape->solid, std::min(limit_mm, doubtful_mm), limit_mm);
    report.vertex_gap_mm = misfit.vertex_mm;
    report.edge_gap_mm = misfit.edge_mm;
    if (misfit.vertices_off + misfit.edges_off == 0) {
        if (std::max(misfit.vertex_mm, misfit.edge_mm) > doubtful_mm)
            part.remarks.push_back(
                {kInputDoubt,
                 fmt::format("vertices lie up to {:.3g} mm off their edges, edges up to {:.3g} mm off "
                             "their faces; the worst starts at ({:.3f}, {:.3f}, {:.3f})",
                             misfit.vertex_mm, misfit.edge_mm, misfit.where.x(), misfit.where.y(),
                             misfit.where.z())});
        return;
    }
    throw Error(
        ErrorCode::InvalidSolid, subject,
        fmt::format("the geometry does not fit together: {} edges end up to {:.3g} mm away from their "
                    "vertices, {} edges leave their faces by up to {:.3g} mm (allowed {:.3g}); the worst "
                    "starts at ({:.3f}, {:.3f}, {:.3f})",
                    misfit.vertices_off, misfit.vertex_mm, misfit.edges_off, misfit.edge_mm, limit_mm,
                    misfit.where.x(), misfit.where.y(), misfit.where.z()));
}

const BodyAccount* accountOf(const ImportedSolid& solid, const StepImport& import) {
    for (const BodyAccount& body : import.bodies)
        if (!body.shape.IsNull() && body.shape.IsPartner(solid.shape)) return &body;
    return nullptr;
}

/// First of a list and how many follow.
std::string firstOf(const std::vector<std::string>& list) {
    return list.front() + (list.size() > 1 ? fmt::format(" and {} more", list.size() - 1) : "");
}

/// Every solid entity of the file is one solid with all its faces and edges, and nothing else is a solid.
void requireWhole(const StepImport& import, const std::string& file) {
    for (const BodyAccount& body : import.bodies)
        if (!body.losses.empty())
            throw Error(ErrorCode::InvalidSolid, file,
                        "the geometry reader cannot build the solid of the file: " + firstOf(body.losses));
    for (const ImportedSolid& solid : import.solids)
        if (!accountOf(solid, import))
            throw Error(ErrorCode::InvalidSolid, file,
                        "the geometry reader made a solid that no entity of the file describes");
}

ImportedShape shapeOf(const TopoDS_Shape& shape, double volume_mm3) {
    return {countShapes(shape, TopAbs_FACE), countEdges(shape), volume_mm3, areaOf(shape)};
}

ImportReport reportOf(const StepText& text, const StepImport& import, const BodyAccount& account) {
    ImportReport report;
    report.kinds = text.kinds;
    report.units = import.units;
    for (const StepBody& body : text.bodies)
        if (static_cast<int>(body.id) == account.id) {
            report.entity = body.name;
            report.shells_in_file = body.shells;
            report.faces_in_file = body.faces;
            report.edges_in_file = body.edges;
        }
    const Strays& strays = import.strays;
    report.strays = {strays.shells, strays.faces, strays.edges, strays.points};
    return report;
}

Part finishSolid(const ImportedSolid& solid, const Part& common, double factor, ShapeNames& names,
                 const ReadOptions& options, ImportReport report, const std::string& subject) {
    Part part = common;
    part.count = solid.count;
    part.name = solid.name.empty() ? std::filesystem::path(common.file).stem().string() : solid.name;
    guardOcct(ErrorCode::InvalidSolid, subject, [&] {
        const HealedSolid healed = healSolid(solid.shape, subject, names, part.remarks);
        TopoDS_Shape shape = withElementarySurfaces(healed, names, part.remarks);
        if (factor != 1) shape = scaleSolid(shape, factor, names);
        describeShape(part, shape);
        report.healed = shapeOf(healed.shape, healed.volume_mm3);
        const bool untouched = healed.shape.IsEqual(solid.shape);
        report.built = untouched ? report.healed : shapeOf(solid.shape, volumeOf(solid.shape));
        const std::vector<TopoDS_Face> faces = facesOf(shape);
        for (PartFace& face : part.faces)
            face.step_name = names.of(faces[static_cast<std::size_t>(face.index)]);
        checkFit(part, report, subject);
        checkSize(part, options, subject);
    });
    part.import = std::make_shared<const ImportReport>(std::move(report));
    return part;
}

}  // namespace

StepCurves stepCurvesFromText(std::string_view text, const std::string& file) {
    screenStep(text, file);
    StepImport import = importStep(withoutByteOrderMark(text), file);
    const int faces = import.strays.shell_faces + import.strays.faces;
    if (!import.solids.empty() || faces > 0)
        throw Error(
            ErrorCode::NoSolid, file,
            fmt::format("expected the curves of profiles alone, found {} and {}: a part of solids takes "
                        "neither an outline nor depths",
                        plural(static_cast<int>(import.solids.size()), "solid"),
                        plural(faces, "loose face")));
    if (import.curves.empty())
        throw Error(ErrorCode::NoSolid, file, "expected the curves of profiles, found none");
    if (import.units.size() > 1)
        throw Error(ErrorCode::StepDamaged, file, "expected one length unit for all profiles, found several");
    StepCurves curves{std::move(import.curves), 0};
    if (import.units.empty()) return curves;
    const std::optional<double> mm_per_unit = mmPerUnit(shortUnit(import.units.front()));
    if (!mm_per_unit)
        throw Error(ErrorCode::StepDamaged, file,
                    "expected a length unit that drawings have, found \"" + import.units.front() + "\"");
    curves.mm_per_unit = *mm_per_unit;
    return curves;
}

std::vector<Part> readStep(const std::filesystem::path& path, const ReadOptions& options) {
    const std::string bytes = readFile(path, options.max_file_bytes);
    const std::string file = path.filename().string();
    const StepText text = screenStep(bytes, file);
    StepImport import = importStep(withoutByteOrderMark(bytes), file);
    if (import.solids.empty()) refuseWithoutSolid(text, import, file);
    requireWhole(import, file);

    const int solids = static_cast<int>(import.solids.size());
    if (options.solid >= solids || options.solid < -1)
        throw Error(ErrorCode::Usage, "--solid",
                    fmt::format("{} has {}, numbered from 0; {} is none of them", file,
                                plural(solids, "distinct solid"), options.solid));
    const double factor = overrideFactor(options.unit, import.units, file);
    Part common;
    common.file = file;
    common.sha256 = sha256(bytes);
    common.schema = schemaName(text.schemas);
    common.unit_in_file = import.units.empty() ? "none" : shortUnit(import.units.front());
    common.remarks = fileRemarks(text, import, options);
    if (factor != 1)
        common.remarks.push_back({kForTheRecord, fmt::format("unit {} overridden with {}",
                                                             common.unit_in_file, shortUnit(options.unit))});

    std::vector<Part> parts;
    for (int i = 0; i < solids; ++i) {
        if (options.solid >= 0 && i != options.solid) continue;
        const std::string subject = solids == 1 ? file : fmt::format("{} solid {}", file, i);
        common.solid_index = i;
        const ImportedSolid& solid = import.solids[static_cast<std::size_t>(i)];
        const BodyAccount& account = *accountOf(solid, import);
        parts.push_back(finishSolid(solid, common, factor, import.face_names, options,
                                    reportOf(text, import, account), subject));
        if (!account.turned.empty())
            parts.back().remarks.push_back(
                {kInputDoubt, "the geometry reader turned over " + firstOf(account.turned) +
                                  ": they look to the other side than the file says"});
    }
    return parts;
}

}  // namespace stepmill
