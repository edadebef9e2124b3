#include "part/step/lexer.h"

namespace stepmill {
namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isLetter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}
bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

std::string nameByte(char c) {
    static constexpr char kDigits[] = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte < 0x7f) return std::string("character '") + c + "'";
    return std::string("byte 0x") + kDigits[byte >> 4] + kDigits[byte & 15];
}

}  // namespace

void StepLexer::fail(ErrorCode code, int line, const std::string& message) const {
    throw Error(code, file_, "line " + std::to_string(line) + ": " + message);
}

void StepLexer::truncated(const std::string& where, const std::string& expected) const {
    damaged(line(),
            "the file ends " + where + "; " + expected + " expected. It is truncated: export it again");
}

void StepLexer::expect(char punctuation, const std::string& after) {
    const StepToken token = next();
    if (token.is(punctuation)) return;
    if (token.kind == StepToken::Kind::End) truncated("after " + after, std::string("'") + punctuation + "'");
    damaged(token.line, std::string("'") + punctuation + "' expected after " + after + ", found " +
                            std::string(token.text.substr(0, 40)));
}

void StepLexer::advance() {
    const char c = text_[pos_++];
    if (c == '\n' || (c == '\r' && at(0) != '\n')) ++line_;
}

void StepLexer::checkLength(std::size_t begin, int line, const std::string& what) const {
    if (pos_ - begin > kLongestToken)
        damaged(line, "a " + what + " of " + std::to_string(pos_ - begin) +
                          " bytes begins here; the geometry reader takes up to " +
                          std::to_string(kLongestToken));
}

void StepLexer::skipComment() {
    const int start = line_;
    const std::size_t begin = pos_;
    pos_ += 2;
    while (pos_ < text_.size()) {
        if (at(0) == '*' && at(1) == '/') {
            pos_ += 2;
            checkLength(begin, start, "comment");
            return;
        }
        advance();
    }
    damaged(start, "a comment begins here and does not end; the file is truncated");
}

void StepLexer::skipBlanks() {
    while (pos_ < text_.size()) {
        if (isBlank(at(0)))
            advance();
        else if (at(0) == '/' && at(1) == '*')
            skipComment();
        else
            return;
    }
}

StepToken StepLexer::make(StepToken::Kind kind, std::size_t begin, int line) const {
    return {kind, text_.substr(begin, pos_ - begin), line};
}

StepToken StepLexer::quoted(char quote, StepToken::Kind kind) {
    const int start = line_;
    const std::size_t begin = pos_++;
    while (pos_ < text_.size()) {
        if (at(0) != quote) {
            advance();
        } else if (at(1) == quote) {  // a doubled quote stands for one
            pos_ += 2;
        } else {
            ++pos_;
            checkLength(begin, start, "string");
            return make(kind, begin, start);
        }
    }
    damaged(start, "a string begins here and does not end; the file is truncated");
}

StepToken StepLexer::number() {
    const std::size_t begin = pos_;
    if (at(0) == '+' || at(0) == '-') ++pos_;
    while (isDigit(at(0)))
        ++pos_;
    if (at(0) == '.') ++pos_;
    while (isDigit(at(0)))
        ++pos_;
    if ((at(0) == 'E' || at(0) == 'e') && (isDigit(at(1)) || at(1) == '+' || at(1) == '-')) {
        pos_ += 2;
        while (isDigit(at(0)))
            ++pos_;
    }
    // "1.#INF", "12x": take the whole run, so that the message can show it.
    while (isLetter(at(0)) || isDigit(at(0)) || at(0) == '.' || at(0) == '#')
        ++pos_;
    return make(StepToken::Kind::Number, begin, line_);
}

StepToken StepLexer::reference() {
    const std::size_t begin = pos_++;
    while (isDigit(at(0)) || isLetter(at(0)))
        ++pos_;
    if (pos_ == begin + 1) damaged(line_, "'#' without an entity number");
    return make(StepToken::Kind::Reference, begin, line_);
}

StepToken StepLexer::enumeration() {
    const std::size_t begin = pos_++;
    while (isLetter(at(0)) || isDigit(at(0)))
        ++pos_;
    if (at(0) != '.') damaged(line_, "a value of the form .NAME. expected after '.'");
    ++pos_;
    return make(StepToken::Kind::Enumeration, begin, line_);
}

StepToken StepLexer::lex() {
    skipBlanks();
    if (pos_ >= text_.size()) return {StepToken::Kind::End, {}, line_};
    const char c = at(0);
    if (c == '\'') return quoted('\'', StepToken::Kind::String);
    if (c == '"') return quoted('"', StepToken::Kind::Binary);
    if (c == '<') return quoted('>', StepToken::Kind::Resource);
    if (c == '#' || c == '@') return reference();
    if (isDigit(c)) return number();
    if (c == '+' || c == '-') return number();
    if (c == '.') return isDigit(at(1)) ? number() : enumeration();
    const std::size_t begin = pos_;
    if (isLetter(c) || c == '!') {
        ++pos_;
        while (isLetter(at(0)) || isDigit(at(0)) || at(0) == '-')
            ++pos_;
        return make(StepToken::Kind::Word, begin, line_);
    }
    if (std::string_view("(),;=$*/&{}:").find(c) == std::string_view::npos)
        damaged(line_, nameByte(c) + " where no STEP token can begin");
    ++pos_;
    return make(StepToken::Kind::Punctuation, begin, line_);
}

const StepToken& StepLexer::peek() {
    if (!peeked_) ahead_ = lex();
    peeked_ = true;
    return ahead_;
}

StepToken StepLexer::next() {
    const StepToken token = peek();
    peeked_ = false;
    return token;
}

}  // namespace stepmill
