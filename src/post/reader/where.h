#pragma once

#include <string>

namespace stepmill::reader {

/// A line of a program, for what is wrong with it.
struct Where {
    const std::string& file;
    int line = 0;

    /// \throws Error(InvalidCatalog) with "file, line N" as subject
    [[noreturn]] void refuse(const std::string& what) const;
};

}  // namespace stepmill::reader
