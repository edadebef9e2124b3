// The isometric pictures of a setup sheet.

#include "report/sheets/setup_pictures.h"

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "report/sheets/flip.h"
#include "report/sheets/scene_raster.h"
#include "report/sheets/traced_lines.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/plan/removed.h"

namespace stepmill::report {
namespace {

/// Along the longer side of a picture: about ten to a millimetre of paper.
constexpr int kCells = 800;
/// Room for words around a picture [cells].
constexpr int kMargin = 46;
/// Chords and facets as a share of the stock's diagonal, and their finest [mm].
constexpr double kChordShare = 3e-5;
constexpr double kFinestChordMm = 0.003;
/// As shares of the stock's diagonal: how far around the stock fixtures are shown, the empty rim of a
/// picture, length of the work offset's axes, and from where to where over the stock the tool's arrow goes.
constexpr double kFixturesShown = 0.16;
constexpr double kRim = 0.01;
constexpr double kAxisShare = 0.17;
constexpr double kArrowFrom = 0.24;
constexpr double kArrowTo = 0.06;
/// A surface faces the left where its normal is nearer to it than this [cos].
constexpr double kFacesLeft = 0.75;

Vec3 towardsViewer() {
    return {-1, -1, 1};
}
Vec3 toTheRight() {
    return {1, -1, 0};
}

Prism prismOf(const Fixture& fixture) {
    return {fixture.section, fixture.top_z_mm, fixture.bottom_z_mm};
}

/// How thick parallels are drawn [mm].
constexpr double kParallelThicknessMm = 8;

/// Where the stock ends along a direction, by its box.
double endAlong(const Setup& setup, const Vec2& direction) {
    double end_mm = -1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at = setup.stock_bbox_mm.corner(static_cast<Box3::CornerType>(corner));
        end_mm = std::max(end_mm, direction.dot(at.head<2>()));
    }
    return end_mm;
}

/// A pair of parallels under the stock, each along a jaw.
std::vector<Prism> parallelsOf(const PlannedSetup& planned) {
    const Setup& setup = planned.setup;
    const Vec2 across = planned.clamping.across.head<2>();
    const Vec2 along(-across.y(), across.x());
    const double to_mm = endAlong(setup, along);
    const double from_mm = -endAlong(setup, -along);
    const double top_mm = setup.stock_bbox_mm.min().z();
    std::vector<Prism> pair;
    for (const Vec2& out : {across, Vec2(-across)}) {
        const double face_mm = endAlong(setup, out);
        const Vec2 outer = face_mm * out;
        const Vec2 inner = (face_mm - kParallelThicknessMm) * out;
        pair.push_back({makePolygon({outer + from_mm * along, outer + to_mm * along, inner + to_mm * along,
                                     inner + from_mm * along}),
                        top_mm, top_mm - planned.clamping.parallels_mm});
    }
    return pair;
}

/// What the stock rests on; it lies below all that is proven, so that it is no fixture of the plan's.
std::vector<Prism> restsOf(const PlannedSetup& planned, double plate_mm) {
    const Clamping& held = planned.clamping;
    if (held.kind == HoldKind::Vise)
        return held.parallels_mm > 0 ? parallelsOf(planned) : std::vector<Prism>{};
    if (!held.isOnPlate()) return {};
    const Box3& stock = planned.setup.stock_bbox_mm;
    const Vec2 rim = Vec2::Constant(plate_mm);
    return {{makeRectangle(snapToGrid(Vec2(stock.min().head<2>() - rim)),
                           snapToGrid(Vec2(stock.max().head<2>() + rim))),
             stock.min().z(), stock.min().z() - plate_mm}};
}

/// What stands beside and under the stock. Held stock is drawn as stock.
std::vector<Prism> holdersOf(const PlannedSetup& planned, double plate_mm) {
    std::vector<Prism> holders = restsOf(planned, plate_mm);
    for (const Fixture& fixture : planned.setup.fixtures)
        if (fixture.kind != FixtureKind::HeldStock) holders.push_back(prismOf(fixture));
    return holders;
}

std::vector<Body> bodiesOf(const PlannedSetup& planned, double plate_mm, const Tolerances& tol) {
    const Setup& setup = planned.setup;
    const double chord_mm = std::max(kFinestChordMm, kChordShare * setup.stock_bbox_mm.diagonal().norm());
    const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
    std::vector<Body> bodies = arrivingStock(setup, chord_mm);
    for (const Prism& prism : removedBy(planned.features, tol))
        bodies.push_back(prismBody(BodyKind::CutHere, prism, here, chord_mm));
    for (const Prism& holder : holdersOf(planned, plate_mm))
        bodies.push_back(prismBody(BodyKind::Fixture, holder, here, chord_mm));
    return bodies;
}

/// The stock, what of the fixtures stands near to it, and the tool's arrow.
Box3 shownBox(const PlannedSetup& planned, double plate_mm) {
    const Setup& setup = planned.setup;
    const Box3& stock = setup.stock_bbox_mm;
    const Vec3 near = Vec3::Constant(kFixturesShown * stock.diagonal().norm());
    const Box3 around(stock.min() - near, stock.max() + near);
    // The outline is drawn between cells of the stock and empty ones.
    const Vec3 rim = Vec3::Constant(kRim * stock.diagonal().norm());
    Box3 shown(stock.min() - rim, stock.max() + rim);
    for (const Prism& prism : holdersOf(planned, plate_mm)) {
        const Box2 flat = boundingBox(prism.region);
        const Box3 block(Vec3(flat.min().x(), flat.min().y(), prism.bottom_z_mm),
                         Vec3(flat.max().x(), flat.max().y(), prism.top_z_mm));
        if (block.intersects(around)) shown.extend(block.intersection(around));
    }
    return shown;
}

Element path(const char* css_class, std::string data) {
    return Element("path").with("class", css_class).with("d", std::move(data));
}

Element words(const char* css_class, const Vec2& at, const std::string& text) {
    return Element("text", text)
        .with("class", css_class)
        .with("x", fmt::format("{:.1f}", at.x()))
        .with("y", fmt::format("{:.1f}", at.y()));
}

/// A straight arrow between two places of the picture.
Element arrow(const char* css_class, const Vec2& from, const Vec2& to) {
    constexpr double kHead = 18;
    constexpr double kHalfWidth = 7;
    const Vec2 along = (to - from).normalized();
    const Vec2 neck = to - kHead * along;
    const Vec2 side = kHalfWidth * leftOf(along);
    return path(css_class,
                fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z",
                            from.x(), from.y(), neck.x(), neck.y(), to.x(), to.y(), (neck + side).x(),
                            (neck + side).y(), (neck - side).x(), (neck - side).y()));
}

