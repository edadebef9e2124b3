#include <fmt/format.h>

#include "report/page/csv_cell.h"
#include "stepmill/report/quote.h"

namespace stepmill {

using report::csvCell;

std::string quoteCsvHead() {
    return "part,material,quantity,setups,complete,time_low_min,time_high_min,price_low,price_high,"
           "piece_low,piece_high,currency\n";
}

std::string quoteCsvLines(const Quote& quote) {
    std::string lines;
    for (const QuotedLot& lot : quote.lots)
        lines +=
            fmt::format("{},{},{},{},{},{:.3f},{:.3f},{:.2f},{:.2f},{:.2f},{:.2f},{}\n",
                        csvCell(quote.part_file), csvCell(quote.material), lot.quantity, quote.setups,
                        quote.complete ? "yes" : "no", lot.time_min.low, lot.time_min.high, lot.price.low,
                        lot.price.high, lot.piece_price.low, lot.piece_price.high, csvCell(quote.currency));
    return lines;
}

}  // namespace stepmill
