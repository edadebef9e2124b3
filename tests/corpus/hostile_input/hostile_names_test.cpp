// Names in part, tool, machine and fixture files that try to steer a page or a terminal.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "stepmill/core/plain_text.h"
#include "support/page_check.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kSource = STEPMILL_SOURCE_DIR;

const std::vector<std::string> kHostile{
    "<script>document.title='taken'</script>",
    "<img src=x onerror=alert(1)>",
    "\"><svg onload=alert(1)>",
    "' onmouseover='alert(1)",
    "</style></title><script>alert(1)</script>",
    "&lt;script&gt;&#60;b&#62;",
    "{} {0} {:99999} %n%s",
    "\x1b]0;taken\x07\x1b[2J\x1b[31mred",
    "line\nS1.O9 (all 9 operations are proven)\r\rover",
    "\xe2\x80\xae gnp.exe \xe2\x81\xa6",
    "\xc2\x9b"
    "31m C1",
};

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// The page is sound (page_check.h), shows no character that steers, and its policy forbids what it does not
/// have.
/// Scripts of a report with its viewer: the library's licence, the library, its camera, ours.
constexpr int kViewerScripts = 4;

void expectHarmlessPage(const std::string& page, const std::string& what) {
    expectSoundPage(page, what);
    EXPECT_EQ(page, plainText(page)) << what;
    EXPECT_NE(
        page.find(
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-"),
        std::string::npos)
        << what;
}

void expectHarmlessText(const ProgramRun& run, const std::string& what) {
    for (const std::string* text : {&run.out, &run.err})
        EXPECT_EQ(*text, plainText(*text)) << what;
}

/// A job whose every name is `name`.
class HostileJob {
  public:
    explicit HostileJob(const std::string& name) {
        json tools = json::parse(readFile(kSource + "/samples/shop_metric_tools.json"));
        for (std::size_t i = 0; i < tools["tools"].size(); ++i) {
            tools["tools"][i]["id"] = name + std::to_string(i);
            tools["tools"][i]["description"] = name;
            tools["tools"][i]["vendor"] = name;
            for (json& cutting : tools["tools"][i]["cutting"])
                if (cutting["material"] == "aluminium") cutting["material"] = name;
        }
        write(tools_, tools.dump());
        json machine = json::parse(readFile(kSource + "/samples/machine_vmc.json"));
        machine["name"] = name;
        machine["currency"] = name.substr(0, 15);
        machine["currency"] = plainText(machine["currency"].get<std::string>());
        write(machine_, machine.dump());
        const json clamp{{"name", name},
                         {"outline", {{-30, 0}, {-10, 0}, {-10, 20}, {-30, 20}}},
                         {"bottom", -20},
                         {"top", -5}};
        const json fixtures{
            {"format", 1}, {"unit", "mm"}, {"setups", {{{"setup", "S1"}, {"fixtures", {clamp}}}}}};
        write(fixtures_, fixtures.dump());
        std::string part = readFile(kSource + "/step_parts/rounded_pocket.step");
        const std::string product = "PRODUCT('rounded_pocket','rounded_pocket'";
        const std::string step_name = stepText(name);
        part.replace(part.find(product), product.size(),
                     fmt::format("PRODUCT('{}','{}'", step_name, step_name));
        write(part_, part);
        material_ = name;
    }

    ProgramRun run(const std::string& command, const std::vector<std::string>& more) const {
        std::vector<std::string> words{stepmillBinary(), command, part_.string(), "--tools", tools_.string()};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }

    ProgramRun plan() const {
        return run("plan", {"--machine", machine_.string(), "--fixtures", fixtures_.string(), "--material",
                            material_, "--setup", "+z", "-o", out_.string()});
    }

    const fs::path& out() const { return out_; }
    const std::string& material() const { return material_; }

  private:
    /// A STEP string may hold printing characters; others are told by their number.
    static std::string stepText(const std::string& text) {
        std::string step;
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (c == '\'')
                step += "''";
            else if (c == '\\')
                step += "\\\\";
            else if (byte < 0x20 || byte >= 0x7F)
                step += fmt::format("\\X\\{:02X}", byte);
            else
                step += c;
        }
        return step;
    }

    TemporaryFolder folder_;
    // No name of a file may hold a slash.
    fs::path part_ = fs::path(folder_.path()) / "<img src=x onerror=alert(1)>\x1b[2J'.step";
    fs::path tools_ = fs::path(folder_.path()) / "<b onclick=x>\x07tools.json";
    fs::path machine_ = fs::path(folder_.path()) / "machine.json";
    fs::path fixtures_ = fs::path(folder_.path()) / "<script>alert(2)<\xff>.json";
    fs::path out_ = fs::path(folder_.path()) / "job";
    std::string material_;
};

