#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/verify/verify.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

constexpr EnumWord<FileRemark::Kind> kRemarks[] = {{FileRemark::Kind::Changed, "changed"},
                                                   {FileRemark::Kind::Missing, "missing"},
                                                   {FileRemark::Kind::NotRead, "not read"}};

std::string micrometres(double mm) {
    return std::isfinite(mm) ? fmt::format("{:.2f}", 1000 * mm) : "far";
}

std::string place(const ProofFailure& failure) {
    return failure.line > 0 ? fmt::format("{}, line {}", failure.file, failure.line) : failure.file;
}

std::string operationOf(const ProofFailure& failure) {
    return failure.operation.empty() ? "" : failure.operation + ": ";
}

std::string sentence(FileRemark::Kind kind) {
    switch (kind) {
        case FileRemark::Kind::Changed:
            return "is not as it was written; proofs are of what it is now";
        case FileRemark::Kind::Missing:
            return "was written and is gone";
        case FileRemark::Kind::NotRead:
            return "is of another dialect, and not proven here (--dialect)";
    }
    return {};
}

/// Six decimals; null for what was not found within the search.
Json number(double value) {
    if (!std::isfinite(value)) return nullptr;
    return std::round(value * 1e6) / 1e6;
}

}  // namespace

std::string verificationText(const Verification& verification) {
    std::string text =
        fmt::format("{:<8} {:<8} {:<12} {:>12} {:>11} {:>7} {:>14} {:>8} {:>8}\n", "op", "feature", "tool",
                    "clear um", "left mm2", "rapids", "holder um", "deep mm", "feed %");
    for (const OperationProof& proof : verification.operations)
        text += fmt::format("{:<8} {:<8} {:<12} {:>12} {:>11.4f} {:>7} {:>14} {:>8.3f} {:>8.1f}\n",
                            proof.operation, proof.feature, proof.tool, micrometres(proof.clearance_mm),
                            proof.left_mm2, proof.rapids_clear ? "clear" : "HIT",
                            micrometres(proof.holder_clearance_mm), proof.depth_of_cut_mm,
                            100 * proof.feed_share);
    for (const ProofFailure& failure : verification.failures)
        text += fmt::format("{}: {}{}\n", place(failure), operationOf(failure), failure.text);
    for (const FileRemark& remark : verification.remarks)
        text += fmt::format("{}: {}\n", remark.file, sentence(remark.kind));
    for (const ReasonVolume& entry : verification.left)
        text += fmt::format("stays as the plan says: {:.2f} mm3 ({})\n", entry.volume_mm3,
                            toString(entry.reason));
    if (verification.threads_missing > 0)
        text += fmt::format("no thread or fit, as the plan says: {} holes\n", verification.threads_missing);
    text += verification.proven()
                ? fmt::format("All {} operations are proven.\n", verification.operations.size())
                : fmt::format("{} proofs fail.\n", verification.failures.size());
    return text;
}

std::string verificationJson(const Verification& verification) {
    Json operations = Json::array();
    for (const OperationProof& proof : verification.operations)
        operations.push_back({{"operation", proof.operation},
                              {"feature", proof.feature},
                              {"tool", proof.tool},
                              {"file", proof.file},
                              {"line", proof.line},
                              {"clearance_mm", number(proof.clearance_mm)},
                              {"left_mm2", number(proof.left_mm2)},
                              {"rapids_clear", proof.rapids_clear},
                              {"holder_clearance_mm", number(proof.holder_clearance_mm)},
                              {"depth_of_cut_mm", number(proof.depth_of_cut_mm)},
                              {"feed_share", number(proof.feed_share)}});
    Json failures = Json::array();
    for (const ProofFailure& failure : verification.failures)
        failures.push_back({{"file", failure.file},
                            {"line", failure.line},
                            {"operation", failure.operation},
                            {"text", failure.text}});
    Json left = Json::array();
    for (const ReasonVolume& entry : verification.left)
        left.push_back({{"reason", toString(entry.reason)}, {"volume_mm3", number(entry.volume_mm3)}});
    Json remarks = Json::array();
    for (const FileRemark& remark : verification.remarks)
        remarks.push_back({{"file", remark.file}, {"is", wordOf(kRemarks, remark.kind)}});
    Json content{{"proven", verification.proven()},
                 {"operations", operations},
                 {"failures", failures},
                 {"left", left},
                 {"remarks", remarks}};
    if (verification.threads_missing > 0) content["threads_missing"] = verification.threads_missing;
    return finishJson(SchemaName::Verify, std::move(content));
}

}  // namespace stepmill
