#include "step_text.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <unordered_map>

#include <fmt/format.h>

#include "step_lexer.h"

namespace stepmill {
namespace {

using Kind = StepToken::Kind;

/// Entities that make up the shape, sorted: numbers in them must be plausible, references must not dangle.
constexpr std::array<std::string_view, 56> kShapeEntities = {"ADVANCED_BREP_SHAPE_REPRESENTATION",
                                                             "ADVANCED_FACE",
                                                             "AXIS1_PLACEMENT",
                                                             "AXIS2_PLACEMENT_2D",
                                                             "AXIS2_PLACEMENT_3D",
                                                             "BEZIER_CURVE",
                                                             "BEZIER_SURFACE",
                                                             "BOUNDED_CURVE",
                                                             "BOUNDED_SURFACE",
                                                             "BREP_WITH_VOIDS",
                                                             "B_SPLINE_CURVE",
                                                             "B_SPLINE_CURVE_WITH_KNOTS",
                                                             "B_SPLINE_SURFACE",
                                                             "B_SPLINE_SURFACE_WITH_KNOTS",
                                                             "CARTESIAN_POINT",
                                                             "CIRCLE",
                                                             "CLOSED_SHELL",
                                                             "CONICAL_SURFACE",
                                                             "CYLINDRICAL_SURFACE",
                                                             "DEGENERATE_TOROIDAL_SURFACE",
                                                             "DIRECTION",
                                                             "EDGE_CURVE",
                                                             "EDGE_LOOP",
                                                             "ELLIPSE",
                                                             "FACETED_BREP",
                                                             "FACE_BOUND",
                                                             "FACE_OUTER_BOUND",
                                                             "FACE_SURFACE",
                                                             "HYPERBOLA",
                                                             "INTERSECTION_CURVE",
                                                             "ITEM_DEFINED_TRANSFORMATION",
                                                             "LINE",
                                                             "MANIFOLD_SOLID_BREP",
                                                             "MAPPED_ITEM",
                                                             "OFFSET_SURFACE",
                                                             "OPEN_SHELL",
                                                             "ORIENTED_CLOSED_SHELL",
                                                             "ORIENTED_EDGE",
                                                             "ORIENTED_FACE",
                                                             "PARABOLA",
                                                             "PCURVE",
                                                             "PLANE",
                                                             "POLYLINE",
                                                             "POLY_LOOP",
                                                             "RECTANGULAR_TRIMMED_SURFACE",
                                                             "SEAM_CURVE",
                                                             "SHELL_BASED_SURFACE_MODEL",
                                                             "SPHERICAL_SURFACE",
                                                             "SURFACE_CURVE",
                                                             "SURFACE_OF_LINEAR_EXTRUSION",
                                                             "SURFACE_OF_REVOLUTION",
                                                             "TOROIDAL_SURFACE",
                                                             "TRIMMED_CURVE",
                                                             "VECTOR",
                                                             "VERTEX_LOOP",
                                                             "VERTEX_POINT"};
static_assert(std::is_sorted(kShapeEntities.begin(), kShapeEntities.end()));

bool isShapeEntity(std::string_view keyword) {
    return std::binary_search(kShapeEntities.begin(), kShapeEntities.end(), keyword);
}

bool isSolidBody(std::string_view keyword) {
    return keyword == "MANIFOLD_SOLID_BREP" || keyword == "BREP_WITH_VOIDS" || keyword == "FACETED_BREP" ||
           keyword == "FACETED_BREP_AND_BREP_WITH_VOIDS";
}

/// "nan", "INF", "infinity", "qnan", "ind" in any case: how programs print numbers that are none.
bool isNonFiniteWord(std::string_view word) {
    std::string lower;
    for (const char c : word) {
        if (c != '+' && c != '-') lower += static_cast<char>(c | 0x20);
    }
    for (const std::string_view name : {"nan", "inf", "infinity", "qnan", "snan", "ind", "nanq", "nans"}) {
        if (lower == name) return true;
    }
    return lower.find("#inf") != std::string::npos || lower.find("#ind") != std::string::npos ||
           lower.find("nan") != std::string::npos;
}

std::string unquote(std::string_view quoted) {
    std::string plain;
    for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
        plain += quoted[i];
        if (quoted[i] == '\'') ++i;
    }
    return plain;
}

class Screen {
  public:
    Screen(std::string_view text, const std::string& file) : lexer_(text, file), file_(file) {}
    StepText run();

