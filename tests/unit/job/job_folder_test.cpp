// A job folder holds one job: what goes, what stays, what is refused.

#include "stepmill/job/job_folder.h"

#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "job_makers.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill::test {
namespace {

class JobFolderTest : public JobFixture {};

TEST_F(JobFolderTest, WritesAJobWithItsManifestAndNothingElse) {
    writeJob(planJob("a", 2));
    EXPECT_EQ(filesIn(job_), wholeJob(planJob("a", 2)));
    EXPECT_EQ(namesIn(folder_.path()), std::vector<std::string>{"job"});
    const Manifest manifest = *readManifest(job_);
    EXPECT_EQ(manifest.part_sha256, sha256("part a"));
    ASSERT_NE(findFile(manifest, "S1.ngc"), nullptr);
    EXPECT_EQ(findFile(manifest, "S1.ngc")->sha256, sha256("S1 of a"));
    EXPECT_EQ(findFile(manifest, "S1.ngc")->dialect, "linuxcnc");
}

TEST_F(JobFolderTest, APlanTakesThePlaceOfAllThatAnEarlierPlanAndPostsWrote) {
    writeJob(planJob("a", 4));
    writeJob(postJob("a", "fanuc", {"S1.nc", "S2.nc", "S3.nc", "S4.nc"}));
    writeJob(planJob("b", 1));
    EXPECT_EQ(filesIn(job_), wholeJob(planJob("b", 1)));
}

TEST_F(JobFolderTest, APostTakesThePlaceOfProgramsOfItsDialectAlone) {
    writeJob(planJob("a", 1));
    writeJob(postJob("a", "fanuc", {"S1.nc"}));
    writeJob(postJob("a", "grbl", {"S1-1-T5.gcode", "S1-2-T7.gcode"}));
    writeJob(postJob("a", "grbl", {"S1.gcode"}));
    EXPECT_EQ(namesIn(job_), (std::vector<std::string>{"S1.gcode", "S1.nc", "S1.ngc", "manifest.json",
                                                       "plan.json", "report.html"}));
    EXPECT_EQ(findFile(*readManifest(job_), "S1.gcode")->by, JobWriter::Post);
    EXPECT_EQ(findFile(*readManifest(job_), "S1.ngc")->by, JobWriter::Plan);
}

TEST_F(JobFolderTest, APostElsewhereReplacesThePostsOfAnotherPlan) {
    writeJob(postJob("a", "fanuc", {"S1.nc", "S2.nc"}));
    writeJob(postJob("b", "grbl", {"S1.gcode"}));
    EXPECT_EQ(namesIn(job_), (std::vector<std::string>{"S1.gcode", "manifest.json"}));
}

TEST_F(JobFolderTest, PagesStayBesideAPlanOfTheirPartAndGoWithAnother) {
    writeJob(pagesJob("a"));
    writeJob(planJob("a", 1));
    EXPECT_TRUE(has("inspect.html"));
    writeJob(planJob("b", 1));
    EXPECT_FALSE(has("inspect.html"));
    writeJob(pagesJob("b"));
    EXPECT_TRUE(has("S1.ngc"));
}

TEST_F(JobFolderTest, NothingIsWrittenBesideThePlanOfAnotherPart) {
    writeJob(planJob("a", 1));
    EXPECT_EQ(refusal(pagesJob("b")).first, ErrorCode::OutputUnwritable);
    EXPECT_EQ(refusal(postJob("b", "fanuc", {"S1.nc"})).first, ErrorCode::OutputUnwritable);
    EXPECT_EQ(filesIn(job_), wholeJob(planJob("a", 1)));
}

TEST_F(JobFolderTest, TheUsersFilesStay) {
    writeJob(planJob("a", 1));
    put("notes.txt", "worn jaws");
    fs::create_directories(job_ / "photos" / "old");
    put("photos/old/S9.ngc", "kept");
    fs::create_symlink("nowhere", job_ / "link");
    writeJob(planJob("b", 2));
    EXPECT_EQ(readFile(job_ / "notes.txt"), "worn jaws");
    EXPECT_EQ(readFile(job_ / "photos/old/S9.ngc"), "kept");
    EXPECT_TRUE(fs::is_symlink(job_ / "link"));
    EXPECT_EQ(readFile(job_ / "S2.ngc"), "S2 of b");
    EXPECT_EQ(namesIn(folder_.path()), std::vector<std::string>{"job"});
}

TEST_F(JobFolderTest, AFileBesideTheJobStaysWithItsTimeAndItsOtherNames) {
    writeJob(planJob("a", 1));
    put("notes.txt", "worn jaws");
    fs::create_hard_link(job_ / "notes.txt", fs::path(folder_.path()) / "the same");
    const auto time = fs::last_write_time(job_ / "notes.txt");
    writeJob(planJob("b", 1));
    EXPECT_EQ(fs::last_write_time(job_ / "notes.txt"), time);
    EXPECT_EQ(fs::hard_link_count(job_ / "notes.txt"), 2u);
}

TEST_F(JobFolderTest, AProgramThatIsNotOfTheJobIsNamedAndNothingIsWritten) {
    writeJob(planJob("a", 1));
    put("S9.NGC", "G0 Z-50");
    const auto [code, text] = refusal(planJob("b", 1));
    EXPECT_EQ(code, ErrorCode::OutputUnwritable);
    EXPECT_NE(text.find("S9.NGC"), std::string::npos) << text;
    EXPECT_EQ(readFile(job_ / "plan.json"), "plan of a");
    EXPECT_EQ(readFile(job_ / "S9.NGC"), "G0 Z-50");
}

TEST_F(JobFolderTest, AFileOfTheUsersIsNotOverwritten) {
    fs::create_directory(job_);
    put("report.html", "my own");
    const auto [code, text] = refusal(planJob("a", 1));
    EXPECT_EQ(code, ErrorCode::OutputUnwritable);
    EXPECT_NE(text.find("report.html"), std::string::npos) << text;
    EXPECT_EQ(namesIn(job_), std::vector<std::string>{"report.html"});
    EXPECT_EQ(readFile(job_ / "report.html"), "my own");
}

TEST_F(JobFolderTest, AFolderInThePlaceOfAProgramIsNamedAndTheJobStays) {
    writeJob(planJob("a", 2));
    fs::remove(job_ / "S1.ngc");
    fs::create_directories(job_ / "S1.ngc" / "deep");
    EXPECT_NE(refusal(planJob("b", 1)).second.find("S1.ngc"), std::string::npos);
    EXPECT_EQ(readFile(job_ / "plan.json"), "plan of a");
    EXPECT_TRUE(fs::exists(job_ / "S1.ngc" / "deep"));
}

TEST_F(JobFolderTest, FoldersOfLikeNamesBesideItAreNobodysBusiness) {
    const fs::path beside = folder_.path();
    for (const char* name : {".job.partial", ".job.stepmill-abc123", ".job.stepmill-old"}) {
        fs::create_directory(beside / name);
        writeFile(beside / name / "notes.txt", "hers");
    }
    writeJob(planJob("a", 1));
    writeJob(planJob("b", 1));
    for (const char* name : {".job.partial", ".job.stepmill-abc123", ".job.stepmill-old"})
        EXPECT_EQ(readFile(beside / name / "notes.txt"), "hers") << name;
}

TEST_F(JobFolderTest, ProgramsThatWereEditedAreNamedWhenTheyAreReplaced) {
    writeJob(planJob("a", 2));
    put("S2.ngc", "mine");
    JobFolder job(job_);
    job.write(planJob("b", 2));
    EXPECT_EQ(job.replacedEdits(), std::vector<std::string>{"S2.ngc"});
}

TEST_F(JobFolderTest, WritesIntoTheCurrentFolderWithoutMovingIt) {
    writeJob(planJob("a", 2));
    const fs::path before = fs::current_path();
    fs::current_path(job_);
    JobFolder(".").write(planJob("b", 1));
    const bool still_there = fs::exists("plan.json");
    fs::current_path(before);
    EXPECT_TRUE(still_there);
    EXPECT_EQ(filesIn(job_), wholeJob(planJob("b", 1)));
}

TEST_F(JobFolderTest, ALinkToAFolderStaysALink) {
    fs::create_directory(fs::path(folder_.path()) / "real");
    fs::create_directory_symlink("real", job_);
    writeJob(planJob("a", 1));
    EXPECT_TRUE(fs::is_symlink(job_));
    EXPECT_EQ(filesIn(fs::path(folder_.path()) / "real"), wholeJob(planJob("a", 1)));
}

TEST_F(JobFolderTest, LinksAmongItsFilesAreReplacedAndNotFollowed) {
    writeJob(planJob("a", 1));
    writeFile(fs::path(folder_.path()) / "victim", "unharmed");
    fs::remove(job_ / "S1.ngc");
    fs::create_symlink(fs::path(folder_.path()) / "victim", job_ / "S1.ngc");
    writeJob(planJob("b", 1));
    EXPECT_EQ(readFile(fs::path(folder_.path()) / "victim"), "unharmed");
    EXPECT_EQ(filesIn(job_), wholeJob(planJob("b", 1)));
}

TEST_F(JobFolderTest, KeepsThePermissionsOfTheFolder) {
    fs::create_directory(job_);
    fs::permissions(job_, fs::perms(0750));
    writeJob(planJob("a", 1));
    EXPECT_EQ(fs::status(job_).permissions(), fs::perms(0750));
}

TEST_F(JobFolderTest, ASecondWriterGetsAMessageAndADeadOnesLockDoesNotBlock) {
    writeFile(fs::path(folder_.path()) / ".job.stepmill-lock", "");
    {
        const JobFolder first(job_);
        const auto [code, text] = refusal(planJob("b", 1));
        EXPECT_EQ(code, ErrorCode::OutputUnwritable);
        EXPECT_NE(text.find("another run"), std::string::npos) << text;
    }
    writeJob(planJob("b", 1));
    EXPECT_EQ(namesIn(folder_.path()), std::vector<std::string>{"job"});
}

TEST_F(JobFolderTest, MakesParentsAndTakesThemAwayWhereNothingIsWritten) {
    const fs::path deep = fs::path(folder_.path()) / "a" / "b" / "job";
    { const JobFolder unused(deep); }
    EXPECT_TRUE(fs::is_empty(folder_.path()));
    JobFolder(deep).write(planJob("a", 1));
    EXPECT_EQ(filesIn(deep), wholeJob(planJob("a", 1)));
}

TEST_F(JobFolderTest, TakesANameOfTheGreatestLength) {
    const fs::path longest = fs::path(folder_.path()) / std::string(255, 'n');
    JobFolder(longest).write(planJob("a", 1));
    JobFolder(longest).write(planJob("b", 1));
    EXPECT_EQ(filesIn(longest), wholeJob(planJob("b", 1)));
}

TEST_F(JobFolderTest, FoldersOfSolidsAreJobsOfTheirOwnAndGoWithTheJobAbove) {
    JobFolder(job_ / "solid-0").write(planJob("a", 1));
    JobFolder(job_ / "solid-1").write(planJob("b", 1));
    writeJob(solidsJob({"solid-0", "solid-1"}));
    EXPECT_EQ(readManifest(job_)->solids.size(), 2u);
    writeJob(solidsJob({"solid-0"}));
    EXPECT_EQ(namesIn(job_), (std::vector<std::string>{"manifest.json", "solid-0"}));
    writeJob(planJob("c", 1));
    EXPECT_EQ(filesIn(job_), wholeJob(planJob("c", 1)));
}

TEST_F(JobFolderTest, ASolidsFolderWithAFileOfTheUsersIsNotRemoved) {
    JobFolder(job_ / "solid-0").write(planJob("a", 1));
    writeJob(solidsJob({"solid-0"}));
    put("solid-0/notes.txt", "hers");
    EXPECT_NE(refusal(planJob("c", 1)).second.find("notes.txt"), std::string::npos);
    EXPECT_EQ(readFile(job_ / "solid-0" / "S1.ngc"), "S1 of a");
}

TEST_F(JobFolderTest, ADamagedManifestIsRefusedWithItsPlace) {
    writeJob(planJob("a", 1));
    put("manifest.json", R"({"format": 1, "stepmill": {"version": "1"}, "part": {"file": "", "sha256": ")" +
                             std::string(64, '0') +
                             R"("}, "files": [{"name": "../../etc/passwd", "by": "plan",
                             "size_bytes": 1, "sha256": ")" +
                             std::string(64, '0') + "\"}]}");
    const auto [code, text] = refusal(planJob("b", 1));
    EXPECT_EQ(code, ErrorCode::InvalidCatalog);
    EXPECT_NE(text.find("#/files/0/name"), std::string::npos) << text;
}

TEST_F(JobFolderTest, CheckingFindsWhatIsChangedMissingAndStrange) {
    writeJob(planJob("a", 3));
    put("S1.ngc", "edited");
    fs::remove(job_ / "S2.ngc");
    put("O0001.NC", "whose?");
    const JobCheck check = checkJob(job_);
    EXPECT_TRUE(check.has_manifest);
    EXPECT_EQ(check.changed, std::vector<std::string>{"S1.ngc"});
    EXPECT_EQ(check.missing, std::vector<std::string>{"S2.ngc"});
    EXPECT_EQ(check.programs, std::vector<std::string>{"O0001.NC"});
}

TEST_F(JobFolderTest, TheManifestIsTheSameForTheSameJob) {
    writeJob(planJob("a", 3));
    const std::string first = readFile(job_ / "manifest.json");
    writeJob(planJob("b", 1));
    writeJob(planJob("a", 3));
    EXPECT_EQ(readFile(job_ / "manifest.json"), first);
    EXPECT_EQ(manifestJson(manifestFromText(first)), first);
}

}  // namespace
}  // namespace stepmill::test
