#include <gtest/gtest.h>

#include "stepmill/catalog/job_details.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

std::string subjectOfFailure(const std::string& text) {
    try {
        jobDetailsFromText(text, "job.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
        return error.subject();
    }
    return "no error";
}

TEST(JobDetails, AreWhatTheFileSays) {
    const JobDetails job = jobDetailsFromText(
        R"({"format": 1, "customer": "Example Ltd", "quantity": 25, "notes": ["Break edges.", "Wash."]})",
        "job.json");
    EXPECT_EQ(job.customer, "Example Ltd");
    EXPECT_EQ(job.quantity, 25);
    EXPECT_EQ(job.notes, (std::vector<std::string>{"Break edges.", "Wash."}));
    EXPECT_EQ(job.programmer, "");
}

TEST(JobDetails, MayAllBeLeftOutButTheFormat) {
    EXPECT_EQ(jobDetailsFromText(R"({"format": 1})", "job.json").quantity, 0);
    EXPECT_EQ(subjectOfFailure("{}"), "job.json#");
}

TEST(JobDetails, NameTheFieldThatIsWrong) {
    EXPECT_EQ(subjectOfFailure(R"({"format": 1, "quantity": 0})"), "job.json#/quantity");
    EXPECT_EQ(subjectOfFailure(R"({"format": 1, "notes": ["a", 5]})"), "job.json#/notes/1");
    EXPECT_EQ(subjectOfFailure(R"({"format": 1, "part": ")" + std::string(301, 'x') + "\"}"),
              "job.json#/part");
    EXPECT_NE(subjectOfFailure(R"({"format": 1, "costumer": "typing error"})"), "no error");
}

}  // namespace
}  // namespace stepmill
