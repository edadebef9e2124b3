#pragma once

#include <nlohmann/json.hpp>

namespace stepmill::report {

using Json = nlohmann::ordered_json;

/// Six decimals: a nanometre in lengths, a microsecond in times. Keeps files short and the same everywhere.
inline double number(double value) {
    constexpr double kDecimals = 1e6;
    const double rounded = std::round(value * kDecimals) / kDecimals;
    return rounded == 0 ? 0.0 : rounded;
}

template <typename Vector>
Json point(const Vector& p) {
    Json json = Json::array();
    for (const double value : p)
        json.push_back(number(value));
    return json;
}

}  // namespace stepmill::report
