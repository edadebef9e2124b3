#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/job/job_folder.h"
#include "support/run_program.h"

namespace stepmill::test {

namespace fs = std::filesystem;

/// A small job of a part of that name with so many programs.
inline NewJob planJob(const std::string& part, int programs) {
    NewJob job{JobWriter::Plan, part + ".step", sha256("part " + part), sha256("plan of " + part), {}, {}};
    job.files.push_back({"plan.json", "", "plan of " + part});
    job.files.push_back({"report.html", "", "report of " + part});
    for (int i = 1; i <= programs; ++i) {
        const std::string id = fmt::format("S{}", i);
        job.files.push_back({id + ".ngc", "linuxcnc", id + " of " + part});
    }
    return job;
}

inline NewJob postJob(const std::string& part, const std::string& dialect,
                      const std::vector<std::string>& names) {
    NewJob job{JobWriter::Post, part + ".step", sha256("part " + part), sha256("plan of " + part), {}, {}};
    for (const std::string& name : names)
        job.files.push_back({name, dialect, name + " of " + part});
    return job;
}

inline NewJob pagesJob(const std::string& part) {
    return {JobWriter::Inspect,
            part + ".step",
            sha256("part " + part),
            "",
            {{"inspect.html", "", "page of " + part}},
            {}};
}

inline NewJob solidsJob(const std::vector<std::string>& solids) {
    return {JobWriter::Plan, "assembly.step", sha256("assembly"), "", {}, solids};
}

/// Names in a folder, sorted.
inline std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

using Files = std::map<std::string, std::string>;

/// Files of a folder but its manifest, which must name them all as they are.
inline Files filesIn(const fs::path& folder) {
    Files files;
    const std::optional<Manifest> manifest = readManifest(folder);
    for (const std::string& name : namesIn(folder)) {
        if (name == kManifestName) continue;
        files[name] = readFile(folder / name);
        const ManifestFile* file = manifest ? findFile(*manifest, name) : nullptr;
        EXPECT_TRUE(file != nullptr && file->sha256 == sha256(files[name])) << name;
    }
    return files;
}

inline Files wholeJob(const NewJob& job) {
    Files files;
    for (const NewFile& file : job.files)
        files[file.name] = file.bytes;
    return files;
}

/// A job folder below a temporary one.
class JobFixture : public testing::Test {
  protected:
    void writeJob(const NewJob& job) const { JobFolder(job_).write(job); }
    void put(const std::string& name, const std::string& text) const { writeFile(job_ / name, text); }
    bool has(const std::string& name) const { return fs::exists(job_ / name); }

    /// Code and text of the error that writing ends with.
    std::pair<ErrorCode, std::string> refusal(const NewJob& job) const {
        try {
            writeJob(job);
        } catch (const Error& error) {
            return {error.code(), error.what()};
        }
        ADD_FAILURE() << "written";
        return {ErrorCode::Internal, ""};
    }

    TemporaryFolder folder_;
    fs::path job_ = fs::path(folder_.path()) / "job";
};

}  // namespace stepmill::test
