#include "stepmill/batch/batch_list.h"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>

#include "stepmill/core/csv_reader.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

constexpr int kMostPieces = 10'000'000;
/// What of a wrong cell a message repeats.
constexpr std::size_t kLongestQuote = 40;

bool isStepName(const fs::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".step" || ending == ".stp" || ending == ".p21";
}

/// Collects what lies below a folder.
class Finder {
  public:
    Finder(fs::path root, const fs::path& without) : root_(std::move(root)) {
        std::error_code none;
        without_ = fs::weakly_canonical(without, none);
    }

    /// \return why the folder cannot be read
    std::error_code look(const fs::path& folder) {
        std::error_code why;
        for (auto at = fs::directory_iterator(folder, why); !why && at != fs::directory_iterator();
             at.increment(why))
            take(*at);
        return why;
    }

    std::vector<ListedPart> parts() && {
        std::sort(parts_.begin(), parts_.end(),
                  [](const ListedPart& a, const ListedPart& b) { return a.name < b.name; });
        return std::move(parts_);
    }

  private:
    void take(const fs::directory_entry& entry) {
        std::error_code ignored;
        const bool is_folder = fs::is_directory(entry.symlink_status(ignored));
        if (is_folder)
            takeFolder(entry.path());
        else if (isStepName(entry.path()) && !fs::is_directory(entry.status(ignored)))
            add(entry.path());
    }

    void takeFolder(const fs::path& folder) {
        std::error_code ignored;
        const bool own =
            folder.filename().string().starts_with(".") || fs::weakly_canonical(folder, ignored) == without_;
        if (!own && look(folder)) add(folder);
    }

    void add(const fs::path& file) {
        ListedPart part;
        part.file = file;
        part.name = file.lexically_relative(root_).string();
        parts_.push_back(std::move(part));
    }

    fs::path root_;
    fs::path without_;
    std::vector<ListedPart> parts_;
};

/// Reads the rows of a list by its columns' names.
class ListReader {
  public:
    ListReader(const fs::path& list, const CsvRow& heads)
        : file_(list.filename().string()), folder_(list.parent_path()) {
        for (std::size_t i = 0; i < heads.cells.size(); ++i)
            takeHead(heads, i);
        if (!columns_.contains("file")) fail(heads.line, "expected a column 'file' in the first line");
    }

    ListedPart read(const CsvRow& row) const {
        if (row.cells.size() > columns_.size())
            fail(row.line, fmt::format("expected {} cells, found {}", columns_.size(), row.cells.size()));
        ListedPart part;
        part.name = cell(row, "file");
        if (part.name.empty()) fail(row.line, "expected a file, found nothing");
        part.file = folder_ / part.name;
        part.due = cell(row, "due");
        part.options = cell(row, "options");
        part.material = cell(row, "material");
        const std::string pieces = cell(row, "quantity");
        if (!pieces.empty()) part.quantity = quantity(row, pieces);
        return part;
    }

  private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", file_, line), message);
    }

    void takeHead(const CsvRow& heads, std::size_t column) {
        static const std::vector<std::string> kKnown{"file", "material", "quantity", "due", "options"};
        const std::string& head = heads.cells[column];
        const bool known = std::find(kKnown.begin(), kKnown.end(), head) != kKnown.end();
        if (!known || !columns_.emplace(head, column).second)
            fail(heads.line, fmt::format("expected the columns file, material, quantity, due, options in any "
                                         "order, each once; found '{}'",
                                         head.substr(0, kLongestQuote)));
    }

    /// Empty where the list has no such column or the row ends before it.
    std::string cell(const CsvRow& row, const std::string& head) const {
        const auto column = columns_.find(head);
        if (column == columns_.end() || column->second >= row.cells.size()) return {};
        return row.cells[column->second];
    }

    int quantity(const CsvRow& row, const std::string& text) const {
        int value = 0;
        const char* end = text.data() + text.size();
        const auto [next, trouble] = std::from_chars(text.data(), end, value);
        if (trouble != std::errc() || next != end || value < 1 || value > kMostPieces)
            fail(row.line, fmt::format("expected a quantity of 1 to {}, found '{}'", kMostPieces,
                                       text.substr(0, kLongestQuote)));
        return value;
    }

    std::string file_;
    fs::path folder_;
    std::map<std::string, std::size_t> columns_;
};

}  // namespace

std::vector<ListedPart> findParts(const fs::path& folder, const fs::path& without) {
    Finder finder(folder, without);
    if (const std::error_code why = finder.look(folder))
        throw Error(ErrorCode::FileUnreadable, folder.string(), why.message());
    std::vector<ListedPart> parts = std::move(finder).parts();
    if (parts.empty())
        throw Error(ErrorCode::FileUnreadable, folder.string(),
                    "expected STEP files (.step, .stp) in the folder or below, found none");
    return parts;
}

std::string safeFolderName(const std::string& name, std::string_view identity) {
    constexpr std::size_t kLongest = 60;
    constexpr std::size_t kDigits = 10;
    std::string safe;
    for (const char c : name.substr(0, kLongest)) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           c == '-' || c == '.';
        safe += plain ? c : '_';
    }
    if (safe.empty() || safe.front() == '.' || safe.front() == '-') safe.insert(0, "part");
    return safe + "-" + sha256(identity).substr(0, kDigits);
}

std::vector<ListedPart> readPartList(const fs::path& list, std::string_view text) {
    const std::vector<CsvRow> rows = readCsv(list.filename().string(), text);
    if (rows.empty())
        throw Error(ErrorCode::InvalidCatalog, list.filename().string(),
                    "expected a first line with the columns' names, found nothing");
    const ListReader reader(list, rows.front());
    if (rows.size() == 1)
        throw Error(ErrorCode::InvalidCatalog, list.filename().string(),
                    "expected a row for every part below the columns' names, found none");
    std::vector<ListedPart> parts;
    for (std::size_t i = 1; i < rows.size(); ++i)
        parts.push_back(reader.read(rows[i]));
    return parts;
}

}  // namespace stepmill
