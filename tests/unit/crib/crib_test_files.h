#pragma once

#include <nlohmann/json.hpp>

#include "stepmill/core/error.h"
#include "stepmill/crib/import_tools.h"
#include "stepmill/crib/read_foreign.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill::test {

/// A Fusion library of an end mill in its holder and a drill, to be spoilt one field at a time.
inline nlohmann::json goodFusion() {
    return nlohmann::json::parse(R"({"version": 36, "data": [
        {"type": "flat end mill", "unit": "millimeters", "description": "Three flutes, for aluminium", "BMC": "carbide",
         "vendor": "Maker", "product-id": "A-10",
         "geometry": {"DC": 10, "LCF": 24, "LB": 38, "OAL": 72, "NOF": 3, "RE": 0, "TA": 0, "SFDM": 10,
                      "shoulder-length": 26, "shoulder-diameter": 9.6, "HAND": true},
         "holder": {"unit": "millimeters", "segments": [
            {"height": 20, "lower-diameter": 28, "upper-diameter": 32},
            {"height": 40, "lower-diameter": 46, "upper-diameter": 46}]},
         "post-process": {"number": 4, "comment": ""},
         "start-values": {"presets": [
            {"name": "Rough", "material": {"category": "all", "query": "aluminium"}, "n": 9000, "v_f": 1800,
             "v_f_plunge": 500, "stepdown": 8, "stepover": 4, "use-stepdown": true, "use-stepover": true,
             "ramp-angle": 3, "tool-coolant": "mist"}]}},
        {"type": "drill", "unit": "inches", "description": "", "BMC": "hss",
         "geometry": {"DC": 0.25, "LCF": 1.5, "LB": 2.25, "NOF": 2, "SIG": 135, "SFDM": 0.25},
         "post-process": {"number": 9, "comment": "DQ"},
         "start-values": {"presets": [{"name": "steel", "n": 3000, "f_n": 0.004}]}}]})");
}

inline ForeignLibrary fusion(const nlohmann::json& library, const ForeignOptions& options = {}) {
    return fusionFromText(library.dump(), "lib.json", options);
}

/// What refuses an input, "subject: message"; an input error.
template <typename Action>
std::string refusalOf(Action action) {
    const Error error = thrownBy(action);
    EXPECT_TRUE(isInputError(error.code())) << error.what();
    return error.what();
}

/// Do the two tools agree on what Fusion has a place for?
inline void expectSameForFusion(const ToolAssembly& a, const ToolAssembly& b) {
    constexpr double kRounding = 1e-5;  // of inches written with seven decimals
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.number, b.number) << a.id;
    EXPECT_EQ(a.type, b.type) << a.id;
    EXPECT_EQ(a.flutes, b.flutes) << a.id;
    EXPECT_EQ(a.description, b.description) << a.id;
    EXPECT_EQ(a.cutter_material, b.cutter_material) << a.id;
    EXPECT_NEAR(a.diameter_mm, b.diameter_mm, kRounding) << a.id;
    EXPECT_NEAR(a.corner_radius_mm, b.corner_radius_mm, kRounding) << a.id;
    EXPECT_NEAR(a.tip_diameter_mm, b.tip_diameter_mm, kRounding) << a.id;
    EXPECT_NEAR(a.included_angle_deg, b.included_angle_deg, kRounding) << a.id;
    EXPECT_NEAR(a.point_angle_deg, b.point_angle_deg, kRounding) << a.id;
    EXPECT_NEAR(a.flute_length_mm, b.flute_length_mm, kRounding) << a.id;
    EXPECT_NEAR(a.stick_out_mm, b.stick_out_mm, kRounding) << a.id;
    EXPECT_NEAR(a.shank.diameter_mm, b.shank.diameter_mm, kRounding) << a.id;
    EXPECT_EQ(a.thread.has_value(), b.thread.has_value()) << a.id;
    ASSERT_EQ(a.holder.size(), b.holder.size()) << a.id;
    for (std::size_t i = 0; i < a.holder.size(); ++i) {
        EXPECT_NEAR(a.holder[i].diameter_mm, b.holder[i].diameter_mm, kRounding) << a.id;
        EXPECT_NEAR(a.holder[i].top_mm, b.holder[i].top_mm, kRounding) << a.id;
    }
    ASSERT_EQ(a.cutting.size(), b.cutting.size()) << a.id;
    for (std::size_t i = 0; i < a.cutting.size(); ++i) {
        EXPECT_EQ(a.cutting[i].material, b.cutting[i].material) << a.id;
        EXPECT_NEAR(a.cutting[i].feed_mm_per_min, b.cutting[i].feed_mm_per_min, kRounding) << a.id;
        EXPECT_NEAR(a.cutting[i].step_over_mm, b.cutting[i].step_over_mm, kRounding) << a.id;
        EXPECT_NEAR(a.cutting[i].step_down_mm, b.cutting[i].step_down_mm, kRounding) << a.id;
        EXPECT_EQ(a.cutting[i].speed_rpm, b.cutting[i].speed_rpm) << a.id;
        EXPECT_EQ(a.cutting[i].coolant, b.cutting[i].coolant) << a.id;
    }
}

}  // namespace stepmill::test
