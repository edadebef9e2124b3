#include "support/planned_parts.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/text_file.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Wall-clock time after which a plan is given up [s], so long that none is short of time (ADR 0010); what it
/// may take is for expected_outcomes.json to say.
constexpr const char* kGivenUpAfterS = "900";

/// Changes whenever the file is written anew.
std::string stamp(const fs::path& file) {
    return fmt::format("{}-{}", fs::file_size(file), fs::last_write_time(file).time_since_epoch().count());
}

std::string plainName(std::string text) {
    for (char& c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.') c = '_';
    return text;
}

/// The folder of a plan, by the part's place and the options.
fs::path placeOf(const std::string& part, const std::vector<std::string>& options) {
    const fs::path path(part);
    std::string name = path.parent_path().filename().string() + "-" + path.filename().string();
    for (const std::string& option : options)
        name += "+" + fs::path(option).filename().string();
    return fs::path(STEPMILL_PLANNED_PARTS) / stamp(stepmillBinary()) / plainName(name);
}

/// Held by one process at a time, the same process included.
class FileLock {
  public:
    explicit FileLock(const fs::path& path) : file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
        if (file_ < 0 || flock(file_, LOCK_EX) != 0) throw std::runtime_error("no lock on " + path.string());
    }
    ~FileLock() { close(file_); }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    int file_;
};

/// Plans of programs that were built before go.
void removeOlderThan(const fs::path& current) {
    for (const fs::directory_entry& entry : fs::directory_iterator(current.parent_path())) {
        std::error_code gone;
        if (entry.path() != current) fs::remove_all(entry.path(), gone);
    }
}

Json recordOf(const ProgramRun& run, const std::string& part_stamp) {
    return {{"part", part_stamp}, {"exit_code", run.exit_code}, {"out", run.out},
            {"err", run.err},     {"seconds", run.seconds},     {"cpu_s", run.cpu_s}};
}

ProgramRun runFrom(const Json& record) {
    ProgramRun run;
    run.exit_code = record.at("exit_code");
    run.out = record.at("out");
    run.err = record.at("err");
    run.seconds = record.at("seconds");
    run.cpu_s = record.at("cpu_s");
    return run;
}

}  // namespace

PlannedPart plannedPart(const std::string& part, const std::vector<std::string>& options) {
    const fs::path place = placeOf(part, options);
    const fs::path record_file = place / "run.json";
    if (fs::create_directories(place.parent_path())) removeOlderThan(place.parent_path());
    const FileLock lock(place.string() + ".lock");
    PlannedPart planned{{}, place / "plan"};
    const std::string part_stamp = stamp(part);
    if (fs::exists(record_file)) {
        const Json record = Json::parse(slurp(record_file));
        planned.run = runFrom(record);
        if (record.at("part") == part_stamp) return planned;
    }
    fs::remove_all(place);
    fs::create_directories(place);
    std::vector<std::string> words{stepmillBinary(), "plan",      part,          "-o",
                                   planned.folder,   "--timeout", kGivenUpAfterS};
    words.insert(words.end(), options.begin(), options.end());
    planned.run = runProgram(words);
    std::ofstream(record_file)
        << recordOf(planned.run, part_stamp).dump(1, ' ', false, Json::error_handler_t::replace);
    return planned;
}

void copyOfPlan(const std::string& part, const fs::path& folder, const std::vector<std::string>& options) {
    const PlannedPart planned = plannedPart(part, options);
    if (planned.run.exit_code > 1) throw std::runtime_error("no plan of " + part + ": " + planned.run.err);
    fs::copy(planned.folder, folder, fs::copy_options::recursive);
}

}  // namespace stepmill::test
