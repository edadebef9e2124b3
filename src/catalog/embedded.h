#pragma once

#include <string_view>

/// The JSON files of schemas/ and samples/ that the program carries with it; written by
/// cmake/embed_files.cmake.
namespace stepmill::embedded {

extern const std::string_view kToolsSchema;
extern const std::string_view kMachineSchema;
extern const std::string_view kPlanSchema;
extern const std::string_view kInspectSchema;
extern const std::string_view kRankSchema;
extern const std::string_view kFixturesSchema;
extern const std::string_view kHolesSchema;
extern const std::string_view kVerifySchema;
extern const std::string_view kManifestSchema;
extern const std::string_view kQuoteSchema;
extern const std::string_view kJobSchema;
extern const std::string_view kMaterialsSchema;
extern const std::string_view kCuttingDataSchema;
extern const std::string_view kReplanSchema;
extern const std::string_view kDefaultTools;
extern const std::string_view kDefaultMachine;
extern const std::string_view kDefaultMaterials;
extern const std::string_view kUsualCuttingData;

}  // namespace stepmill::embedded
