// DXF by dxflib.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include "drawing/sketch.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"

namespace stepmill::drawing {
namespace {

/// Turned extrusions mirror what they hold; less is rounding.
constexpr double kUpright = 1e-9;
/// Points of a spline beyond any that a drawing has.
constexpr std::size_t kMostPoles = 20000;

/// mm of DXF's $INSUNITS; 0 for "no unit" and for units nobody mills in.
double mmOfInsertUnits(int code) {
    switch (code) {
        case 1:
            return kMillimetresPerInch;
        case 2:
            return 12 * kMillimetresPerInch;
        case 4:
            return 1;
        case 5:
            return 10;
        case 6:
            return 1000;
        default:
            return 0;
    }
}

/// Takes what dxflib finds. Entities of blocks are no part of the drawing until it is inserted.
class DxfTaker : public DL_CreationAdapter {
  public:
    explicit DxfTaker(const std::string& file) : file_(file) {}

    Sketch sketch() && { return std::move(sketch_); }

    void setVariableInt(const std::string& key, int value, int /*code*/) override {
        if (key == "$INSUNITS") sketch_.mm_per_unit = mmOfInsertUnits(value);
    }

    void addBlock(const DL_BlockData& data) override {
        in_block_ = data.name != "*Model_Space" && data.name != "*MODEL_SPACE";
    }
    void endBlock() override { in_block_ = false; }

    void addLine(const DL_LineData& line) override {
        Stroke stroke;
        stroke.from = point(line.x1, line.y1);
        stroke.to = point(line.x2, line.y2);
        add(std::move(stroke));
    }

    void addArc(const DL_ArcData& arc) override {
        const Vec2 centre = point(arc.cx, arc.cy);
        const double radius = above0(arc.radius, "an arc's radius");
        double sweep_deg = std::fmod(number(arc.angle2) - number(arc.angle1), 360.0);
        if (sweep_deg <= 0) sweep_deg += 360;
        const auto at = [&](double deg) -> Vec2 {
            return centre + radius * Vec2(std::cos(degToRad(deg)), std::sin(degToRad(deg)));
        };
        Stroke stroke;
        stroke.from = at(arc.angle1);
        stroke.to = at(arc.angle2);
        stroke.bulge = std::tan(degToRad(sweep_deg) / 4);
        add(std::move(stroke));
    }

    void addCircle(const DL_CircleData& circle) override {
        Stroke stroke;
        stroke.from = stroke.to = point(circle.cx, circle.cy);
        stroke.circle_radius = above0(circle.radius, "a circle's radius");
        add(std::move(stroke));
    }

    void addEllipse(const DL_EllipseData& ellipse) override {
        const Vec2 centre = point(ellipse.cx, ellipse.cy);
        const Vec2 major = point(ellipse.mx, ellipse.my);
        const double ratio = above0(ellipse.ratio, "an ellipse's ratio");
        above0(major.norm(), "an ellipse's axis");
        double sweep = std::fmod(number(ellipse.angle2) - number(ellipse.angle1), 2 * kPi);
        if (sweep <= 1e-9) sweep += 2 * kPi;
        for (Stroke& stroke : ellipseArc(centre, major, ratio * leftOf(major), ellipse.angle1, sweep))
            add(std::move(stroke));
    }

    void addPolyline(const DL_PolylineData& polyline) override {
        constexpr int kClosed = 1;
        constexpr int kNoPlanarPolyline = 8 | 16 | 64;
        vertices_.clear();
        polyline_closed_ = (polyline.flags & kClosed) != 0;
        in_polyline_ = true;
        if ((polyline.flags & kNoPlanarPolyline) != 0) leaveAside("3D polyline");
    }
    void addVertex(const DL_VertexData& vertex) override {
        if (!in_polyline_) return;
        if (vertices_.size() > kMostStrokes) fail("expected a polyline, found one without end");
        vertices_.push_back({point(vertex.x, vertex.y), number(vertex.bulge)});
    }

    void addSpline(const DL_SplineData& spline) override {
        constexpr unsigned kMostDegree = 25;  // of the geometry kernel
        if (spline.degree < 1 || spline.degree > kMostDegree)
            fail(fmt::format("expected a spline's degree of 1 to {}, found {}", kMostDegree, spline.degree));
        spline_ = std::make_shared<Spline>();
        spline_->degree = static_cast<int>(spline.degree);
    }
    void addControlPoint(const DL_ControlPointData& pole) override {
        if (!spline_) return;
        if (spline_->poles.size() == kMostPoles) fail("expected a spline, found one without end");
        spline_->poles.push_back(point(pole.x, pole.y));
        spline_->weights.push_back(pole.w > 0 ? number(pole.w) : 1);
    }
    void addKnot(const DL_KnotData& knot) override {
        if (!spline_) return;
        if (spline_->knots.size() > 2 * kMostPoles) fail("expected a spline, found one without end");
        spline_->knots.push_back(number(knot.k));
    }

