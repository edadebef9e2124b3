#pragma once

#include <string>
#include <vector>

#include "report/page/element.h"
#include "stepmill/core/error.h"

namespace stepmill::report {

/// A column of a table by its head. A plain string is the head of a column of words.
struct Column {
    Column(const char* text) : head(text) {}  // not explicit: stands for its head
    Column(std::string text) : head(std::move(text)) {}
    Column(std::string text, bool has_numbers) : head(std::move(text)), numbers(has_numbers) {}

    std::string head;
    bool numbers = false;  ///< ranged right, in figures of one width
};

/// A column of numbers.
inline Column numbers(const char* head) {
    return {head, true};
}

/// A column of numbers in a unit: "depth mm".
inline Column numbersIn(const char* unit, const char* head) {
    return {std::string(head) + " " + unit, true};
}

/// A table made row by row.
///
///     Table table({"tool", numbers("Ø mm")});
///     table.row(tool.id, fixed(tool.diameter_mm, 3));
class Table {
  public:
    explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

    /// Adds a row, with a string or an element for each column.
    /// \return the row, until the next one is added
    template <typename... Cells>
    Element& row(Cells&&... cells) {
        STEPMILL_CHECK(sizeof...(cells) == columns_.size(), "a row has as many cells as its table columns");
        Element row("tr");
        std::size_t column = 0;
        (row.add(Element(tagOf(column++), std::forward<Cells>(cells))), ...);
        rows_.push_back(std::move(row));
        return rows_.back();
    }

    bool empty() const { return rows_.empty(); }

    /// The table in a frame that scrolls where the table is wider than the page.
    Element element() &&;
    /// The same; nothing where there are no rows.
    std::optional<Element> elementIfAny() &&;

  private:
    Tag tagOf(std::size_t column) const { return columns_[column].numbers ? Tag("td.n") : Tag("td"); }

    std::vector<Column> columns_;
    std::vector<Element> rows_;
};

}  // namespace stepmill::report
