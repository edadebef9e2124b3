#pragma once

#include <vector>

namespace stepmill {

/// What a blank is sawn from and with how much to spare: `--stock auto` [mm].
struct BlankRule {
    double side_mm = 2;  ///< over each side of the part
    double top_mm = 1;   ///< over the top seen from the first setup's spindle: faced off there
    /// Sizes that bars and plates come in, ascending: thickness and width of the blank are rounded up to one,
    /// its greatest length to a whole millimetre. Sizes over the last are sawn to whole millimetres too.
    /// Empty: the blank is as large as the margins make it.
    std::vector<double> sizes_mm = {5,   6,   8,   10,  12,  15,  16,  20,  25,  30,  35,
                                    40,  45,  50,  55,  60,  65,  70,  75,  80,  90,  100,
                                    110, 120, 130, 140, 150, 160, 180, 200, 220, 250, 300};

    bool operator==(const BlankRule&) const = default;
};

}  // namespace stepmill