    /// Of polylines and splines, when all their points are there.
    void endEntity() override {
        endSpline();
        endPolyline();
    }
    void endSequence() override { endPolyline(); }

    void addInsert(const DL_InsertData& insert) override {
        refuseLayer(fmt::format("it holds the block '{}'; explode blocks before exporting",
                                plainLine(insert.name.substr(0, 60))));
    }
    void addHatch(const DL_HatchData& /*data*/) override { leaveAside("hatch"); }
    void addPoint(const DL_PointData& /*data*/) override { leaveAside("point"); }
    void addText(const DL_TextData& /*data*/) override { leaveAside("text"); }
    void addMText(const DL_MTextData& /*data*/) override { leaveAside("text"); }
    void addSolid(const DL_SolidData& /*data*/) override { leaveAside("solid"); }
    void addTrace(const DL_TraceData& /*data*/) override { leaveAside("trace"); }
    void add3dFace(const DL_3dFaceData& /*data*/) override { leaveAside("3D face"); }
    void addXLine(const DL_XLineData& /*data*/) override { leaveAside("construction line"); }
    void addRay(const DL_RayData& /*data*/) override { leaveAside("ray"); }
    void addImage(const DL_ImageData& /*data*/) override { leaveAside("image"); }
    void addLeader(const DL_LeaderData& /*data*/) override { leaveAside("leader"); }
    void addDimLinear(const DL_DimensionData& /*d*/, const DL_DimLinearData& /*e*/) override {
        leaveAside("dimension");
    }
    void addDimAlign(const DL_DimensionData& /*d*/, const DL_DimAlignedData& /*e*/) override {
        leaveAside("dimension");
    }
    void addDimRadial(const DL_DimensionData& /*d*/, const DL_DimRadialData& /*e*/) override {
        leaveAside("dimension");
    }
    void addDimDiametric(const DL_DimensionData& /*d*/, const DL_DimDiametricData& /*e*/) override {
        leaveAside("dimension");
    }

  private:
    struct Vertex {
        Vec2 at;
        double bulge = 0;
    };

    std::string place() const { return fmt::format("entity {}", entity_ + 1); }
    [[noreturn]] void fail(const std::string& message) const { refuse(file_, place(), message); }

    double number(double value) const {
        constexpr double kFarthest = 1e7;
        if (!std::isfinite(value) || std::abs(value) > kFarthest)
            fail(fmt::format("expected numbers of at most {:g}, found {:g}", kFarthest, value));
        return value;
    }
    Vec2 point(double x, double y) const { return {number(x), number(y)}; }
    double above0(double value, const char* what) const {
        if (!(number(value) > 0)) fail(fmt::format("expected {} above 0, found {:g}", what, value));
        return value;
    }

    std::string layer() { return plainLine(getAttributes().getLayer()); }
    std::string colour() {
        DL_Attributes own = getAttributes();
        if (const int rgb = own.getColor24(); rgb >= 0) return fmt::format("colour:#{:06x}", rgb);
        return fmt::format("colour:{}", own.getColor());
    }

    void leaveAside(const char* kind) {
        if (!in_block_) ++sketch_.left_aside[fmt::format("{} ({})", layer(), kind)];
    }

    void refuseLayer(const std::string& why) {
        if (!in_block_) sketch_.refused.emplace(layer(), why);
    }

    void add(Stroke stroke) {
        ++entity_;
        if (in_block_) return;
        double direction[3] = {0, 0, 1};
        getExtrusion()->getDirection(direction);
        if (std::hypot(direction[0], direction[1]) > kUpright || direction[2] <= 0)
            return refuseLayer(
                fmt::format("entity {} is drawn in a plane of its own; flatten the drawing", entity_));
        if (sketch_.strokes.size() == kMostStrokes)
            fail(fmt::format("expected at most {} lines and arcs", kMostStrokes));
        stroke.layer = layer();
        stroke.colour = colour();
        stroke.place = fmt::format("entity {}", entity_);
        const bool is_point = stroke.from == stroke.to && !stroke.isCircle() && !stroke.spline;
        if (!is_point) sketch_.strokes.push_back(std::move(stroke));
    }

    void endPolyline() {
        if (!in_polyline_) return;
        in_polyline_ = false;
        const std::size_t count = vertices_.size();
        const std::size_t strokes = polyline_closed_ ? count : count == 0 ? 0 : count - 1;
        for (std::size_t i = 0; i < strokes; ++i) {
            Stroke stroke;
            stroke.from = vertices_[i].at;
            stroke.to = vertices_[(i + 1) % count].at;
            stroke.bulge = vertices_[i].bulge;
            add(std::move(stroke));
        }
        vertices_.clear();
    }

