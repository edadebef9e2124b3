#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "stepmill/core/error.h"

namespace stepmill::test {

/// A library of two faultless tools, one with every field, to be spoilt one field at a time.
inline nlohmann::json goodLibrary() {
    return nlohmann::json::parse(R"({
        "format": 1, "unit": "mm",
        "tools": [
            {"id": "B12", "number": 7, "type": "bull", "diameter": 12, "corner_radius": 1.5, "flute_length": 26,
             "flutes": 4, "centre_cutting": true, "stick_out": 43, "shank": {"diameter": 11.5, "from": 28},
             "holder": [{"diameter": 42, "bottom": 43, "top": 64}, {"diameter": 46, "bottom": 64, "top": 109}],
             "cutting": [
                {"material": "aluminium", "step_over": 5.4, "step_down": 8, "feed": 2400, "plunge_feed": 700,
                 "ramp_angle_deg": 3, "speed_rpm": 8500},
                {"material": "steel", "step_over": 4.8, "step_down": 5, "feed": 640, "plunge_feed": 130,
                 "ramp_angle_deg": 2, "speed_rpm": 3200}],
             "price": 58.5, "life_min": 120, "description": "bull nose", "vendor": "Maker", "product_id": "X-1"},
            {"id": "D5", "number": 3, "type": "drill", "diameter": 5, "flute_length": 32, "stick_out": 50,
             "holder": [{"diameter": 28, "bottom": 50, "top": 69}],
             "cutting": [{"material": "steel", "feed": 360, "speed_rpm": 4450}]}
        ]})");
}

inline std::filesystem::path sample(const std::string& name) {
    return std::filesystem::path(STEPMILL_SOURCE_DIR) / "samples" / name;
}

/// "subject: message" and code of the Error that `action` throws; fails the test when it throws none.
template <typename Action>
Error thrownBy(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "expected an Error";
    return Error(ErrorCode::Internal, "", "");
}

}  // namespace stepmill::test
