#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/catalog/tool.h"
#include "stepmill/core/file.h"

namespace stepmill {

/// Which tools an entry of a table of usual values is for.
struct UsualFor {
    std::vector<ToolType> types;
    double from_mm = 0;  ///< diameters from this one
    double to_mm = 0;    ///< to below this one; 0: no end

    bool fits(const ToolAssembly& tool) const;
};

struct UsualCylinder {
    double diameter_mm = 0;
    double height_mm = 0;
};

/// Usual lengths and holder of some tools. Zero or empty: it says nothing.
struct UsualAssembly {
    UsualFor tools;
    int flutes = 0;
    double flute_length_diameters = 0;
    double stick_out_diameters = 0;
    double over_flutes_mm = 0;          ///< longer than the flutes by so much at least
    std::vector<UsualCylinder> holder;  ///< from below to above
    double life_min = 0;
    std::string source;
};

/// Usual cutting data of some tools in one material. Zero: it says nothing.
struct UsualCutting {
    UsualFor tools;
    std::string material;
    double cutting_speed_m_per_min = 0;
    double most_rpm = 0;
    double feed_per_tooth_diameters = 0;
    double feed_per_turn_diameters = 0;
    double step_over_diameters = 0;
    double step_down_diameters = 0;
    double plunge_share = 0;  ///< of the feed
    double ramp_angle_deg = 0;
    std::string source;
};

/// What an import puts where a tool's file says nothing; the first entry that fits is taken.
struct UsualValues {
    std::string file;
    std::vector<UsualAssembly> assemblies;
    std::vector<UsualCutting> cutting;
};

/// Reads a table (schemas/cutting-data.schema.json).
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject; Error(FileUnreadable)
UsualValues readUsualValues(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);
UsualValues usualValuesFromText(std::string_view text, const std::string& file_name);
/// samples/usual_cutting_data.json, compiled in.
UsualValues builtInUsualValues();

}  // namespace stepmill
