#pragma once

#include <cstdlib>
#include <string>

namespace stepmill {

/// "S1.F12" and "S1.O12" are 12.
inline int numberOfId(const std::string& id) {
    return std::atoi(id.c_str() + id.find_last_not_of("0123456789") + 1);
}

}  // namespace stepmill
