#include "stepmill/core/csv_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/plain_text.h"

namespace stepmill {
namespace {

class CsvReader {
  public:
    CsvReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    std::vector<CsvRow> read() {
        while (at_ < text_.size())
            takeOne();
        endRow();
        return std::move(rows_);
    }

  private:
    void takeOne() {
        const char c = text_[at_];
        if (c == '"' && trimmed(cell_).empty() && !quoted_) return takeQuoted();
        ++at_;
        if (c == ',')
            endCell();
        else if (c == '\n')
            endRow();
        else
            cell_ += c;
    }

    /// From the opening quote to behind the closing one.
    void takeQuoted() {
        const int opened = line_;
        cell_.clear();
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\n') ++line_;
            if (text_[at_] == '"') {
                if (text_.substr(at_, 2) != "\"\"") break;
                ++at_;
            }
            cell_ += text_[at_];
        }
        if (at_ == text_.size())
            throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", file_, opened),
                        "expected a closing quote, found the end of the file");
        ++at_;
        quoted_ = true;
        quoted_cell_ = std::move(cell_);
        cell_.clear();
    }

    void endCell() {
        std::string cell = quoted_ ? std::move(quoted_cell_) : std::string();
        row_.cells.push_back(cell += trimmed(cell_));
        cell_.clear();
        quoted_ = false;
    }

    void endRow() {
        const bool blank = row_.cells.empty() && !quoted_ && trimmed(cell_).empty();
        if (blank) {
            cell_.clear();
        } else {
            endCell();
            rows_.push_back(std::move(row_));
        }
        row_ = {++line_, {}};
    }

    const std::string& file_;
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::string cell_;
    std::string quoted_cell_;
    bool quoted_ = false;
    CsvRow row_{1, {}};
    std::vector<CsvRow> rows_;
};

/// A name that holds a zero byte names another file to the system: all that stands before it.
void requireText(const std::string& file, std::string_view text) {
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) return;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", file, line),
                "expected UTF-8 text, found a zero byte; a spreadsheet's \"Unicode text\" is UTF-16");
}

}  // namespace

std::vector<CsvRow> readCsv(const std::string& file, std::string_view text) {
    text = withoutByteOrderMark(text);
    requireText(file, text);
    return CsvReader(file, text).read();
}

}  // namespace stepmill
