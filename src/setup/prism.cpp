#include "stepmill/setup/prism.h"

namespace stepmill {

double volumeOf(const std::vector<Prism>& prisms) {
    double volume_mm3 = 0;
    for (const Prism& prism : prisms)
        volume_mm3 += prism.volume_mm3();
    return volume_mm3;
}

}  // namespace stepmill
