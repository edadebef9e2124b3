#pragma once

#include <string>
#include <utility>

#include "post/reader/control.h"

namespace stepmill::reader {

/// A machine with its controller: obeys one block after another and notes what it does.
///
/// The order within a block is RS274/NGC's [3.8]: modes (modes.h), home, motion, stop.
class Machine {
  public:
    explicit Machine(const DialectRules& rules) : control_(rules) {}

    /// False when the program ends with the block.
    bool obey(const Block& block, const Where& where);
    void note(const std::string& comment, const Where& where);
    Run run() { return std::move(control_.run); }

  private:
    bool stop(const Block& block);

    Control control_;
};

}  // namespace stepmill::reader
