#include "part/step/entity_reader.h"

#include <fmt/format.h>

#include "part/step/kinds.h"
#include "part/step/token_values.h"

namespace stepmill {
namespace {

using Kind = StepToken::Kind;

}  // namespace

void StepEntityReader::define(std::uint32_t id, int line) {
    const auto [it, fresh] = model_.index_of_id_.emplace(id, model_.entities_.size());
    if (!fresh)
        lexer_.damaged(line, fmt::format("#{} is defined a second time; the first is in line {}", id,
                                         model_.entities_[it->second].line));
    const auto next = static_cast<std::uint32_t>(model_.records_.size());
    model_.entities_.push_back({id, line, next, next});
}

void StepEntityReader::read(const StepToken& id_token) {
    const std::uint32_t id = entityId(lexer_, id_token);
    Open open;
    open.name = fmt::format("#{}", id);
    lexer_.expect('=', open.name);
    define(id, id_token.line);
    open.complex = lexer_.peek().is('(');
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) lexer_.truncated("inside entity " + open.name, "')' and ';'");
        if (token.is(';')) break;
        parameter(open, token);
    }
    if (!open.keywords.empty())
        lexer_.damaged(lexer_.line(), "')' missing at the end of entity " + open.name);
    model_.entities_.back().last = static_cast<std::uint32_t>(model_.records_.size());
    ++result_.entities;
}

void StepEntityReader::parameter(Open& open, const StepToken& token) {
    if (token.is('='))
        lexer_.damaged(token.line, "';' missing before this entity, at the end of " + open.name);
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
            lexer_.damaged(token.line, "',' or ')' expected in " + open.name + ", found " +
                                           std::string(token.text.substr(0, 40)));
        requireRecord(open, token.line);
        open.value_before = true;
        addValue(token, open.keywords.empty() ? std::string_view{} : open.keywords.back());
    }
}

/// Values and lists stand in records alone.
void StepEntityReader::requireRecord(const Open& open, int line) {
    if (!open.record_open) lexer_.damaged(line, "a keyword and its '(' expected in " + open.name);
}

/// A parenthesis opens the set of records of a complex entity, a record or a list.
void StepEntityReader::openParenthesis(Open& open, int line) {
    if (open.keywords.size() >= kDeepestList)
        lexer_.damaged(line, fmt::format("lists are nested deeper than {} in {}", kDeepestList, open.name));
    if (open.value_before && open.pending.empty())
        lexer_.damaged(line, "',' or ')' expected in " + open.name + ", found (");
    const bool set = open.complex && open.keywords.empty();
    const bool record = !set && !open.record_open && !open.pending.empty();
    const auto next = static_cast<std::uint32_t>(model_.values_.size());
    if (!set && !record) requireRecord(open, line);
    if (record) {
        if (!open.complex && open.closed)
            lexer_.damaged(line, "';' expected after the record of " + open.name);
        model_.records_.push_back({open.pending, next, next});
        open.record_open = true;
    }
    open.lists.push_back(next);
    if (!set && !record) {
        StepValue list;
        list.kind = StepValue::Kind::List;
        model_.values_.push_back(list);
    }
    open.keywords.push_back(!open.pending.empty() || open.keywords.empty() ? open.pending
                                                                           : open.keywords.back());
    open.pending = {};
    open.value_before = false;
}

void StepEntityReader::closeParenthesis(Open& open, int line) {
    if (open.keywords.empty()) lexer_.damaged(line, "')' without '(' in entity " + open.name);
    open.keywords.pop_back();
    const std::size_t begin = open.lists.back();
    open.lists.pop_back();
    open.value_before = true;
    const std::size_t record_depth = open.complex ? 1 : 0;
    if (open.keywords.size() > record_depth) {
        if (open.record_open)
            model_.values_[begin].word = static_cast<std::uint32_t>(model_.values_.size() - begin - 1);
    } else if (open.record_open) {
        model_.records_.back().last = static_cast<std::uint32_t>(model_.values_.size());
        open.record_open = false;
        open.closed = true;
    }
}

void StepEntityReader::noteKeyword(std::string_view keyword) {
    if (isSolidBody(keyword)) ++result_.solid_bodies;
    if (keyword == "LENGTH_UNIT") result_.has_length_unit = true;
}

void StepEntityReader::word(const StepToken& token) {
    if (lexer_.peek().is('(') && !isNonFiniteWord(token.text)) return;
    if (lexer_.peek().kind == Kind::End) lexer_.truncated("inside an entity", "')' and ';'");
    if (isNonFiniteWord(token.text))
        lexer_.damaged(token.line,
                       "a finite number expected, found " + std::string(token.text.substr(0, 40)));
    lexer_.damaged(token.line,
                   "a value expected, found the bare word " + std::string(token.text.substr(0, 40)));
}

/// Every value that is read stands in the model, so that a parameter's place is its place in the file.
void StepEntityReader::addValue(const StepToken& token, std::string_view keyword) {
    StepValue value;
    if (token.kind == Kind::Number) {
        value.kind = StepValue::Kind::Number;
        value.number = finiteNumber(lexer_, token, keyword);
    } else if (token.kind == Kind::Reference) {
        value.kind = StepValue::Kind::Reference;
        value.word = entityId(lexer_, token);
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
        if (name.find('.') != std::string::npos) result_.external_files.push_back(name);
    }
    model_.values_.push_back(value);
}

}  // namespace stepmill
