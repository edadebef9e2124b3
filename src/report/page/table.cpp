#include "report/page/table.h"

namespace stepmill::report {

Element Table::element() && {
    Element heads("tr");
    for (const Column& column : columns_)
        heads.add(Element(column.numbers ? Tag("th.n") : Tag("th"), column.head).with("scope", "col"));
    return Element("div.scroll",
                   Element("table", Element("thead", std::move(heads)), Element("tbody", std::move(rows_))));
}

std::optional<Element> Table::elementIfAny() && {
    if (empty()) return std::nullopt;
    return std::move(*this).element();
}

}  // namespace stepmill::report
