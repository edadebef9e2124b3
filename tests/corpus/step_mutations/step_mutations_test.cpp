// Single-token damage to real STEP files: every edit ends in the same part, in the changed part the file
// really describes, in a doubt or in a refusal; never in another part in silence.
//
// STEPMILL_MUTATIONS sets the number of edits (default 200), STEPMILL_MUTATIONS_SEED the first seed,
// STEPMILL_MUTATIONS_LOG a file for a line per edit.

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "mesh_volume.h"
#include "mutate_step.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/supervise.h"
#include "stepmill/part/part.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

constexpr int kDefaultEdits = 200;
constexpr double kTimeLimit_s = 60;
constexpr double kSameShare = 1e-9;

/// Edges may lie off their faces by 1e-4 of the longest side before that is a doubt; exact faces and
/// triangles, which follow the edges, then bound volumes that differ by as much.
constexpr double kGapShare = 1e-4;

enum class Outcome { Same, Described, Doubt, Refused, Crashed, TimedOut, SilentOther };
constexpr int kOutcomes = 7;
constexpr std::array<std::string_view, kOutcomes> kOutcomeWords = {
    "same", "described", "doubt", "refused", "crash contained", "timed out", "SILENT OTHER PART"};

struct Original {
    std::string name;
    std::string text;
    std::vector<EditSpot> spots;
    double volume_mm3 = 0;
    double mesh_share = 0;  ///< what the triangles miss of the volume
};

long fromEnvironment(const char* name, long otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atol(text) : otherwise;
}

bool isDoubtful(const std::vector<Part>& parts) {
    for (const Part& part : parts)
        for (const Remark& remark : part.remarks)
            if (remark.code == "unit-doubt" || remark.code == "input-doubt") return true;
    return false;
}

double volumeOf(const std::vector<Part>& parts) {
    double volume_mm3 = 0;
    for (const Part& part : parts)
        volume_mm3 += part.count * part.volume_mm3;
    return volume_mm3;
}

/// Ten parts: ours, and shop and research parts from elsewhere where the collection is there.
std::vector<fs::path> partFiles() {
    const fs::path ours = fs::path(STEPMILL_SOURCE_DIR) / "step_parts";
    const fs::path others = fs::path(STEPMILL_SOURCE_DIR) / ".." / "shared" / "parts";
    return {ours / "rounded_pocket.step",
            ours / "plate_with_holes.step",
            ours / "die_cavity.step",
            ours / "bossed_pocket.step",
            ours / "four_setups.step",
            others / "mfcad" / "0-10-10-11-19.step",
            others / "mfcad" / "0-0-10-11-14-23.step",
            others / "machined" / "simple_block_workpiece.stp",
            others / "machined" / "hole_model.stp",
            others / "machined" / "io1-cm-214.stp"};
}

