#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/error.h"
#include "stepmill/verify/verify.h"
#include "support/told.h"

namespace stepmill {
namespace {

using Json = nlohmann::json;

/// One operation proven, with nothing near its holder, and one that fails.
Verification oneOfEach() {
    Verification verification;
    OperationProof good{"S1.O1", "S1.F1", "EM10", "S1.ngc", 12};
    good.clearance_mm = 0.0002;
    good.depth_of_cut_mm = 3.5;
    good.feed_share = 1;
    OperationProof bad = good;
    bad.operation = "S1.O2";
    bad.clearance_mm = -0.01;
    verification.operations = {good, bad};
    verification.failures = {{"S1.ngc", 40, "S1.O2", "cuts into what must stay by 0.0100 mm"}};
    verification.left = {{{Reason::CornerRadius, {}}, 1.5}};
    return verification;
}

TEST(VerificationJson, KeepsItsSchemaAndSaysWhatIsProven) {
    const std::string text = verificationJson(oneOfEach());
    EXPECT_TRUE(schemaErrors(SchemaName::Verify, text).empty());
    const Json json = Json::parse(text);
    EXPECT_FALSE(json.at("proven"));
    const Json& first = json.at("operations").at(0);
    EXPECT_TRUE(first.at("holder_clearance_mm").is_null()) << "nothing was near";
    EXPECT_EQ(first.at("depth_of_cut_mm"), 3.5);
    EXPECT_EQ(json.at("failures").at(0).at("line"), 40);
    EXPECT_EQ(json.at("left").at(0).at("reason"), "corner radius");
}

TEST(VerificationJson, TellsOfFilesThatAreNotAsTheyWereWritten) {
    Verification verification = oneOfEach();
    verification.failures.push_back({"S9.ngc", 0, "", "is a program that is not of this job"});
    verification.remarks = {{"S1.ngc", FileRemark::Kind::Changed}, {"S1.nc", FileRemark::Kind::NotRead}};
    const std::string text = verificationJson(verification);
    EXPECT_TRUE(schemaErrors(SchemaName::Verify, text).empty());
    EXPECT_EQ(Json::parse(text).at("remarks").at(1).at("is"), "not read");
    EXPECT_TRUE(test::tells(verificationText(verification), {"S9.ngc", "program"}));
    EXPECT_TRUE(test::tells(verificationText(verification), {"S1.ngc", "not as it was written"}));
}

TEST(VerificationJson, ThatBreaksItsSchemaIsABugOfOurs) {
    Verification nameless = oneOfEach();
    nameless.operations.front().tool.clear();
    try {
        verificationJson(nameless);
        FAIL() << "an operation without a tool";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Internal);
        EXPECT_NE(std::string(error.what()).find("#/operations/0/tool"), std::string::npos) << error.what();
    }
}

TEST(VerificationText, HasTheDepthOfCutAndTheFailures) {
    const std::string text = verificationText(oneOfEach());
    for (const char* words : {"deep mm", "3.500", "S1.ngc, line 40: S1.O2: cuts into", "1 proofs fail."})
        EXPECT_NE(text.find(words), std::string::npos) << words << " not in\n" << text;
}

}  // namespace
}  // namespace stepmill