    void endSpline() {
        if (!spline_) return;
        const std::shared_ptr<Spline> spline = std::move(spline_);
        spline_ = nullptr;
        const std::size_t wanted = spline->poles.size() + static_cast<std::size_t>(spline->degree) + 1;
        if (spline->poles.size() <= static_cast<std::size_t>(spline->degree) ||
            spline->knots.size() != wanted)
            return refuseLayer(
                fmt::format("entity {} is a spline without control points and knots that fit", entity_ + 1));
        const auto repeated = [&](std::size_t first) {
            for (std::size_t i = first; i <= first + static_cast<std::size_t>(spline->degree); ++i)
                if (spline->knots[i] != spline->knots[first]) return false;
            return true;
        };
        if (!std::is_sorted(spline->knots.begin(), spline->knots.end()) || !repeated(0) ||
            !repeated(spline->poles.size()) || spline->knots.front() == spline->knots.back())
            return refuseLayer(
                fmt::format("entity {} is a spline that does not end at its end points", entity_ + 1));
        Stroke stroke;
        stroke.from = spline->poles.front();
        stroke.to = spline->poles.back();
        stroke.spline = spline;
        add(std::move(stroke));
    }

    const std::string& file_;
    Sketch sketch_;
    bool in_block_ = false;
    bool in_polyline_ = false;
    bool polyline_closed_ = false;
    int entity_ = 0;
    std::vector<Vertex> vertices_;
    std::shared_ptr<Spline> spline_;
};

/// Hands a drawing's groups, a code and a value each on lines of their own, to dxflib one by one, and looks
/// first at what it would trust.
class DxfGroups {
  public:
    DxfGroups(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    void readInto(DxfTaker& taker) {
        DL_Dxf reader;
        // Only this sets all its members.
        std::istringstream group;
        reader.in(group, &taker);
        bool ended = false;
        while (!ended && next()) {
            checkCount();
            ended = code_ == kEntity && value_ == "EOF";
            group.clear();
            group.str(fmt::format("{}\n{}\n", code_, value_));
            reader.readDxfGroups(group, &taker);
        }
    }

  private:
    static constexpr int kEntity = 0;
    /// dxflib reads lines of up to 1024 bytes; no number or name is nearly as long.
    static constexpr std::size_t kLongestValue = 1000;
    /// Of a spline's knots, poles and points, a leader's and a polyline's vertices.
    static constexpr std::array kCounts{72, 73, 74, 76, 90};

    [[noreturn]] void fail(const std::string& message) const {
        refuse(file_, fmt::format("line {}", line_), message);
    }

    /// Is there one more? Blank lines at the end are none.
    bool next() {
        if (trimmed(text_).empty()) return false;
        const std::string_view code = trimmed(takeLine());
        const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), code_);
        if (error != std::errc() || end != code.data() + code.size())
            fail(fmt::format("expected a group code of DXF, found '{}'", plainLine(code.substr(0, 40))));
        const std::string_view value = takeLine();
        value_ = (code_ == kEntity ? trimmed(value) : value).substr(0, kLongestValue);
        return true;
    }

    std::string_view takeLine() {
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        std::string_view line = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        ++line_;
        return line;
    }

    /// dxflib makes room for as many points as an entity says it has.
    void checkCount() {
        if (code_ == kEntity)
            counts_points_ = value_ == "LWPOLYLINE" || value_ == "SPLINE" || value_ == "LEADER";
        if (!counts_points_ || std::find(kCounts.begin(), kCounts.end(), code_) == kCounts.end()) return;
        const long count = std::strtol(value_.c_str(), nullptr, 10);
        if (count < 0 || count > static_cast<long>(kMostStrokes))
            fail(fmt::format("expected 0 to {} points, found a count of {}", kMostStrokes, count));
    }

    std::string_view text_;  ///< not read yet
    const std::string& file_;
    int line_ = 0;
    int code_ = 0;
    std::string value_;
    bool counts_points_ = false;  ///< the entity that is read says how many it has
};

}  // namespace

Sketch readDxf(std::string_view text, const std::string& file) {
    if (text.starts_with("AutoCAD Binary DXF"))
        refuse(file, "start", "expected a DXF of text, found a binary one; export it as ASCII");
    if (text.find("ENTITIES") == std::string_view::npos || text.find('\0') != std::string_view::npos)
        refuse(file, "start", "expected a DXF drawing with a section ENTITIES, found something else");
    DxfTaker taker(file);
    DxfGroups(text, file).readInto(taker);
    return std::move(taker).sketch();
}

}  // namespace stepmill::drawing
