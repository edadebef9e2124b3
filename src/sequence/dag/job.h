#pragma once

#include "sequence/holder/tool_areas.h"
#include "stepmill/access/access.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// What the sequence of one feature is made from. Owns all of it, and whatever points into it shares the job:
/// so choices can be taken long after sequenceTools() has returned.
struct SequenceJob {
    SequenceJob(const Feature& of, const ToolLibrary& tools, const Machine& mill,
                const SequenceOptions& asked, const Tolerances& tol)
        : ground(of, asked.finish.walls_mm > 0 ? withoutFit(tol) : tol),
          around(surroundingsOf(ground.feature())),
          library(tools),
          machine(mill),
          options(asked),
          // z = 0 is the stock's top, so the height over it is the retract plane's z.
          retract_z_mm(asked.retract_mm > 0 ? asked.retract_mm : mill.safe_height_mm) {}

    const FeatureGround ground;
    const Surroundings around;
    const ToolLibrary library;
    const Machine machine;
    const SequenceOptions options;
    const double retract_z_mm;

    const Feature& feature() const { return ground.feature(); }
    const Tolerances& tolerances() const { return ground.tolerances(); }
    /// Called before each dear piece of work.
    /// \throws Error(TimedOut) after the options' deadline
    void checkTime() const { options.deadline.check(feature().id); }

  private:
    /// Walls that get a pass of their own leave no room for a cutter as wide as the slot.
    static Tolerances withoutFit(Tolerances tol) {
        tol.fit_mm = 0;
        return tol;
    }
};

}  // namespace stepmill
