#include "stepmill/core/scratch_folder.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <stdlib.h>

#include <fmt/format.h>

#include "stepmill/core/error.h"

namespace stepmill {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(std::string_view what_for) {
    std::error_code why;
    const fs::path parent = fs::temp_directory_path(why);
    std::string name = (parent / fmt::format("stepmill-{}-XXXXXX", what_for)).string();
    if (!why && ::mkdtemp(name.data()) == nullptr) why = {errno, std::generic_category()};
    if (why)
        throw Error(ErrorCode::OutputUnwritable, parent.empty() ? "TMPDIR" : parent.string(),
                    "no folder can be made there: " + why.message());
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace stepmill
