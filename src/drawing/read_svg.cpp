// SVG: paths and basic shapes in groups, by pugixml.

#include <cmath>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "drawing/sketch.h"
#include "drawing/svg_numbers.h"
#include "drawing/svg_path.h"
#include "drawing/svg_transform.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"

namespace stepmill::drawing {
namespace {

using Affine = Eigen::Affine2d;

/// Deeper groups are made to exhaust a reader.
constexpr int kDeepest = 200;
/// Circles stay circles where both axes grow alike to this share.
constexpr double kSameScale = 1e-9;

/// What a group hands down.
struct Context {
    Affine transform = Affine::Identity();
    std::string layer;
    std::string colour;
};

double mmOfUnit(const std::string& unit) {
    if (unit == "mm") return 1;
    if (unit == "cm") return 10;
    if (unit == "in") return kMillimetresPerInch;
    return 0;
}

class SvgReader {
  public:
    SvgReader(const std::string& file, Sketch& sketch) : file_(file), sketch_(sketch) {}

    void read(const pugi::xml_node& svg) {
        sketch_.mm_per_unit = unitOf(svg);
        Context context;
        context.transform.matrix() << 1, 0, 0, 0, -1, 0, 0, 0, 1;  // SVG's y points down
        children(svg, context, 0);
    }

  private:
    /// mm of a user unit where width and view box tell it; 0 otherwise.
    double unitOf(const pugi::xml_node& svg) const {
        SvgNumbers width(svg.attribute("width").value());
        const std::optional<double> across = width.number();
        std::string unit;
        while (width.peek() != '\0')
            unit += width.take();
        SvgNumbers box(svg.attribute("viewBox").value());
        std::vector<double> sides;
        while (const auto side = box.number())
            sides.push_back(*side);
        if (!across || mmOfUnit(unit) == 0 || sides.size() != 4 || !(sides[2] > 0)) return 0;
        return mmOfUnit(unit) * *across / sides[2];
    }

    std::string placeOf(const pugi::xml_node& node) const {
        const std::string id = node.attribute("id").value();
        return plainLine(fmt::format("<{}>{} at byte {}", node.name(),
                                     id.empty() ? "" : " " + id.substr(0, 60), node.offset_debug()));
    }

    void children(const pugi::xml_node& parent, const Context& context, int depth) {
        if (depth > kDeepest)
            refuse(file_, placeOf(parent), fmt::format("expected groups at most {} deep", kDeepest));
        for (const pugi::xml_node& node : parent.children())
            if (node.type() == pugi::node_element) element(node, inherited(node, context), depth);
    }

    Context inherited(const pugi::xml_node& node, Context context) const {
        if (const char* text = node.attribute("transform").value(); *text != '\0') {
            try {
                context.transform = context.transform * svgTransform(text);
            } catch (const std::invalid_argument& wrong) {
                refuse(file_, placeOf(node), wrong.what());
            }
        }
        if (const std::string colour = colourOf(node); !colour.empty()) context.colour = "colour:" + colour;
        return context;
    }

    /// Its stroke, or its fill where it has none.
    static std::string colourOf(const pugi::xml_node& node) {
        const std::string style = node.attribute("style").value();
        for (const char* name : {"stroke", "fill"}) {
            std::string value = node.attribute(name).value();
            const std::size_t at = (";" + style).find(fmt::format(";{}:", name));
            if (at != std::string::npos) value = style.substr(at + std::strlen(name) + 1);
            value = value.substr(0, value.find(';'));
            if (!value.empty() && value != "none") return plainLine(value.substr(0, 40));
        }
        return {};
    }

    void element(const pugi::xml_node& node, Context context, int depth) {
        const std::string name = node.name();
        if (name == "g" || name == "svg") {
            const char* label = node.attribute("inkscape:label").value();
            const std::string layer = *label != '\0' ? label : node.attribute("id").value();
            if (!layer.empty()) context.layer = plainLine(layer.substr(0, 200));
            return children(node, context, depth + 1);
        }
        try {
            shape(node, name, context);
        } catch (const std::invalid_argument& wrong) {
            refuse(file_, placeOf(node), wrong.what());
        }
    }

    void shape(const pugi::xml_node& node, const std::string& name, const Context& context) {
        if (name == "path") return add(svgPath(node.attribute("d").value()), node, context);
        if (name == "line")
            return add(chain({{num(node, "x1"), num(node, "y1")}, {num(node, "x2"), num(node, "y2")}}, false),
                       node, context);
        if (name == "polyline" || name == "polygon")
            return add(chain(points(node), name == "polygon"), node, context);
        if (name == "rect") return add(rect(node), node, context);
        if (name == "circle") return add(oval(node, num(node, "r"), num(node, "r")), node, context);
        if (name == "ellipse") return add(oval(node, num(node, "rx"), num(node, "ry")), node, context);
        static const std::set<std::string> kQuiet = {"defs", "metadata", "title",
                                                     "desc", "style",    "sodipodi:namedview"};
        if (kQuiet.contains(name)) return;
        ++sketch_.left_aside[fmt::format("{} ({})", context.layer, plainLine(name.substr(0, 40)))];
        if (name == "use" || name == "switch" || name == "symbol")
            sketch_.refused.emplace(context.layer, "it holds <" + name + ">; unlink clones before exporting");
    }