class StepMutations : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "stepmill-mutations-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        for (const fs::path& file : partFiles()) {
            if (!fs::exists(file)) continue;
            originals_.push_back(original(file));
            ASSERT_GT(originals_.back().volume_mm3, 0) << file << " was not read in time";
        }
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Read in a child: the test itself must not run OCCT before it forks.
    Original original(const fs::path& file) {
        Original result{file.filename().string(), readFile(file), {}, 0, 0};
        result.spots = editSpots(result.text);
        const fs::path note = folder_ / "original.txt";
        const Supervised run = runSupervised(
            [&](StageBoard&) {
                const double volume_mm3 = volumeOf(readStep(file));
                const std::optional<MeshVolume> mesh = meshVolume(result.text);
                const double off_mm3 = mesh ? std::abs(mesh->x_mm3 - volume_mm3) : volume_mm3;
                writeFile(note, fmt::format("{} {}", volume_mm3, off_mm3 / volume_mm3));
                return mesh ? 0 : 1;
            },
            kTimeLimit_s);
        EXPECT_EQ(run.exit_code, 0) << file;
        std::ifstream(note) >> result.volume_mm3 >> result.mesh_share;
        fs::remove(note);
        return result;
    }

    Outcome outcomeOf(const Original& original, const EditedStep& edited, std::string& words) {
        const fs::path note = folder_ / "note.txt";
        const Supervised run =
            runSupervised([&](StageBoard&) { return judge(original, edited, note); }, kTimeLimit_s);
        words = fs::exists(note) ? readFile(note) : "";
        fs::remove(note);
        if (run.end == Supervised::End::TimedOut) return Outcome::TimedOut;
        if (run.end == Supervised::End::Crashed) return Outcome::Crashed;
        return static_cast<Outcome>(run.exit_code);
    }

    int judge(const Original& original, const EditedStep& edited, const fs::path& note) {
        const fs::path file = folder_ / original.name;
        writeFile(file, edited.text);
        std::vector<Part> parts;
        try {
            parts = readStep(file);
        } catch (const Error& error) {
            writeFile(note, error.what());
            return static_cast<int>(Outcome::Refused);
        }
        const double volume_mm3 = volumeOf(parts);
        std::string words = fmt::format("{:.6f} -> {:.6f} mm3", original.volume_mm3, volume_mm3);
        for (const Part& part : parts)
            for (const Remark& remark : part.remarks)
                words += "; " + remark.text;
        writeFile(note, words);
        if (isDoubtful(parts)) return static_cast<int>(Outcome::Doubt);
        if (std::abs(volume_mm3 / original.volume_mm3 - 1) <= kSameShare)
            return static_cast<int>(Outcome::Same);
        const std::optional<MeshVolume> mesh = meshVolume(edited.text);
        if (mesh)
            words += fmt::format("; triangles {:.3f} {:.3f} {:.3f}", mesh->x_mm3, mesh->y_mm3, mesh->z_mm3);
        writeFile(note, words);
        // What triangles miss on curved faces changes a little with the part.
        const double share = kGapShare + 2 * original.mesh_share;
        const bool described = mesh && mesh->agrees(volume_mm3, share);
        return static_cast<int>(described ? Outcome::Described : Outcome::SilentOther);
    }

    fs::path folder_;
    std::vector<Original> originals_;
};

using Table = std::array<std::array<int, kOutcomes>, 3>;

std::string tableText(const Table& table) {
    std::string text = fmt::format("| {:<9} |", "edit");
    for (const std::string_view word : kOutcomeWords)
        text += fmt::format(" {} |", word);
    for (std::size_t kind = 0; kind < table.size(); ++kind) {
        text += fmt::format("\n| {:<9} |", wordOf(static_cast<EditKind>(kind)));
        for (int outcome = 0; outcome < kOutcomes; ++outcome)
            text += fmt::format(" {:>{}} |", table[kind][outcome], kOutcomeWords[outcome].size());
    }
    return text + "\n";
}

TEST_F(StepMutations, NoEditEndsInAnotherPartInSilence) {
    const long edits = fromEnvironment("STEPMILL_MUTATIONS", kDefaultEdits);
    const long first = fromEnvironment("STEPMILL_MUTATIONS_SEED", 1);
    const char* log_name = std::getenv("STEPMILL_MUTATIONS_LOG");
    std::ofstream log;
    if (log_name) log.open(log_name);
    Table table{};
    for (long seed = first; seed < first + edits; ++seed) {
        const Original& original = originals_[static_cast<std::size_t>(seed) % originals_.size()];
        const auto kind = static_cast<EditKind>(static_cast<std::size_t>(seed) / originals_.size() % 3);
        const EditedStep edited =
            editStep(original.text, original.spots, kind, static_cast<std::uint64_t>(seed));
        std::string words;
        const Outcome outcome = outcomeOf(original, edited, words);
        ++table[static_cast<std::size_t>(kind)][static_cast<std::size_t>(outcome)];
        log << fmt::format("{} | {} | {} | {} | {}\n", seed, kOutcomeWords[static_cast<std::size_t>(outcome)],
                           original.name, edited.edit, words)
            << std::flush;
        EXPECT_NE(outcome, Outcome::SilentOther)
            << "seed " << seed << ", " << original.name << ": " << edited.edit << "\n  " << words;
    }
    fmt::print("{} edits of {} parts\n{}", edits, originals_.size(), tableText(table));
}

}  // namespace
}  // namespace stepmill::test
