#include "part/step/syntax.h"

#include <charconv>

#include <fmt/format.h>

#include "part/step/kinds.h"

namespace stepmill {
namespace {

using Kind = StepToken::Kind;

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

}  // namespace

void StepSyntax::truncated(const std::string& where, const std::string& expected) {
    damaged(lexer_.line(),
            "the file ends " + where + "; " + expected + " expected. It is truncated: export it again");
}

void StepSyntax::expect(char punctuation, const std::string& after) {
    const StepToken token = lexer_.next();
    if (token.is(punctuation)) return;
    if (token.kind == Kind::End) truncated("after " + after, std::string("'") + punctuation + "'");
    damaged(token.line, std::string("'") + punctuation + "' expected after " + after + ", found " +
                            std::string(token.text.substr(0, 40)));
}

std::uint32_t StepSyntax::idOf(const StepToken& token) {
    std::uint64_t id = 0;
    const char* end = token.text.data() + token.text.size();
    const auto [stop, error] = std::from_chars(token.text.data() + 1, end, id);
    const std::string shown(token.text.substr(0, 40));
    if (stop != end || error == std::errc::invalid_argument)
        damaged(token.line, "entity number expected, found " + shown);
    if (error == std::errc::result_out_of_range || id > kLargestId)
        damaged(token.line, fmt::format("entity number up to {} expected, found {}", kLargestId, shown));
    return static_cast<std::uint32_t>(id);
}

void StepSyntax::define(std::uint32_t id, int line) {
    StepModel& model = *model_;
    const auto [it, fresh] = model.index_of_id_.emplace(id, model.entities_.size());
    if (!fresh)
        damaged(line, fmt::format("#{} is defined a second time; the first is in line {}", id,
                                  model.entities_[it->second].line));
    const auto next = static_cast<std::uint32_t>(model.records_.size());
    model.entities_.push_back({id, line, next, next});
}

void StepSyntax::header() {
    expect(';', "HEADER");
    bool in_schema = false;
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) truncated("inside the header", "ENDSEC; and a DATA section");
        if (token.isWord("DATA")) damaged(token.line, "ENDSEC; expected before DATA");
        if (token.isWord("ENDSEC")) break;
        if (token.isWord("FILE_SCHEMA")) in_schema = true;
        if (token.is(';')) in_schema = false;
        if (in_schema && token.kind == Kind::String) result_->schemas.push_back(unquote(token.text));
    }
    expect(';', "ENDSEC");
}

/// ANCHOR, REFERENCE and SIGNATURE of edition 3: only the ids a REFERENCE section brings in matter.
void StepSyntax::otherSection(const std::string& name) {
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) truncated("inside the " + name + " section", "ENDSEC;");
        if (token.isWord("ENDSEC")) break;
        if (name == "REFERENCE" && token.kind == Kind::Reference && lexer_.peek().is('='))
            define(idOf(token), token.line);
    }
    expect(';', "ENDSEC");
}

void StepSyntax::data() {
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
            const std::string last = model_->entities_.empty()
                                         ? ""
                                         : " after entity #" + std::to_string(model_->entities_.back().id);
            truncated("inside the DATA section" + last, "ENDSEC; and END-ISO-10303-21;");
        } else {
            damaged(token.line, "an entity '#number=' or ENDSEC expected, found " +
                                    std::string(token.text.substr(0, 40)));
        }
    }
    expect(';', "ENDSEC");
}

void StepSyntax::entity(const StepToken& id_token) {
    const std::uint32_t id = idOf(id_token);
    Open open;
    open.name = fmt::format("#{}", id);
    expect('=', open.name);
    define(id, id_token.line);
    open.complex = lexer_.peek().is('(');
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) truncated("inside entity " + open.name, "')' and ';'");
        if (token.is(';')) break;
        parameter(open, token);
    }
    if (!open.keywords.empty()) damaged(lexer_.line(), "')' missing at the end of entity " + open.name);
    model_->entities_.back().last = static_cast<std::uint32_t>(model_->records_.size());
    ++result_->entities;
}

void StepSyntax::parameter(Open& open, const StepToken& token) {
    if (token.is('=')) damaged(token.line, "';' missing before this entity, at the end of " + open.name);
    if (token.is(')')) {
        closeParenthesis(open, token.line);
    } else if (token.is('(')) {
        openParenthesis(open, token.line);
    } else if (token.is(',')) {
        open.value_before = false;
    } else if (token.kind == Kind::Word) {
        word(token);
        open.pending = token.text;
        noteKeyword(token.text);
    } else {
        if (open.value_before)
            damaged(token.line, "',' or ')' expected in " + open.name + ", found " +
                                    std::string(token.text.substr(0, 40)));
        requireRecord(open, token.line);
        open.value_before = true;
        addValue(token, open.keywords.empty() ? std::string_view{} : open.keywords.back());
    }
}

