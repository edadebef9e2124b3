#include "report/page/html_table.h"

#include <fmt/format.h>

#include "report/page/text.h"

namespace stepmill {

std::string cell(const std::string& text) {
    return "<td>" + escapeHtml(text) + "</td>";
}
std::string cell(double value, int decimals) {
    return fmt::format("<td class=\"n\">{:.{}f}</td>", value, decimals);
}
std::string numberCell(const std::string& text) {
    return "<td class=\"n\">" + escapeHtml(text) + "</td>";
}

std::string headRow(const std::vector<std::string>& names) {
    std::string row = "<tr>";
    for (const std::string& name : names) {
        const bool numeric = !name.empty() && name.front() == '#';
        row += fmt::format("<th{}>{}</th>", numeric ? " class=\"n\"" : "",
                           escapeHtml(numeric ? name.substr(1) : name));
    }
    return row + "</tr>\n";
}

}  // namespace stepmill
