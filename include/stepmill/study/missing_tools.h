#pragma once

#include <set>
#include <string>
#include <vector>

#include "stepmill/plan/hole_wishes.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// A tool without which something is not made as asked, whatever the time: a tap or a reamer that the hole
/// table calls for, a chamfer mill of the angle of the part's chamfers.
struct MissingTool {
    std::string tool;   ///< "tap M8x1.25", "reamer 8 H7", "chamfer mill, 90 degrees"
    std::string gives;  ///< "the thread", "the fit", "chamfers and countersinks"
    int holes = 0;      ///< served: of a chamfer mill countersinks
    int faces = 0;      ///< of a chamfer mill: chamfers and countersinks
};

/// Looks through a part's setups for what its library has no tool for.
class MissingTools {
  public:
    /// Keeps its arguments.
    MissingTools(const HoleWishes& wishes, const ToolLibrary& library, const std::string& material);

    void look(const Stage& stage);
    /// In the order in which they were found.
    const std::vector<MissingTool>& list() const { return list_; }

  private:
    void lookAtWish(const HoleWish& wish, double diameter_mm);
    void lookAtChamfers(const LayerStack& layers);
    template <typename Serves>
    bool hasTool(Serves serves) const;
    MissingTool& named(const std::string& tool, const std::string& gives);

    const HoleWishes& wishes_;
    const ToolLibrary& library_;
    const std::string& material_;
    std::vector<MissingTool> list_;
    std::set<int> chamfers_;  ///< faces that were counted: several setups may see one
};

}  // namespace stepmill