  private:
    struct Entity {
        std::uint64_t id = 0;
        int line = 0;
        std::string_view keyword;
    };
    struct Reference {
        std::size_t entity = 0;
        std::uint64_t target = 0;
        int line = 0;
    };

    void header();
    void otherSection(const std::string& name);
    void data();
    void entity(const StepToken& id);
    void value(const StepToken& token, std::string_view keyword);
    void number(const StepToken& token, std::string_view keyword);
    void word(const StepToken& token);
    void noteKeyword(std::string_view keyword);
    void checkReferences();
    void checkCycles();
    void define(std::uint64_t id, int line, std::string_view keyword);
    void expect(char punctuation, const std::string& after);
    std::uint64_t idOf(const StepToken& token);
    [[noreturn]] void truncated(const std::string& where, const std::string& expected);
    [[noreturn]] void damaged(int line, const std::string& message) {
        lexer_.fail(ErrorCode::StepDamaged, line, message);
    }

    StepLexer lexer_;
    const std::string& file_;
    StepText result_;
    std::vector<Entity> entities_;
    std::vector<Reference> references_;
    std::unordered_map<std::uint64_t, std::size_t> index_of_id_;
    bool has_data_ = false;
};

void Screen::truncated(const std::string& where, const std::string& expected) {
    damaged(lexer_.line(),
            "the file ends " + where + "; " + expected + " expected. It is truncated: export it again");
}

void Screen::expect(char punctuation, const std::string& after) {
    const StepToken token = lexer_.next();
    if (token.is(punctuation)) return;
    if (token.kind == Kind::End) truncated("after " + after, std::string("'") + punctuation + "'");
    damaged(token.line, std::string("'") + punctuation + "' expected after " + after + ", found " +
                            std::string(token.text.substr(0, 40)));
}

std::uint64_t Screen::idOf(const StepToken& token) {
    std::uint64_t id = 0;
    const char* end = token.text.data() + token.text.size();
    const auto [stop, error] = std::from_chars(token.text.data() + 1, end, id);
    if (error == std::errc{} && stop == end) return id;
    damaged(token.line, "entity number expected, found " + std::string(token.text.substr(0, 40)));
}

void Screen::define(std::uint64_t id, int line, std::string_view keyword) {
    const auto [it, fresh] = index_of_id_.emplace(id, entities_.size());
    if (!fresh)
        damaged(line, fmt::format("#{} is defined a second time; the first is in line {}", id,
                                  entities_[it->second].line));
    entities_.push_back({id, line, keyword});
}

void Screen::header() {
    expect(';', "HEADER");
    bool in_schema = false;
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) truncated("inside the header", "ENDSEC; and a DATA section");
        if (token.isWord("DATA")) damaged(token.line, "ENDSEC; expected before DATA");
        if (token.isWord("ENDSEC")) break;
        if (token.isWord("FILE_SCHEMA")) in_schema = true;
        if (token.is(';')) in_schema = false;
        if (in_schema && token.kind == Kind::String) result_.schemas.push_back(unquote(token.text));
    }
    expect(';', "ENDSEC");
}

/// ANCHOR, REFERENCE and SIGNATURE of edition 3: only the ids a REFERENCE section brings in matter.
void Screen::otherSection(const std::string& name) {
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) truncated("inside the " + name + " section", "ENDSEC;");
        if (token.isWord("ENDSEC")) break;
        if (name == "REFERENCE" && token.kind == Kind::Reference && lexer_.peek().is('='))
            define(idOf(token), token.line, "REFERENCE");
    }
    expect(';', "ENDSEC");
}

void Screen::data() {
    has_data_ = true;
    while (!lexer_.peek().is(';')) {  // edition 3 allows parameters after DATA
        if (lexer_.next().kind == Kind::End) truncated("after DATA", "';'");
    }
    lexer_.next();
    while (true) {
        const StepToken token = lexer_.next();
        if (token.isWord("ENDSEC")) break;
        if (token.kind == Kind::Reference) {
            entity(token);
        } else if (token.kind == Kind::End) {
            const std::string last =
                entities_.empty() ? "" : " after entity #" + std::to_string(entities_.back().id);
            truncated("inside the DATA section" + last, "ENDSEC; and END-ISO-10303-21;");
        } else {
            damaged(token.line, "an entity '#number=' or ENDSEC expected, found " +
                                    std::string(token.text.substr(0, 40)));
        }
    }
    expect(';', "ENDSEC");
}