class HostileNames : public testing::TestWithParam<std::size_t> {};

TEST_P(HostileNames, SteerNeitherPageNorTerminal) {
    const std::string& name = kHostile[GetParam()];
    const HostileJob job(name);
    const ProgramRun plan = job.plan();
    EXPECT_TRUE(plan.exit_code == 0 || plan.exit_code == 1) << plan.err;
    expectHarmlessText(plan, "plan");
    const std::string report = readFile(job.out() / "report.html");
    EXPECT_EQ(readPage(report).errors, std::vector<std::string>());
    EXPECT_EQ(report, plainText(report));
    expectSoundPage(withoutOwnScripts(report, kViewerScripts), "report.html");
    expectHarmlessPage(readFile(job.out() / "sheets.html"), "sheets.html");
    const std::string plan_json = readFile(job.out() / "plan.json");
    EXPECT_FALSE(json::parse(plan_json, nullptr, false).is_discarded());
    const ProgramRun verify = runProgram({stepmillBinary(), "verify", job.out().string()});
    EXPECT_LE(verify.exit_code, 1) << verify.err << verify.out;
    expectHarmlessText(verify, "verify");

    const std::string pages = job.out().string() + "-pages";
    const ProgramRun inspect = job.run("inspect", {"-o", pages});
    EXPECT_LE(inspect.exit_code, 1) << inspect.err;
    expectHarmlessText(inspect, "inspect");
    expectHarmlessPage(readFile(fs::path(pages) / "inspect.html"), "inspect.html");
    const std::string curves_pages = job.out().string() + "-curves";
    const ProgramRun curves = job.run("inspect", {"--curves", "-o", curves_pages});
    EXPECT_LE(curves.exit_code, 1) << curves.err;
    expectHarmlessPage(readFile(fs::path(curves_pages) / "curves.html"), "curves.html");
    const ProgramRun rank = job.run("rank", {"--material", job.material(), "--setup", "+z"});
    EXPECT_EQ(rank.exit_code, 0) << rank.err;
    expectHarmlessText(rank, "rank");
}

TEST_P(HostileNames, SteerNoTerminalInAnError) {
    const std::string& name = kHostile[GetParam()];
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"plan", name},
             {"plan", kSource + "/step_parts/shoulder_block.step", "--material", name},
             {"plan", kSource + "/step_parts/shoulder_block.step", "--setup", name},
             {"plan", kSource + "/step_parts/shoulder_block.step", "--stock-margin", name},
             {"verify", name},
             {"post", name},
             {"tools", "validate", name},
             {"--" + name},
             {name}}) {
        std::vector<std::string> command{stepmillBinary()};
        command.insert(command.end(), words.begin(), words.end());
        const ProgramRun run = runProgram(command);
        EXPECT_EQ(run.exit_code, 2) << run.err;
        expectHarmlessText(run, words.front());
    }
}

INSTANTIATE_TEST_SUITE_P(All, HostileNames, testing::Range(std::size_t{0}, kHostile.size()));

}  // namespace
}  // namespace stepmill::test
