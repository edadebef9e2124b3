#pragma once

#include <string>
#include <string_view>

#include "stepmill/core/error.h"

namespace stepmill {

/// A token of ISO 10303-21; `text` points into the file.
struct StepToken {
    enum class Kind { End, Word, Number, String, Binary, Enumeration, Reference, Resource, Punctuation };
    Kind kind = Kind::End;
    std::string_view text;
    int line = 1;

    bool is(char punctuation) const { return kind == Kind::Punctuation && text[0] == punctuation; }
    bool isWord(std::string_view word) const { return kind == Kind::Word && text == word; }
};

/// Geometry readers have a buffer of 16384 bytes for a comment or string and give up beyond it.
inline constexpr std::size_t kLongestToken = 16000;

/// Cuts the text of a STEP file into tokens; skips blanks and comments, counts lines (LF, CRLF or CR).
/// \throws Error(StepDamaged) for a string or comment without end or longer than kLongestToken and for bytes
/// no token may hold
class StepLexer {
  public:
    StepLexer(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    StepToken next();
    const StepToken& peek();
    int line() const { return line_; }
    /// Takes the next token, which must be this.
    /// \param after  what stands before it, for the message
    void expect(char punctuation, const std::string& after);
    [[noreturn]] void fail(ErrorCode code, int line, const std::string& message) const;
    [[noreturn]] void damaged(int line, const std::string& message) const {
        fail(ErrorCode::StepDamaged, line, message);
    }
    /// The file ends here.
    /// \param where  "inside the header"
    [[noreturn]] void truncated(const std::string& where, const std::string& expected) const;

  private:
    void skipBlanks();
    void skipComment();
    void advance();
    char at(std::size_t offset) const { return pos_ + offset < text_.size() ? text_[pos_ + offset] : '\0'; }
    StepToken lex();
    StepToken quoted(char quote, StepToken::Kind kind);
    StepToken number();
    StepToken reference();
    StepToken enumeration();
    void checkLength(std::size_t begin, int line, const std::string& what) const;
    StepToken make(StepToken::Kind kind, std::size_t begin, int line) const;

    std::string_view text_;
    const std::string& file_;
    std::size_t pos_ = 0;
    int line_ = 1;
    bool peeked_ = false;
    StepToken ahead_;
};

}  // namespace stepmill