void Screen::entity(const StepToken& id_token) {
    const std::uint64_t id = idOf(id_token);
    const std::string name = fmt::format("#{}", id);
    expect('=', name);
    const std::size_t self = entities_.size();
    define(id, id_token.line, lexer_.peek().kind == Kind::Word ? lexer_.peek().text : "");

    std::vector<std::string_view> keywords;  // one per open parenthesis
    std::string_view pending;                // keyword just read, its parenthesis still to come
    bool value_before = false;
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) truncated("inside entity " + name, "')' and ';'");
        if (token.is(';')) break;
        if (token.is('=')) damaged(token.line, "';' missing before this entity, at the end of " + name);
        if (token.is(')')) {
            if (keywords.empty()) damaged(token.line, "')' without '(' in entity " + name);
            keywords.pop_back();
            value_before = true;
        } else if (token.is('(')) {
            keywords.push_back(!pending.empty() || keywords.empty() ? pending : keywords.back());
            pending = {};
            value_before = false;
        } else if (token.is(',')) {
            value_before = false;
        } else if (token.kind == Kind::Word) {
            word(token);
            pending = token.text;
            if (entities_[self].keyword.empty()) entities_[self].keyword = pending;
            noteKeyword(pending);
        } else {
            if (value_before)
                damaged(token.line, "',' or ')' expected in " + name + ", found " +
                                        std::string(token.text.substr(0, 40)));
            value_before = true;
            if (token.kind == Kind::Reference) references_.push_back({self, idOf(token), token.line});
            value(token, keywords.empty() ? std::string_view{} : keywords.back());
        }
    }
    if (!keywords.empty()) damaged(lexer_.line(), "')' missing at the end of entity " + name);
    ++result_.entities;
}

void Screen::noteKeyword(std::string_view keyword) {
    if (isSolidBody(keyword)) ++result_.solid_bodies;
    if (keyword == "LENGTH_UNIT") result_.has_length_unit = true;
}

void Screen::word(const StepToken& token) {
    if (lexer_.peek().is('(') && !isNonFiniteWord(token.text)) return;
    if (lexer_.peek().kind == Kind::End) truncated("inside an entity", "')' and ';'");
    if (isNonFiniteWord(token.text))
        damaged(token.line, "a finite number expected, found " + std::string(token.text.substr(0, 40)));
    damaged(token.line, "a value expected, found the bare word " + std::string(token.text.substr(0, 40)));
}

void Screen::value(const StepToken& token, std::string_view keyword) {
    if (token.kind == Kind::Number) number(token, keyword);
    if (token.kind == Kind::String && keyword == "DOCUMENT_FILE") {
        const std::string name = unquote(token.text);
        if (name.find('.') != std::string::npos) result_.external_files.push_back(name);
    }
}

void Screen::number(const StepToken& token, std::string_view keyword) {
    std::string_view digits = token.text;
    const std::string shown(token.text.substr(0, 40));
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double number = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool underflow = error == std::errc::result_out_of_range &&
                           token.text.find_first_of("eE") != std::string_view::npos &&
                           token.text.find("-", 1) != std::string_view::npos;
    if (underflow) return;
    const bool overflow = error == std::errc::result_out_of_range;
    if (!overflow && (error != std::errc{} || stop != digits.data() + digits.size())) {
        if (isNonFiniteWord(token.text)) damaged(token.line, "a finite number expected, found " + shown);
        damaged(token.line, "a number expected, found " + shown);
    }
    if (!overflow && !std::isfinite(number)) damaged(token.line, "a finite number expected, found " + shown);
    if (overflow || (std::abs(number) > kLargestGeometricNumber && isShapeEntity(keyword)))
        lexer_.fail(ErrorCode::ImplausibleSize, token.line,
                    "the number " + shown + " in " + std::string(keyword) +
                        " is out of range; values up to 1E12 are taken");
}

