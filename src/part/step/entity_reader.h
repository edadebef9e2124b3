#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "part/step/lexer.h"
#include "part/step/model.h"
#include "part/step/text.h"

namespace stepmill {

/// Lists in lists deeper than this are no part; readers recurse into them.
inline constexpr std::size_t kDeepestList = 32;

/// Reads the entities of a DATA section into a model and counts them.
/// \throws Error(StepDamaged, ImplausibleSize); the message names the line
class StepEntityReader {
  public:
    StepEntityReader(StepLexer& lexer, StepText& result, StepModel& model)
        : lexer_(lexer), result_(result), model_(model) {}

    /// \param id  its token, just read
    void read(const StepToken& id);
    /// An id that the file defines, so far without records.
    void define(std::uint32_t id, int line);

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

    void openParenthesis(Open& open, int line);
    void closeParenthesis(Open& open, int line);
    void parameter(Open& open, const StepToken& token);
    void requireRecord(const Open& open, int line);
    void addValue(const StepToken& token, std::string_view keyword);
    void word(const StepToken& token);
    void noteKeyword(std::string_view keyword);

    StepLexer& lexer_;
    StepText& result_;
    StepModel& model_;
};

}  // namespace stepmill
