#include "stepmill/catalog/access_table.h"

#include <charconv>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/plain_text.h"

namespace stepmill {
namespace {

constexpr std::string_view kHeader = "diameter_mm,volume_cm3,mrr_cm3_per_min";
/// No magazine or catalogue page holds more, and sequences are compared pair by pair.
constexpr std::size_t kMostCutters = 1000;

std::vector<std::string_view> splitAt(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
        pieces.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    pieces.push_back(text);
    return pieces;
}

/// What a line of a foreign file may add to a message.
std::string excerpt(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    return text.size() <= kLongest ? std::string(text) : std::string(text.substr(0, kLongest)) + "...";
}

class TableReader {
  public:
    explicit TableReader(const std::string& file_name) : file_(file_name) {}

    std::vector<AccessRow> read(std::string_view text) {
        text = withoutByteOrderMark(text);
        std::vector<AccessRow> rows;
        for (const std::string_view raw : splitAt(text, '\n')) {
            ++line_;
            const std::string_view line = trimmed(raw);
            if (line_ == 1) {
                requireHeader(line);
            } else if (!line.empty()) {
                if (rows.size() == kMostCutters)
                    fail(fmt::format("expected no more than {} cutters", kMostCutters));
                rows.push_back(readRow(line));
            }
        }
        if (rows.empty()) fail("expected a cutter, found the end of the file");
        return rows;
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", file_, line_), message);
    }

    void requireHeader(std::string_view line) const {
        std::string names;
        for (const std::string_view name : splitAt(line, ','))
            names += (names.empty() ? "" : ",") + std::string(trimmed(name));
        if (names != kHeader) fail(fmt::format("expected the header {}, found '{}'", kHeader, excerpt(line)));
    }

    AccessRow readRow(std::string_view line) const {
        const std::vector<std::string_view> cells = splitAt(line, ',');
        if (cells.size() != 3)
            fail(fmt::format("expected three numbers {}, found '{}'", kHeader, excerpt(line)));
        AccessRow row;
        row.diameter_mm = readNumber(cells[0], "a diameter_mm above 0", false);
        row.volume_cm3 = readNumber(cells[1], "a volume_cm3 of 0 or more", true);
        row.mrr_cm3_per_min = readNumber(cells[2], "an mrr_cm3_per_min above 0", false);
        return row;
    }

    double readNumber(std::string_view cell, const char* expected, bool zero_allowed) const {
        cell = trimmed(cell);
        double value = 0;
        const auto [end, trouble] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        const bool whole = trouble == std::errc() && end == cell.data() + cell.size();
        // Beyond this no quantity of a mill lies; sums and quotients stay finite.
        constexpr double kLargest = 1e12;
        constexpr double kSmallest = 1e-12;
        const bool in_range = value <= kLargest && (value >= kSmallest || (zero_allowed && value == 0));
        if (!whole || !in_range) fail(fmt::format("expected {}, found '{}'", expected, excerpt(cell)));
        return value;
    }

    const std::string& file_;
    int line_ = 0;
};

}  // namespace

std::vector<AccessRow> accessTableFromText(std::string_view text, const std::string& file_name) {
    return TableReader(file_name).read(text);
}

std::vector<AccessRow> readAccessTable(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return accessTableFromText(readFile(path, max_bytes), path.filename().string());
}

std::string accessTableCsv(const std::vector<AccessRow>& rows) {
    std::string text(kHeader);
    text += '\n';
    for (const AccessRow& row : rows)
        text += fmt::format("{},{},{}\n", row.diameter_mm, row.volume_cm3, row.mrr_cm3_per_min);
    return text;
}

}  // namespace stepmill
