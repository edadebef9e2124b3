#pragma once

#include <filesystem>

#include "stepmill/crib/foreign_library.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill::crib {

/// A bit, a library with the bits that it names, or a folder of either.
/// \throws as readForeign()
ForeignLibrary readFreeCad(const std::filesystem::path& file, const ForeignOptions& options);

}  // namespace stepmill::crib
