#include "post/reader/lexer.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "stepmill/core/error.h"

namespace stepmill::reader {

void Where::refuse(const std::string& what) const {
    throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", file, line), what);
}

namespace {

/// LinuxCNC takes no longer lines, whatever is in them.
constexpr std::size_t kLongestLine = 252;
/// Stands in the code for a comment: words do not go on behind one.
constexpr char kCommentMark = '\x01';

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string shown(char c) {
    return c >= ' ' && c <= '~' ? fmt::format("'{}'", c)
                                : fmt::format("character {}", static_cast<unsigned char>(c));
}

/// LinuxCNC runs these instead of reading over them.
void checkHarmless(const std::string& comment, const Where& where) {
    std::string begin;
    for (const char c : comment)
        if (!isBlank(c)) begin.push_back(upper(c));
    for (const char* active : {"ABORT,", "PY,", "PROBEOPEN", "PROBECLOSE", "LOGOPEN,", "LOGAPPEND,"})
        if (begin.starts_with(active))
            where.refuse(fmt::format("a controller acts on the comment '{}'", comment));
}

/// The code of a line without blanks and comments, and the comments.
class Splitter {
  public:
    Splitter(std::string_view text, const DialectRules& rules, const Where& where)
        : text_(text), rules_(rules), where_(where) {}

    std::string code(std::vector<std::string>& comments) {
        for (std::size_t i = 0; i < text_.size(); ++i) {
            if (text_[i] == '(') {
                comments.push_back(bracketed(i));
                code_.push_back(kCommentMark);
            } else if (text_[i] == ';') {
                comments.push_back(toTheEnd(i));
                break;
            } else if (text_[i] >= 0 && text_[i] < ' ' && !isBlank(text_[i])) {
                where_.refuse("expected a word, found " + shown(text_[i]));
            } else if (!isBlank(text_[i])) {
                code_.push_back(upper(text_[i]));
            }
        }
        for (const std::string& comment : comments)
            checkHarmless(comment, where_);
        return code_;
    }

  private:
    /// \param i  of its opening bracket; then of the closing one
    std::string bracketed(std::size_t& i) const {
        const std::size_t end = text_.find_first_of("()", i + 1);
        if (end == std::string_view::npos) where_.refuse("a comment without an end");
        if (text_[end] == '(') where_.refuse("a bracket within a comment");
        const std::string comment(text_.substr(i + 1, end - i - 1));
        i = end;
        return comment;
    }

    std::string toTheEnd(std::size_t i) const {
        const std::string_view rest = text_.substr(i + 1);
        if (!rules_.semicolon_comments && !std::all_of(rest.begin(), rest.end(), isBlank))
            where_.refuse("';' ends a block on this controller, which would run what follows");
        return std::string(rest);
    }

    std::string_view text_;
    const DialectRules& rules_;
    const Where& where_;
    std::string code_;
};

/// Reads words off the code of a line.
class WordReader {
  public:
    WordReader(const std::string& code, const Where& where) : code_(code), where_(where) {}

    std::vector<Word> all() {
        while (at_ < code_.size()) {
            if (code_[at_] == kCommentMark) {
                ++at_;
            } else {
                words_.push_back(next());
            }
        }
        return std::move(words_);
    }

  private:
    Word next() {
        Word word;
        word.letter = code_[at_++];
        switch (word.letter) {
            case '/':
                where_.refuse("a block after '/' runs or not by a switch of the controller");
            case '#':
            case '[':
                where_.refuse("parameters and expressions are not read");
            case '%':
                where_.refuse("'%' stands on a line of its own");
            default:
                if (word.letter < 'A' || word.letter > 'Z')
                    where_.refuse("expected a word, found " + shown(word.letter));
        }
        readNumber(word);
        if (word.letter == 'N') checkBlockNumber(word);
        return word;
    }

    void readNumber(Word& word) {
        const std::size_t begin = at_;
        if (at_ < code_.size() && (code_[at_] == '+' || code_[at_] == '-')) ++at_;
        const std::size_t digits = at_;
        while (at_ < code_.size() && (isDigit(code_[at_]) || code_[at_] == '.'))
            ++at_;
        const std::string number = code_.substr(digits, at_ - digits);
        word.has_point = number.find('.') != std::string::npos;
        const char* end = number.data() + number.size();
        const auto [stop, error] = std::from_chars(number.data(), end, word.value, std::chars_format::fixed);
        if (error != std::errc{} || stop != end)
            where_.refuse(fmt::format("expected a number after {}, found '{}'", word.letter,
                                      readable(code_.substr(begin, at_ - begin + 1))));
        if (code_[begin] == '-') word.value = -word.value;
        if (at_ < code_.size() && (code_[at_] == '#' || code_[at_] == '['))
            where_.refuse("parameters and expressions are not read");
    }

    static std::string readable(std::string text) {
        std::erase_if(text, [](char c) { return c < ' ' || c > '~'; });
        return text;
    }

    void checkBlockNumber(const Word& word) const {
        if (!words_.empty()) where_.refuse("a block's number stands in front of it");
        if (word.has_point || word.value < 0) where_.refuse("a block's number is a whole one");
    }

    const std::string& code_;
    const Where& where_;
    std::size_t at_ = 0;
    std::vector<Word> words_;
};

std::size_t lengthOfCode(const std::string& code) {
    return code.size() - static_cast<std::size_t>(std::count(code.begin(), code.end(), kCommentMark));
}

}  // namespace

Line lex(std::string_view text, const DialectRules& rules, const Where& where) {
    if (text.size() > kLongestLine)
        where.refuse(fmt::format("{} characters in a line; controllers take {}", text.size(), kLongestLine));
    Line line;
    const std::string code = Splitter(text, rules, where).code(line.comments);
    if (lengthOfCode(code) > rules.longest_block)
        where.refuse(fmt::format("{} characters in a block; this controller takes {}", lengthOfCode(code),
                                 rules.longest_block));
    line.percent = code == "%";
    if (!line.percent) line.words = WordReader(code, where).all();
    return line;
}

}  // namespace stepmill::reader
