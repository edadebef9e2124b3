// LinuxCNC's tool.tbl: words of a letter and a number, a remark behind a semicolon.

#include <cctype>

#include <fmt/format.h>

#include "crib/tool_maker.h"
#include "crib/type_words.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

using crib::fieldText;

constexpr std::string_view kBlanks = " \t\r";

class TableLine {
  public:
    TableLine(std::string_view line, int number, const std::string& file, double mm_per_unit,
              const ForeignOptions& options)
        : line_(line), file_(file), mm_per_unit_(mm_per_unit), options_(options) {
        foreign_.place = fmt::format("line {}", number);
        foreign_.is_inch = mm_per_unit != 1;
    }

    ForeignTool read() {
        const std::size_t semicolon = line_.find(';');
        takeWords(line_.substr(0, semicolon));
        if (semicolon != std::string_view::npos) takeRemark(line_.substr(semicolon + 1));
        if (!has_number_) crib::refuse(file_, foreign_.place, "expected a tool's number T, found none");
        crib::finishTool(foreign_, 0, file_, options_);
        if (has_gauge_)
            foreign_.notes.push_back("Z is from the spindle to the tip, and no stick-out: left aside");
        return std::move(foreign_);
    }

  private:
    void takeWords(std::string_view words) {
        for (;;) {
            const std::size_t first = words.find_first_not_of(kBlanks);
            if (first == std::string_view::npos) return;
            words.remove_prefix(first);
            const std::size_t end = std::min(words.find_first_of(kBlanks), words.size());
            takeWord(words.substr(0, end));
            words.remove_prefix(end);
        }
    }

    void takeWord(std::string_view word) {
        const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
        const std::optional<double> value = crib::numberOf(word.substr(1));
        if (std::string_view("TPXYZABCUVWDIJQ").find(letter) == std::string_view::npos || !value)
            crib::refuse(
                file_, foreign_.place,
                fmt::format("expected a letter and a number such as T1, found '{}'", fieldText(word, 40)));
        if (letter == 'T') takeNumber(*value);
        if (letter == 'D') foreign_.tool.diameter_mm = *value * mm_per_unit_;
        has_gauge_ = has_gauge_ || (letter == 'Z' && *value != 0);
    }

    void takeNumber(double number) {
        if (number < 0 || number > 99999 || number != std::floor(number))
            crib::refuse(file_, foreign_.place,
                         fmt::format("expected a whole tool number of 0 to 99999, found {:g}", number));
        foreign_.tool.number = static_cast<int>(number);
        has_number_ = true;
    }

    /// Our own tables write "type: name: description".
    void takeRemark(std::string_view remark) {
        crib::TypeWord word = crib::typeOfWords(remark.substr(0, remark.find(':')));
        if (!word.type && word.unfit.empty()) word = crib::typeOfWords(remark);
        if (word.type) crib::setType(foreign_.tool, *word.type);
        foreign_.tool.description = fieldText(remark, 900);
        has_type_ = word.type.has_value();
        foreign_.unfit = word.unfit;
        if (!has_type_ && foreign_.unfit.empty()) foreign_.unfit = kNoType;
    }

    static constexpr const char* kNoType =
        "its type is not told; write it into its remark, such as ;flat end mill or ;drill";

    std::string_view line_;
    const std::string& file_;
    double mm_per_unit_;
    const ForeignOptions& options_;
    ForeignTool foreign_ = [] {
        ForeignTool untold;
        untold.unfit = kNoType;
        return untold;
    }();
    bool has_number_ = false;
    bool has_gauge_ = false;
    bool has_type_ = false;
};

}  // namespace

ForeignLibrary toolTableFromText(std::string_view text, const std::string& name,
                                 const ForeignOptions& options) {
    const double mm_per_unit = crib::toldUnitMm(options, name);
    ForeignLibrary library{name, {}};
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        const std::size_t first = line.find_first_not_of(kBlanks);
        if (first == std::string_view::npos || line[first] == ';') continue;
        if (library.tools.size() == crib::kMostTools)
            crib::refuse(name, fmt::format("line {}", number),
                         fmt::format("expected at most {} tools", crib::kMostTools));
        library.tools.push_back(TableLine(line, number, name, mm_per_unit, options).read());
    }
    return library;
}

}  // namespace stepmill
