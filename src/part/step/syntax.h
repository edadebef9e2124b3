#pragma once

#include <string>
#include <string_view>

#include "part/step/entity_reader.h"
#include "part/step/lexer.h"
#include "part/step/model.h"
#include "part/step/text.h"

namespace stepmill {

/// Reads the sections of a STEP file into a model; refuses what breaks the syntax of ISO 10303-21, numbers
/// that are none and ids no reader takes.
class StepSyntax {
  public:
    StepSyntax(std::string_view text, const std::string& file, StepText& result, StepModel& model)
        : lexer_(text, file), file_(file), result_(result), model_(model), entities_(lexer_, result, model) {}

    /// \throws Error(StepDamaged, NoSolid, ImplausibleSize); the message names the line
    void read();

  private:
    void header();
    void otherSection(const std::string& name);
    void data();

    StepLexer lexer_;
    const std::string& file_;
    StepText& result_;
    const StepModel& model_;
    StepEntityReader entities_;
    bool has_data_ = false;
};

}  // namespace stepmill
