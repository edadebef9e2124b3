#include "stepmill/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drawing/chain.h"
#include "drawing/prism_solid.h"
#include "drawing/sketch.h"
#include "drawing/spline_points.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {
namespace {

using drawing::Healing;
using drawing::Pocketing;
using drawing::Profile;
using drawing::ProfileArea;
using drawing::Sketch;
using drawing::Stroke;

std::string ending(const std::filesystem::path& file) {
    std::string text = file.extension().string();
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

double mmOf(const std::string& unit) {
    if (unit == "mm") return 1;
    if (unit == "cm") return 10;
    if (unit == "m") return 1000;
    return kMillimetresPerInch;
}

/// Makes the part step by step; each step takes what the one before gave.
class DrawnPart {
  public:
    DrawnPart(Sketch sketch, const std::string& file, const DrawingOptions& options)
        : sketch_(std::move(sketch)), file_(file), options_(options) {}

    Part part() {
        requireOptions();
        scale();
        const std::vector<ProfileArea> outline = areasOf(options_.outline);
        if (outline.size() != 1)
            drawing::refuse(file_, fmt::format("layer '{}'", options_.outline),
                            fmt::format("expected one outer profile of the part, found {}", outline.size()));
        std::vector<Pocketing> pocketings;
        for (const auto& [key, depth] : options_.depths)
            pocketings.push_back({areasOf(key), depth * mm_per_unit_});
        requireInside(outline.front(), pocketings);
        Part part =
            makePart(drawing::prismSolid(outline, options_.thickness * mm_per_unit_, pocketings, file_),
                     std::filesystem::path(file_).stem().string());
        requireSize(part);
        part.remarks = remarks();
        return part;
    }

  private:
    /// Sizes as readStep() takes them [mm].
    static constexpr double kLargestMm = 100000;
    static constexpr double kSmallestMm = 0.1;

    [[noreturn]] static void missing(const char* option, const std::string& what) {
        throw Error(ErrorCode::Usage, option, what);
    }

    void requireOptions() const {
        if (options_.unit.empty() && sketch_.mm_per_unit == 0)
            missing("--unit", fmt::format("expected mm, cm, m or inch: {} does not say its unit", file_));
        if (options_.outline.empty())
            missing("--outline", fmt::format("expected the layer of the part's outer profile; {} has {}",
                                             file_, layersText()));
        if (!(options_.thickness > 0) || !std::isfinite(options_.thickness))
            missing("--thickness", "expected how thick the part is, above 0, in the drawing's unit");
        for (const auto& [key, depth] : options_.depths)
            if (!(depth > 0) || !std::isfinite(depth))
                missing("--depth", fmt::format("expected a depth above 0 for '{}', found {:g}", key, depth));
        if (options_.depths.contains(options_.outline))
            missing("--depth", fmt::format("expected no depth for the outline '{}'", options_.outline));
    }

    std::string layersText() const {
        std::set<std::string> names;
        for (const Stroke& stroke : sketch_.strokes) {
            names.insert("'" + stroke.layer + "'");
            if (!stroke.colour.empty()) names.insert(stroke.colour);
        }
        return names.empty() ? "no lines or arcs" : fmt::format("{}", fmt::join(names, ", "));
    }

    void scale() {
        mm_per_unit_ = options_.unit.empty() ? sketch_.mm_per_unit : mmOf(options_.unit);
        for (Stroke& stroke : sketch_.strokes) {
            stroke.from *= mm_per_unit_;
            stroke.to *= mm_per_unit_;
            stroke.circle_radius *= mm_per_unit_;
            if (!stroke.spline) continue;
            auto spline = std::make_shared<drawing::Spline>(*stroke.spline);
            for (Vec2& pole : spline->poles)
                pole *= mm_per_unit_;
            stroke.spline = std::move(spline);
        }
        std::vector<Stroke> strokes;
        guardOcct(ErrorCode::InvalidCatalog, file_ + ", splines", [&] {
            for (const Stroke& stroke : sketch_.strokes)
                for (Stroke& span : drawing::spansOf(stroke))
                    strokes.push_back(std::move(span));
        });
        if (strokes.size() > drawing::kMostStrokes)
            drawing::refuse(file_, "splines",
                            fmt::format("expected at most {} lines, arcs and spans", drawing::kMostStrokes));
        sketch_.strokes = std::move(strokes);
    }

    /// The profiles of a layer or colour as areas: every second of nested ones is left out.
    std::vector<ProfileArea> areasOf(const std::string& key) {
        if (const auto why = sketch_.refused.find(key); why != sketch_.refused.end())
            drawing::refuse(file_, fmt::format("layer '{}'", key), why->second);
        std::vector<Stroke> strokes;
        for (const Stroke& stroke : sketch_.strokes)
            if (stroke.layer == key || stroke.colour == key) strokes.push_back(stroke);
        if (strokes.empty())
            drawing::refuse(
                file_, fmt::format("layer '{}'", key),
                fmt::format("expected profiles on it, found none; the file has {}", layersText()));
        used_.insert(key);
        return nested(drawing::closedProfiles(std::move(strokes), file_, healing_), key);
    }

    std::vector<ProfileArea> nested(std::vector<Profile> profiles, const std::string& key) const {
        std::vector<int> depth(profiles.size(), 0);
        std::vector<int> parent(profiles.size(), -1);
        const auto areaOf = [&](std::size_t i) { return signedArea(profiles[i].shape); };
        for (std::size_t i = 0; i < profiles.size(); ++i)
            for (std::size_t j = 0; j < profiles.size(); ++j) {
                if (i == j || areaOf(j) <= areaOf(i) || !holds(profiles[j], profiles[i])) continue;
                ++depth[i];
                const bool closer = parent[i] < 0 || areaOf(j) < areaOf(static_cast<std::size_t>(parent[i]));
                if (closer) parent[i] = static_cast<int>(j);
            }
        requireSound(profiles, depth, key);
        std::map<std::size_t, std::size_t> area_at;
        std::vector<ProfileArea> areas;
        for (std::size_t i = 0; i < profiles.size(); ++i)
            if (depth[i] % 2 == 0) {
                area_at[i] = areas.size();
                areas.push_back({profiles[i], {}});
            }
        for (std::size_t i = 0; i < profiles.size(); ++i)
            if (depth[i] % 2 != 0)
                areas[area_at.at(static_cast<std::size_t>(parent[i]))].holes.push_back(profiles[i]);
        return areas;
    }

    static bool holds(const Profile& outer, const Profile& inner) {
        return boundingBox(outer.shape).contains(inner.shape.start) &&
               contains(Region{{outer.shape}}, inner.shape.start);
    }

    /// No profile crosses itself or another of its layer.
    void requireSound(const std::vector<Profile>& profiles, const std::vector<int>& depth,
                      const std::string& key) const {
        Region region;
        for (std::size_t i = 0; i < profiles.size(); ++i)
            region.loops.push_back(depth[i] % 2 == 0 ? profiles[i].shape : reversed(profiles[i].shape));
        if (const auto trouble = diagnose(region))
            drawing::refuse(
                file_, fmt::format("layer '{}'", key),
                fmt::format("expected profiles that cross neither themselves nor each other: {} mm",
                            *trouble));
    }

    /// A profile that begins outside the outline cuts nothing there: likelier a slip than meant.
    void requireInside(const ProfileArea& outline, const std::vector<Pocketing>& pocketings) const {
        const Region block{{outline.outer.shape}};
        for (const Pocketing& pocketing : pocketings)
            for (const ProfileArea& area : pocketing.areas) {
                const std::vector<Vec2> points = tessellate(area.outer.shape, 0.1);
                if (std::none_of(points.begin(), points.end(),
                                 [&](const Vec2& p) { return contains(block, p); }))
                    drawing::refuse(file_,
                                    fmt::format("layer '{}', {}", area.outer.strokes.front().layer,
                                                area.outer.strokes.front().place),
                                    "expected a profile that lies inside the outline, at least in part");
            }
    }

    void requireSize(const Part& part) const {
        const Vec3 size = part.bbox_mm.sizes();
        if (size.maxCoeff() <= kLargestMm && size.minCoeff() >= kSmallestMm) return;
        throw Error(
            ErrorCode::ImplausibleSize, file_,
            fmt::format("expected a part of {:g} to {:g} mm, found {:.4g} x {:.4g} x {:.4g} mm; --unit "
                        "says what the drawing's unit is",
                        kSmallestMm, kLargestMm, size.x(), size.y(), size.z()));
    }

    std::vector<Remark> remarks() const {
        std::vector<Remark> remarks;
        if (healing_.gaps > 0)
            remarks.push_back(
                {kForTheRecord, fmt::format("{} gaps of its profiles were closed, the widest {:.3g} mm",
                                            healing_.gaps, healing_.widest_mm)});
        std::set<std::string> unused;
        for (const Stroke& stroke : sketch_.strokes)
            if (!used_.contains(stroke.layer) && !used_.contains(stroke.colour)) unused.insert(stroke.layer);
        if (!unused.empty())
            remarks.push_back(
                {kForTheRecord, fmt::format("layers left aside, as no depth is told for them: {}",
                                            fmt::join(unused, ", "))});
        std::vector<std::string> aside;
        for (const auto& [what, count] : sketch_.left_aside)
            aside.push_back(fmt::format("{} {}", count, what));
        if (!aside.empty())
            remarks.push_back(
                {kForTheRecord, fmt::format("no profiles, left aside: {}", fmt::join(aside, ", "))});
        return remarks;
    }

    Sketch sketch_;
    const std::string& file_;
    const DrawingOptions& options_;
    double mm_per_unit_ = 1;
    std::set<std::string> used_;
    Healing healing_;
};

struct Format {
    const char* name;
    Sketch (*read)(std::string_view text, const std::string& file);
};

const Format& formatOf(const std::string& name) {
    static const std::map<std::string, Format> formats{{".dxf", {"DXF", drawing::readDxf}},
                                                       {".svg", {"SVG", drawing::readSvg}},
                                                       {".step", {"STEP curves", drawing::readStepCurves}},
                                                       {".stp", {"STEP curves", drawing::readStepCurves}}};
    const auto found = formats.find(ending(name));
    if (found == formats.end())
        drawing::refuse(name, "its name", "expected a drawing: .dxf, .svg, or .step or .stp with curves");
    return found->second;
}

}  // namespace

bool isDrawing(const std::filesystem::path& file) {
    return ending(file) == ".dxf" || ending(file) == ".svg";
}

Part drawingFromText(std::string_view text, const std::string& name, const DrawingOptions& options) {
    const Format& format = formatOf(name);
    Part part = DrawnPart(format.read(text, name), name, options).part();
    part.file = name;
    part.sha256 = sha256(text);
    part.schema = format.name;
    if (!options.unit.empty()) part.unit_in_file = options.unit;
    return part;
}

Part readDrawing(const std::filesystem::path& file, const DrawingOptions& options) {
    return drawingFromText(readFile(file, options.max_file_bytes), file.filename().string(), options);
}

}  // namespace stepmill
