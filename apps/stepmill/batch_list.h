#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch_options.h"
#include "stepmill/batch/ledger.h"

namespace stepmill {

/// What a batch is to plan.
struct BatchPlan {
    std::vector<LedgerPart> parts;  ///< in the list's order
    std::vector<BatchJob> jobs;     ///< each once, in the order of the first part of each
    /// Of each job by its key's text: its files, all of one content, and its options.
    struct Source {
        std::vector<std::filesystem::path> files;
        OptionWords options;
        double expected_s = 0;  ///< expectedSeconds()
    };
    std::map<std::string, Source> sources;
};

/// Reads the folder or list, and every file of it once. A file that cannot be read is a part with its
/// trouble.
/// \param program  version and build
/// \throws Error(Usage), Error(InvalidCatalog), Error(FileUnreadable) where list or options make no sense
BatchPlan listBatch(const BatchOptions& options, const std::string& program);

/// Version and build of this program: a build that was changed has another.
std::string programIdentity();

}  // namespace stepmill
