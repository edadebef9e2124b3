#include "post/reader/interpreter.h"

#include "post/reader/machine.h"
#include "stepmill/core/plain_text.h"

namespace stepmill::reader {
namespace {

/// A program between its first and last line.
class Interpreter {
  public:
    Interpreter(std::string_view text, const std::string& file, const DialectRules& rules)
        : text_(withoutByteOrderMark(text)), rules_(rules), where_{file}, machine_(rules) {}

    Run run() {
        for (std::size_t from = 0; from < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', from), text_.size());
            ++where_.line;
            readLine(text_.substr(from, end - from));
            from = end + 1;
        }
        if (in_percents_ && !ended_) where_.refuse("the program has no end ('%')");
        if (!ended_) where_.refuse("the program has no end (M2 or M30)");
        return machine_.run();
    }

  private:
    void readLine(std::string_view text) {
        if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
        const Line line = lex(text, rules_, where_);
        if (line.percent) return readPercent();
        for (const std::string& comment : line.comments)
            if (!ended_) machine_.note(comment, where_);
        if (line.words.empty()) return;
        if (ended_) where_.refuse("words after the program's end");
        if (isProgramNumber(line)) return;
        any_words_ = true;
        ended_ = !machine_.obey(Block(line.words, rules_, where_), where_);
    }

    /// A program may stand between two % signs; LinuxCNC then needs no M30.
    void readPercent() {
        if (ended_) return;
        if (any_words_ && !in_percents_) where_.refuse("'%' in the middle of the program");
        ended_ = in_percents_;
        in_percents_ = true;
    }

    /// Fanuc's name of a program, "O0001", before anything else.
    bool isProgramNumber(const Line& line) const {
        const Word& word = line.words.front();
        const bool named =
            word.letter == 'O' && line.words.size() == 1 && !rules_.any_program_name && !any_words_;
        if (word.letter == 'O' && !named) where_.refuse("subroutines (O) are not read");
        return named;
    }

    std::string_view text_;
    const DialectRules& rules_;
    Where where_;
    Machine machine_;
    bool any_words_ = false;
    bool in_percents_ = false;
    bool ended_ = false;
};

}  // namespace

Run runProgram(std::string_view text, const std::string& file, Dialect dialect) {
    return Interpreter(text, file, rulesOf(dialect)).run();
}

}  // namespace stepmill::reader
