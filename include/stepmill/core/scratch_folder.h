#pragma once

#include <filesystem>
#include <string_view>

namespace stepmill {

/// A new folder on this machine's own disk (TMPDIR), gone with this object and all that is in it.
class ScratchFolder {
  public:
    /// \param what_for  a word of its name: "sheets" gives stepmill-sheets-Xy12ab
    /// \throws Error(OutputUnwritable)
    explicit ScratchFolder(std::string_view what_for);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace stepmill
