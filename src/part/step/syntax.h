#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "part/step/lexer.h"
#include "part/step/model.h"
#include "part/step/text.h"

namespace stepmill {

/// Ids beyond this are cut to 32 bits by geometry readers, where they become those of other entities.
inline constexpr std::uint64_t kLargestId = 2147483647;

/// Lists in lists deeper than this are no part; readers recurse into them.
inline constexpr std::size_t kDeepestList = 32;

/// Reads the sections, entities and parameters of a STEP file into a model; refuses what breaks the syntax of
/// ISO 10303-21, numbers that are none and ids no reader takes.
class StepSyntax {
  public:
    StepSyntax(std::string_view text, const std::string& file) : lexer_(text, file), file_(file) {}

    /// \throws Error(StepDamaged, NoSolid, ImplausibleSize); the message names the line
    void read(StepText& result, StepModel& model);

  private:
    /// An entity while its parameters are read.
    struct Open {
        std::string name;                        ///< "#12"
        std::vector<std::string_view> keywords;  ///< one per open parenthesis
        std::vector<std::size_t> lists;          ///< places of the List values that are open
        std::string_view pending;                ///< keyword just read, its parenthesis still to come
        bool value_before = false;
        bool complex = false;
        bool record_open = false;
        bool closed = false;  ///< a record was read to its end
    };

    void header();
    void otherSection(const std::string& name);
    void data();
    void entity(const StepToken& id);
    void openParenthesis(Open& open, int line);
    void closeParenthesis(Open& open, int line);
    void parameter(Open& open, const StepToken& token);
    void requireRecord(const Open& open, int line);
    void addValue(const StepToken& token, std::string_view keyword);
    double number(const StepToken& token, std::string_view keyword);
    void word(const StepToken& token);
    void noteKeyword(std::string_view keyword);
    void define(std::uint32_t id, int line);
    void expect(char punctuation, const std::string& after);
    std::uint32_t idOf(const StepToken& token);
    [[noreturn]] void truncated(const std::string& where, const std::string& expected);
    [[noreturn]] void damaged(int line, const std::string& message) {
        lexer_.fail(ErrorCode::StepDamaged, line, message);
    }

    StepLexer lexer_;
    const std::string& file_;
    StepText* result_ = nullptr;
    StepModel* model_ = nullptr;
    bool has_data_ = false;
};

}  // namespace stepmill
