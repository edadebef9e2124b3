#include "report/page/csv_cell.h"

#include "stepmill/core/plain_text.h"

namespace stepmill::report {

std::string csvCell(const std::string& text) {
    std::string plain = plainLine(text);
    if (!plain.empty() && std::string_view("=+-@").find(plain.front()) != std::string_view::npos)
        plain.insert(0, "'");
    if (plain.find_first_of(",\"") == std::string::npos) return plain;
    std::string cell = "\"";
    for (const char c : plain)
        cell += c == '"' ? std::string("\"\"") : std::string(1, c);
    return cell + "\"";
}

}  // namespace stepmill::report