void Screen::checkReferences() {
    int dangling = 0;
    Reference first;
    for (const Reference& reference : references_) {
        const Entity& from = entities_[reference.entity];
        if (reference.target == from.id)
            damaged(reference.line,
                    fmt::format("#{} {} contains itself; another entity expected", from.id, from.keyword));
        if (index_of_id_.contains(reference.target)) continue;
        if (isShapeEntity(from.keyword))
            damaged(reference.line, fmt::format("#{} {} refers to #{}, which the file does not define",
                                                from.id, from.keyword, reference.target));
        if (dangling++ == 0) first = reference;
    }
    if (dangling > 0)
        result_.remarks.push_back(
            fmt::format("{} references outside the shape lead nowhere, the first in line {} to #{}", dangling,
                        first.line, first.target));
}

/// A shape is a tree with shared leaves; a path that comes back to where it began would send the reader
/// round for ever. Depth-first search with a stack of its own, since files nest as deep as they like.
void Screen::checkCycles() {
    // References lie in the order of their entities: those of entity i from begin[i] to begin[i + 1].
    std::vector<std::size_t> begin(entities_.size() + 1, 0);
    for (const Reference& reference : references_)
        ++begin[reference.entity + 1];
    for (std::size_t i = 0; i < entities_.size(); ++i)
        begin[i + 1] += begin[i];

    enum class State : unsigned char { Fresh, Open, Done };
    std::vector<State> state(entities_.size(), State::Fresh);
    std::vector<std::size_t> next = begin;
    std::vector<std::size_t> path;
    for (std::size_t root = 0; root < entities_.size(); ++root) {
        if (state[root] != State::Fresh || !isShapeEntity(entities_[root].keyword)) continue;
        path.push_back(root);
        state[root] = State::Open;
        while (!path.empty()) {
            const std::size_t at = path.back();
            if (next[at] == begin[at + 1]) {
                state[at] = State::Done;
                path.pop_back();
                continue;
            }
            const Reference& reference = references_[next[at]++];
            const auto target = index_of_id_.find(reference.target);
            if (target == index_of_id_.end() || !isShapeEntity(entities_[target->second].keyword)) continue;
            if (state[target->second] == State::Open)
                damaged(reference.line,
                        fmt::format("#{} {} contains itself by way of #{}; another entity expected",
                                    reference.target, entities_[target->second].keyword, entities_[at].id));
            if (state[target->second] == State::Done) continue;
            state[target->second] = State::Open;
            path.push_back(target->second);
        }
    }
}

StepText Screen::run() {
    lexer_.next();  // ISO-10303-21, seen by the caller
    expect(';', "ISO-10303-21");
    while (true) {
        const StepToken token = lexer_.next();
        if (token.isWord("END-ISO-10303-21")) break;
        if (token.isWord("HEADER")) {
            header();
        } else if (token.isWord("DATA")) {
            data();
        } else if (token.isWord("ANCHOR") || token.isWord("REFERENCE") || token.isWord("SIGNATURE")) {
            otherSection(std::string(token.text));
        } else if (token.kind == Kind::End) {
            if (has_data_) truncated("after the DATA section", "END-ISO-10303-21;");
            truncated("before any DATA section", "DATA;");
        } else {
            damaged(token.line, "a section (HEADER, DATA) or END-ISO-10303-21 expected, found " +
                                    std::string(token.text.substr(0, 40)));
        }
    }
    if (!has_data_) damaged(lexer_.line(), "the file has no DATA section");
    if (result_.entities == 0)
        throw Error(ErrorCode::NoSolid, file_, "the DATA section is empty; there is no part in this file");
    checkReferences();
    checkCycles();
    return std::move(result_);
}

}  // namespace

StepText screenStep(std::string_view text, const std::string& file) {
    if (text.empty()) throw Error(ErrorCode::NotStep, file, "the file is empty");
    const std::string_view body = skipPreamble(text);
    if (body.empty()) throw Error(ErrorCode::NotStep, file, "the file holds nothing but blank space");
    if (!body.starts_with("ISO-10303-21"))
        throw Error(
            ErrorCode::NotStep, file,
            "not a STEP file: it should begin with ISO-10303-21; and looks like " + guessFormat(text));
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return Screen(text, file).run();
}

}  // namespace stepmill
