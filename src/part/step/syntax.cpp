#include "part/step/syntax.h"

#include "part/step/token_values.h"

namespace stepmill {
namespace {

using Kind = StepToken::Kind;

}  // namespace

void StepSyntax::header() {
    lexer_.expect(';', "HEADER");
    bool in_schema = false;
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) lexer_.truncated("inside the header", "ENDSEC; and a DATA section");
        if (token.isWord("DATA")) lexer_.damaged(token.line, "ENDSEC; expected before DATA");
        if (token.isWord("ENDSEC")) break;
        if (token.isWord("FILE_SCHEMA")) in_schema = true;
        if (token.is(';')) in_schema = false;
        if (in_schema && token.kind == Kind::String) result_.schemas.push_back(unquote(token.text));
    }
    lexer_.expect(';', "ENDSEC");
}

/// ANCHOR, REFERENCE and SIGNATURE of edition 3: only the ids a REFERENCE section brings in matter.
void StepSyntax::otherSection(const std::string& name) {
    while (true) {
        const StepToken token = lexer_.next();
        if (token.kind == Kind::End) lexer_.truncated("inside the " + name + " section", "ENDSEC;");
        if (token.isWord("ENDSEC")) break;
        if (name == "REFERENCE" && token.kind == Kind::Reference && lexer_.peek().is('='))
            entities_.define(entityId(lexer_, token), token.line);
    }
    lexer_.expect(';', "ENDSEC");
}

void StepSyntax::data() {
    has_data_ = true;
    while (!lexer_.peek().is(';')) {  // edition 3 allows parameters after DATA
        if (lexer_.next().kind == Kind::End) lexer_.truncated("after DATA", "';'");
    }
    lexer_.next();
    while (true) {
        const StepToken token = lexer_.next();
        if (token.isWord("ENDSEC")) break;
        if (token.kind == Kind::Reference) {
            entities_.read(token);
        } else if (token.kind == Kind::End) {
            const std::string last = model_.entities().empty()
                                         ? ""
                                         : " after entity #" + std::to_string(model_.entities().back().id);
            lexer_.truncated("inside the DATA section" + last, "ENDSEC; and END-ISO-10303-21;");
        } else {
            lexer_.damaged(token.line, "an entity '#number=' or ENDSEC expected, found " +
                                           std::string(token.text.substr(0, 40)));
        }
    }
    lexer_.expect(';', "ENDSEC");
}

void StepSyntax::read() {
    lexer_.next();  // ISO-10303-21, seen by the caller
    lexer_.expect(';', "ISO-10303-21");
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
            if (has_data_) lexer_.truncated("after the DATA section", "END-ISO-10303-21;");
            lexer_.truncated("before any DATA section", "DATA;");
        } else {
            lexer_.damaged(token.line, "a section (HEADER, DATA) or END-ISO-10303-21 expected, found " +
                                           std::string(token.text.substr(0, 40)));
        }
    }
    if (!has_data_) lexer_.damaged(lexer_.line(), "the file has no DATA section");
    if (result_.entities == 0)
        throw Error(ErrorCode::NoSolid, file_, "the DATA section is empty; there is no part in this file");
}

}  // namespace stepmill