/// The stock's own look: shades and lines.
void drawImage(Element& svg, const Image& image, const Sight& sight) {
    const Vec3 left = sight.turned(-Vec3::UnitX());
    std::vector<bool> faces_left;  // by surface
    for (const Vec3& normal : image.normals)
        faces_left.push_back(normal.dot(left) > kFacesLeft);
    const auto area = [&](const char* css_class, auto is_in) {
        return path(css_class, areaOf(image, cellsWhere(image, is_in)));
    };
    svg.add(area("left",
                 [&](const SeenCell& cell) {
                     return cell.what != Shown::Nothing && faces_left[static_cast<std::size_t>(cell.surface)];
                 }),
            area("jaw", [](const SeenCell& cell) { return cell.what == Shown::Fixture; }),
            area("here", [](const SeenCell& cell) { return cell.what == Shown::CutHere; }));
    Strokes strokes = strokesOf(image, sight.cell_mm());
    svg.add(path("around", std::move(strokes.cuts)), path("holds", std::move(strokes.fixtures)),
            path("edge", std::move(strokes.edges)));
}

Vec2 flat(const Sight& sight, const Vec3& p) {
    return sight.seen(p).head<2>();
}

/// X, Y and Z at the work offset.
void drawTriad(Element& svg, const Sight& sight, double length_mm) {
    const Vec2 zero = flat(sight, Vec3::Zero());
    const char* const kNames[] = {"X", "Y", "Z"};
    for (int axis = 0; axis < 3; ++axis) {
        const Vec2 tip = flat(sight, length_mm * Vec3::Unit(axis));
        svg.add(arrow("axis", zero, tip));
        svg.add(words("axis-name", tip + 24 * (tip - zero).normalized() + Vec2(0, 9), kNames[axis]));
    }
    svg.add(Element("circle")
                .with("class", "zero")
                .with("cx", fmt::format("{:.1f}", zero.x()))
                .with("cy", fmt::format("{:.1f}", zero.y()))
                .with("r", "9"));
    svg.add(words("zero-name", zero + Vec2(0, 40), "G54"));
}