/// Values and lists stand in records alone.
void StepSyntax::requireRecord(const Open& open, int line) {
    if (!open.record_open) damaged(line, "a keyword and its '(' expected in " + open.name);
}

/// A parenthesis opens the set of records of a complex entity, a record or a list.
void StepSyntax::openParenthesis(Open& open, int line) {
    if (open.keywords.size() >= kDeepestList)
        damaged(line, fmt::format("lists are nested deeper than {} in {}", kDeepestList, open.name));
    if (open.value_before && open.pending.empty())
        damaged(line, "',' or ')' expected in " + open.name + ", found (");
    const bool set = open.complex && open.keywords.empty();
    const bool record = !set && !open.record_open && !open.pending.empty();
    const auto next = static_cast<std::uint32_t>(model_->values_.size());
    if (!set && !record) requireRecord(open, line);
    if (record) {
        if (!open.complex && open.closed) damaged(line, "';' expected after the record of " + open.name);
        model_->records_.push_back({open.pending, next, next});
        open.record_open = true;
    }
    open.lists.push_back(next);
    if (!set && !record) {
        StepValue list;
        list.kind = StepValue::Kind::List;
        model_->values_.push_back(list);
    }
    open.keywords.push_back(!open.pending.empty() || open.keywords.empty() ? open.pending
                                                                           : open.keywords.back());
    open.pending = {};
    open.value_before = false;
}

void StepSyntax::closeParenthesis(Open& open, int line) {
    if (open.keywords.empty()) damaged(line, "')' without '(' in entity " + open.name);
    open.keywords.pop_back();
    const std::size_t begin = open.lists.back();
    open.lists.pop_back();
    open.value_before = true;
    const std::size_t record_depth = open.complex ? 1 : 0;
    if (open.keywords.size() > record_depth) {
        if (open.record_open)
            model_->values_[begin].word = static_cast<std::uint32_t>(model_->values_.size() - begin - 1);
    } else if (open.record_open) {
        model_->records_.back().last = static_cast<std::uint32_t>(model_->values_.size());
        open.record_open = false;
        open.closed = true;
    }
}

void StepSyntax::noteKeyword(std::string_view keyword) {
    if (isSolidBody(keyword)) ++result_->solid_bodies;
    if (keyword == "LENGTH_UNIT") result_->has_length_unit = true;
}

void StepSyntax::word(const StepToken& token) {
    if (lexer_.peek().is('(') && !isNonFiniteWord(token.text)) return;
    if (lexer_.peek().kind == Kind::End) truncated("inside an entity", "')' and ';'");
    if (isNonFiniteWord(token.text))
        damaged(token.line, "a finite number expected, found " + std::string(token.text.substr(0, 40)));
    damaged(token.line, "a value expected, found the bare word " + std::string(token.text.substr(0, 40)));
}

/// Every value that is read stands in the model, so that a parameter's place is its place in the file.
void StepSyntax::addValue(const StepToken& token, std::string_view keyword) {
    StepValue value;
    if (token.kind == Kind::Number) {
        value.kind = StepValue::Kind::Number;
        value.number = number(token, keyword);
    } else if (token.kind == Kind::Reference) {
        value.kind = StepValue::Kind::Reference;
        value.word = idOf(token);
    } else if (token.kind == Kind::Enumeration) {
        value.kind = StepValue::Kind::Enumeration;
    } else if (token.kind == Kind::String || token.kind == Kind::Binary) {
        value.kind = StepValue::Kind::Text;
    }
    if (value.is(StepValue::Kind::Enumeration) || value.is(StepValue::Kind::Text)) {
        value.begin = token.text.data();
        value.word = static_cast<std::uint32_t>(token.text.size());
    }
    if (token.kind == Kind::String && keyword == "DOCUMENT_FILE") {
        const std::string name = unquote(token.text);
        if (name.find('.') != std::string::npos) result_->external_files.push_back(name);
    }
    model_->values_.push_back(value);
}

double StepSyntax::number(const StepToken& token, std::string_view keyword) {
    std::string_view digits = token.text;
    const std::string shown(token.text.substr(0, 40));
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double number = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool underflow = error == std::errc::result_out_of_range &&
                           token.text.find_first_of("eE") != std::string_view::npos &&
                           token.text.find("-", 1) != std::string_view::npos;
    if (underflow) return 0;
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
    return number;
}

void StepSyntax::read(StepText& result, StepModel& model) {
    result_ = &result;
    model_ = &model;
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
    if (result_->entities == 0)
        throw Error(ErrorCode::NoSolid, file_, "the DATA section is empty; there is no part in this file");
}

}  // namespace stepmill
