// Programs of form cutters that are spoilt: the proof names the line.

#include <cmath>

#include <nlohmann/json.hpp>

#include "corpus/verify_plans/spoilt_program.h"

namespace stepmill::test {
namespace {

using Json = nlohmann::json;

/// The cavity of a die: a bull nose and a ball finish its walls.
class SpoiltForms : public SpoiltProgram {
  protected:
    std::string part() const override { return "die_cavity.step"; }
    Words options() const override { return {}; }

    void SetUp() override {
        SpoiltProgram::SetUp();
        form_ = find(" form z-levels");
    }

    /// A pass of the first form operation that comes down from the one above, after so many others: the lines
    /// from its plunge to the next.
    std::pair<std::size_t, std::size_t> pass(int after) const {
        std::size_t plunge = form_;
        for (int i = 0; i <= after; ++i)
            plunge = find(" G1 Z-", plunge + 1);
        return {plunge, find(" Z", plunge + 1)};
    }

    static double word(const std::string& line, char letter) {
        return std::stod(line.substr(line.find(std::string(" ") + letter) + 2));
    }

    void set(std::size_t index, char letter, double value) {
        const std::string was = lines_[index].substr(lines_[index].find(std::string(" ") + letter));
        replace(index, was.substr(0, was.find(' ', 1)), fmt::format(" {}{:.4f}", letter, value));
    }

    /// Fails at one of these lines.
    void expectFailsWithin(const std::pair<std::size_t, std::size_t>& lines, const std::string& words) const {
        const ProgramRun run = verifySpoilt();
        EXPECT_EQ(run.exit_code, 2) << run.out << run.err;
        const std::string place = "S1.ngc, line ";
        const std::size_t at = run.out.find(place);
        ASSERT_NE(at, std::string::npos) << run.out;
        const auto line = static_cast<std::size_t>(std::stoi(run.out.substr(at + place.size())));
        EXPECT_GE(line, lines.first + 1);
        EXPECT_LE(line, lines.second);
        EXPECT_NE(run.out.find(words, at), std::string::npos) << run.out;
    }

    std::size_t form_ = 0;  ///< the first form operation's comment
};

TEST_F(SpoiltForms, AreProvenAsTheyWere) {
    EXPECT_EQ(verifySpoilt().exit_code, 1) << "the plan leaves the skins of its bands";
}

TEST_F(SpoiltForms, ShowALevelThatIsLower) {
    const std::size_t plunge = pass(20).first;
    set(plunge, 'Z', word(lines_[plunge], 'Z') - 0.1);
    expectFails(plunge, "cuts into what must stay, between Z-");
}

TEST_F(SpoiltForms, ShowALevelUnderTheFloor) {
    const std::size_t plunge = pass(20).first;
    set(plunge, 'Z', -12);
    expectFails(plunge, "goes down to Z-12.0000");
}

TEST_F(SpoiltForms, ShowAPassThatIsShifted) {
    // One between two straight ways, so that all its arcs keep their radius.
    const auto is_way = [&](std::size_t line) { return lines_[line].find(" G1 X") != std::string::npos; };
    int after = 10;
    while (!is_way(pass(after).first - 1) || !is_way(pass(after).second - 1))
        ++after;
    const auto [plunge, next] = pass(after);
    for (std::size_t i = plunge - 1; i + 1 < next; ++i)
        if (lines_[i].find(" X") != std::string::npos) set(i, 'X', word(lines_[i], 'X') + 0.05);
    expectFailsWithin({plunge - 1, next}, "cuts into what must stay, between Z-");
}

TEST_F(SpoiltForms, ShowAPassThatIsLeftOut) {
    // Nothing lower makes up for the lowest of the ball's.
    const std::size_t comment = find(" form z-levels", form_ + 1);
    std::size_t last = lines_.size() - 1;
    for (int passes = 0; passes < 4; --last)
        if (lines_[last].find(" G1 Z-") != std::string::npos) ++passes;
    for (std::size_t i = last; i < lines_.size(); ++i)
        if (lines_[i].find(" X") != std::string::npos && lines_[i].find(" G0 ") == std::string::npos)
            lines_[i].clear();
    expectFails(comment, "off leaning walls, the plan counts on");
}

TEST_F(SpoiltForms, ShowAnotherTool) {
    const std::size_t change = find(" M6", form_);
    lines_[change] = "T5 M6";
    lines_[find("G43", form_)] = "G43 H5";
    expectFails(find("M8", form_) + 1, "runs with T5");
}

TEST_F(SpoiltForms, ShowThatTheyComeTooEarly) {
    // The flat operations' comments and motions go; they are to come later.
    const std::size_t flat = find("(S1.O5 ");
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(flat),
                 lines_.begin() + static_cast<std::ptrdiff_t>(form_));
    expectFails(find(" form z-levels"), "runs before S1.O5");
}

/// The same program with a tool of another form in plan.json.
class SpoiltFormTools : public SpoiltForms,
                        public testing::WithParamInterface<std::pair<const char*, double>> {};

TEST_P(SpoiltFormTools, AreShown) {
    const auto& [what, by_mm] = GetParam();
    std::ifstream file(dir_ / "plan.json");
    Json plan = Json::parse(file);
    for (Json& tool : plan["tools"])
        if (tool["type"] == "bull") tool[what] = tool[what].get<double>() + by_mm;
    std::ofstream(dir_ / "plan.json") << plan;
    expectFailsWithin({form_, find(" form z-levels", form_ + 1)}, "cuts into what must stay, between Z-");
}

INSTANTIATE_TEST_SUITE_P(BullNose, SpoiltFormTools,
                         testing::Values(std::pair("diameter_mm", 0.1), std::pair("corner_radius_mm", -0.2)),
                         [](const auto& row) { return std::string(row.param.first); });

}  // namespace
}  // namespace stepmill::test
