#include "batch_list.h"

#include <fmt/format.h>

#include "stepmill/batch/batch_list.h"
#include "stepmill/batch/cluster_jobs.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

std::vector<ListedPart> listedParts(const BatchOptions& options) {
    std::error_code ignored;
    if (fs::is_directory(options.source, ignored)) return findParts(options.source, options.out_dir);
    if (fs::path(options.source).extension() != ".csv")
        throw Error(ErrorCode::Usage, options.source, "expected a folder of STEP files, or a list (.csv)");
    return readPartList(options.source, readFile(options.source, options.limits.maxFileBytes()));
}

/// Adds one part after another, and hashes what several name once.
class Lister {
  public:
    Lister(const BatchOptions& options, const std::string& program) : options_(options), program_(program) {}

    void add(const ListedPart& part) {
        const OptionWords own = ownWords(part);
        LedgerPart entry{part.name, part.quantity, part.due, part.options, "", ""};
        if (!part.material.empty())
            entry.options = fmt::format("--material={} ", part.material) + part.options;
        const Words& words = wordsOf(own, part);
        try {
            const std::string step = readFile(part.file, options_.limits.maxFileBytes());
            entry.key = addJob(part, {sha256(step), words.sha256, program_}, own, words.all);
            plan_.sources[entry.key].expected_s = expectedSeconds(step);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::FileUnreadable) throw;
            entry.trouble = error.what();
        }
        plan_.parts.push_back(std::move(entry));
    }

    BatchPlan plan() && { return std::move(plan_); }

  private:
    struct Words {
        OptionWords all;  ///< the batch's and the part's own
        std::string sha256;
    };

    static OptionWords ownWords(const ListedPart& part) {
        OptionWords own;
        try {
            if (!part.options.empty()) own = optionWords(part.options);
        } catch (const Error& error) {
            throw Error(ErrorCode::Usage, part.name, error.what());
        }
        if (!part.material.empty()) own["material"] = {part.material};
        return own;
    }

    const Words& wordsOf(const OptionWords& own, const ListedPart& part) {
        const auto [at, is_new] = words_.try_emplace(own);
        if (is_new) {
            at->second.all = merged(options_.plan, own);
            try {
                planOptions(at->second.all);
                at->second.sha256 = sha256Of(at->second.all, options_.limits.maxFileBytes());
            } catch (const Error& error) {
                throw Error(ErrorCode::Usage, part.name, error.what());
            }
        }
        return at->second;
    }

    /// \return its key's text
    std::string addJob(const ListedPart& part, const JobKey& key, const OptionWords& own,
                       const OptionWords& all) {
        std::string text = key.text();
        const auto [source, is_new] = plan_.sources.try_emplace(text);
        source->second.files.push_back(part.file);
        if (!is_new) return text;
        source->second.options = all;
        BatchJob job;
        job.key = key;
        job.folder = folderName(part, key, own);
        plan_.jobs.push_back(std::move(job));
        return text;
    }

    /// The same for the same part with the same options of its own, so that a plan with other options of the
    /// batch, or by another version, takes the place of the one before.
    std::string folderName(const ListedPart& part, const JobKey& key, const OptionWords& own) const {
        return safeFolderName(part.file.stem().string(),
                              key.part_sha256 + sha256Of(own, options_.limits.maxFileBytes()));
    }

    const BatchOptions& options_;
    const std::string& program_;
    std::map<OptionWords, Words> words_;
    BatchPlan plan_;
};

}  // namespace

BatchPlan listBatch(const BatchOptions& options, const std::string& program) {
    Lister lister(options, program);
    for (const ListedPart& part : listedParts(options))
        lister.add(part);
    return std::move(lister).plan();
}

std::string programIdentity() {
    constexpr std::size_t kDigits = 12;
    const std::string build = sha256(readFile("/proc/self/exe"));
    return std::string(STEPMILL_VERSION) + "+" + build.substr(0, kDigits);
}

}  // namespace stepmill