    static double num(const pugi::xml_node& node, const char* name) {
        const char* text = node.attribute(name).value();
        if (*text == '\0') return 0;
        SvgNumbers numbers(text);
        const double value = numbers.need();
        if (numbers.peek() != '\0')
            throw std::invalid_argument(fmt::format("expected {} as a number without a unit, found '{}'",
                                                    name, std::string(text).substr(0, 20)));
        return value;
    }

    static std::vector<Vec2> points(const pugi::xml_node& node) {
        SvgNumbers numbers(node.attribute("points").value());
        std::vector<Vec2> points;
        while (const auto x = numbers.number())
            points.emplace_back(*x, numbers.need());
        if (numbers.peek() != '\0') throw std::invalid_argument("expected points as pairs of numbers");
        return points;
    }

    static std::vector<Stroke> chain(const std::vector<Vec2>& points, bool closed) {
        std::vector<Stroke> strokes;
        const std::size_t count = points.size();
        for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
            Stroke stroke;
            stroke.from = points[i];
            stroke.to = points[(i + 1) % count];
            if (stroke.from != stroke.to) strokes.push_back(std::move(stroke));
        }
        return strokes;
    }

    static std::vector<Stroke> rect(const pugi::xml_node& node) {
        const double w = num(node, "width");
        const double h = num(node, "height");
        if (!(w > 0) || !(h > 0))
            throw std::invalid_argument("expected a rectangle's width and height above 0");
        double rx = node.attribute("rx") ? num(node, "rx") : num(node, "ry");
        double ry = node.attribute("ry") ? num(node, "ry") : rx;
        rx = std::clamp(rx, 0.0, w / 2);
        ry = std::clamp(ry, 0.0, h / 2);
        const double x = num(node, "x");
        const double y = num(node, "y");
        if (rx == 0 || ry == 0) return chain({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true);
        const std::vector<Vec2> ends{{x + rx, y},         {x + w - rx, y},     {x + w, y + ry},
                                     {x + w, y + h - ry}, {x + w - rx, y + h}, {x + rx, y + h},
                                     {x, y + h - ry},     {x, y + ry}};
        std::vector<Stroke> strokes;
        for (std::size_t i = 0; i < ends.size(); i += 2) {
            const Vec2& corner_end = ends[(i + 2) % ends.size()];
            for (Stroke& side : chain({ends[i], ends[i + 1]}, false))
                strokes.push_back(std::move(side));
            for (Stroke& corner : svgArc(ends[i + 1], rx, ry, 0, false, true, corner_end))
                strokes.push_back(std::move(corner));
        }
        return strokes;
    }

    static std::vector<Stroke> oval(const pugi::xml_node& node, double rx, double ry) {
        if (!(rx > 0) || !(ry > 0)) throw std::invalid_argument("expected radii above 0");
        const Vec2 centre(num(node, "cx"), num(node, "cy"));
        if (rx != ry) return ellipseArc(centre, {rx, 0}, {0, ry}, 0, 2 * kPi);
        Stroke circle;
        circle.from = circle.to = centre;
        circle.circle_radius = rx;
        return {circle};
    }

    void add(std::vector<Stroke> strokes, const pugi::xml_node& node, const Context& context) {
        for (Stroke& stroke : strokes) {
            if (sketch_.strokes.size() == kMostStrokes)
                refuse(file_, placeOf(node), fmt::format("expected at most {} lines and arcs", kMostStrokes));
            move(stroke, context.transform);
            stroke.layer = context.layer;
            stroke.colour = context.colour;
            stroke.place = placeOf(node);
            sketch_.strokes.push_back(std::move(stroke));
        }
    }

    static void move(Stroke& stroke, const Affine& transform) {
        const auto linear = transform.linear();
        const double scale = linear.col(0).norm();
        const bool similar = std::abs(linear.col(1).norm() - scale) <= kSameScale * scale &&
                             std::abs(linear.col(0).dot(linear.col(1))) <= kSameScale * scale * scale;
        if (!similar && (stroke.bulge != 0 || stroke.isCircle()))
            throw std::invalid_argument(
                "expected a transform that keeps circles, found one that stretches them");
        if (!(std::abs(linear.determinant()) > 0))
            throw std::invalid_argument("expected a transform that keeps areas");
        stroke.from = transform * stroke.from;
        stroke.to = transform * stroke.to;
        stroke.circle_radius *= scale;
        if (linear.determinant() < 0) stroke.bulge = -stroke.bulge;
        if (!stroke.spline) return;
        auto spline = std::make_shared<Spline>(*stroke.spline);
        for (Vec2& pole : spline->poles)
            pole = transform * pole;
        stroke.spline = std::move(spline);
    }

    const std::string& file_;
    Sketch& sketch_;
};

}  // namespace

Sketch readSvg(std::string_view text, const std::string& file) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size(), pugi::parse_default);
    if (!parsed)
        refuse(file, fmt::format("byte {}", parsed.offset),
               fmt::format("expected XML, found a fault: {}", parsed.description()));
    const pugi::xml_node svg = document.document_element();
    if (std::strcmp(svg.name(), "svg") != 0)
        refuse(file, "root",
               fmt::format("expected <svg>, found <{}>", plainLine(std::string(svg.name()).substr(0, 40))));
    Sketch sketch;
    SvgReader(file, sketch).read(svg);
    return sketch;
}

}  // namespace stepmill::drawing
