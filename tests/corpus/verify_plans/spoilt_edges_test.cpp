// Programs that break edges, spoilt: the proof names the line.

#include "corpus/verify_plans/spoilt_program.h"

namespace stepmill::test {
namespace {

class SpoiltEdges : public SpoiltProgram {
  protected:
    std::string part() const override { return "rounded_pocket.step"; }
    Words options() const override {
        return {"--break-edges", "0.3", "--tools",
                std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_with_forms_tools.json"};
    }

    void SetUp() override {
        SpoiltProgram::SetUp();
        edges_ = find("edge pass");
    }

    std::size_t edges_ = 0;  ///< the operation's comment
};

TEST_F(SpoiltEdges, AreProvenAsTheyWere) {
    EXPECT_EQ(verifySpoilt().exit_code, 0);
}

TEST_F(SpoiltEdges, ShowABreakThatIsDeeper) {
    const std::size_t plunge = find(" G1 Z-", edges_);
    const std::string& line = lines_[plunge];
    const std::string was =
        line.substr(line.find(" Z-"), line.find(' ', line.find(" Z-") + 1) - line.find(" Z-"));
    replace(plunge, was, fmt::format(" Z{:.4f}", std::stod(was.substr(2)) - 0.1));
    expectFails(plunge, "goes down to Z-");
}

}  // namespace
}  // namespace stepmill::test