/// Over the middle of the stock's top.
/// \param share  of the stock's diagonal
Vec2 overTop(const Sight& sight, const Setup& setup, double share) {
    const Box3& stock = setup.stock_bbox_mm;
    const Vec3 top(stock.center().x(), stock.center().y(), stock.max().z());
    return flat(sight, top + share * stock.diagonal().norm() * Vec3::UnitZ());
}

void drawToolAxis(Element& svg, const Sight& sight, const Setup& setup) {
    const Vec2 from = overTop(sight, setup, kArrowFrom);
    svg.add(arrow("tool", from, overTop(sight, setup, kArrowTo)));
    svg.add(words("tool-name", from + Vec2(14, 20), "tool, part's " + axisName(setup.axis)));
}

/// "was down in S1" on the side that was, where the picture shows it.
void drawWasDown(Element& svg, const Sight& sight, const Setup& before, const Setup& now) {
    const Vec3 was_down =
        now.part_to_setup.linear() * (before.part_to_setup.linear().transpose() * -Vec3::UnitZ());
    if (sideWords(was_down).empty() || was_down.dot(towardsViewer()) <= 0) return;
    const Box3& stock = now.stock_bbox_mm;
    const Vec3 at = stock.center() + was_down.cwiseProduct(stock.sizes()) / 2;
    svg.add(words("was", flat(sight, at) + Vec2(0, 9), "was down in " + before.id));
}

/// \param top  the highest place with anything to show, in cells
Element picture(const Image& image, const Sight& sight, double top, const std::string& label) {
    const int upper = static_cast<int>(std::floor(std::min(0.0, top))) - kMargin;
    Element svg = emptySvg("svg.sight",
                           fmt::format("{} {} {} {}", -kMargin, upper, sight.columns() + 2 * kMargin,
                                       sight.rows() + kMargin - upper),
                           label);
    drawImage(svg, image, sight);
    return svg;
}

SetupPictures draw(const PlannedSetup& planned, const Setup* before, double plate_mm, const Tolerances& tol) {
    const Setup& setup = planned.setup;
    const double diagonal_mm = setup.stock_bbox_mm.diagonal().norm();
    const Sight sight(towardsViewer(), toTheRight(), shownBox(planned, plate_mm), kCells);
    const double top = overTop(sight, setup, kArrowFrom).y();
    const StockImages images = stockImages(bodiesOf(planned, plate_mm, tol), sight);
    SetupPictures pictures{
        picture(images.arriving, sight, top, setup.id + " as it arrives, from above a corner"),
        picture(images.leaving, sight, top, setup.id + " when all is cut, from above a corner")};
    if (before != nullptr) drawWasDown(pictures.arriving, sight, *before, setup);
    drawToolAxis(pictures.arriving, sight, setup);
    drawTriad(pictures.arriving, sight, kAxisShare * diagonal_mm);
    return pictures;
}

}  // namespace

SetupPictures setupPictures(const PlannedSetup& setup, const Setup* before, double plate_mm,
                            const Tolerances& tol) {
    std::optional<SetupPictures> pictures;
    guardOcct(ErrorCode::GeometryKernel, "picture of " + setup.setup.id,
              [&] { pictures = draw(setup, before, plate_mm, tol); });
    return std::move(*pictures);
}

}  // namespace stepmill::report
