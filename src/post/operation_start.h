#pragma once

#include <string>
#include <vector>

#include "post/dialect.h"
#include "post/motion_writer.h"
#include "post/program_header.h"
#include "stepmill/post/post.h"

namespace stepmill {

/// Writes how a program starts each operation and how it ends: away from the part where a tool changes, and
/// with all words said that the operation's moves hang on, so that it can be run from there.
class OperationStart {
  public:
    /// Keeps its arguments but `options`. `out`: the program so far, which `motion` writes to as well.
    OperationStart(const Job& job, const PostOptions& options, std::string& out, MotionWriter& motion);

    /// From one operation, or from the program's start (null), to the first place of another.
    void write(const JobOperation* before, const JobOperation& next);
    /// Spindle home, table to the part-change position, end of the program.
    void end();

    /// Units and all modal words.
    std::string safeLine() const;
    /// Of the operations written so far.
    const std::vector<StartBlock>& starts() const { return starts_; }

  private:
    void line(const std::string& text);
    /// Spindle and coolant off, up to the top of the machine's travel.
    void leave();
    void goHome();
    void putIn(const ToolAssembly& tool, bool first);
    void sayModes(const JobOperation& next);
    /// How near the controller keeps to the path; empty where that is not the program's to say.
    std::string pathWords(const JobOperation& next) const;
    void goToPartChange();

    const Job& job_;
    bool inch_;
    bool optional_stops_;
    const DialectRules& rules_;
    HomeBy home_by_;
    std::string& out_;
    MotionWriter& motion_;
    std::vector<StartBlock> starts_;
    std::string number_;  ///< of the next line; empty for all but an operation's first
};

}  // namespace stepmill
