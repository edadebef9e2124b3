#include "stepmill/catalog/machine.h"

#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

constexpr EnumWord<HomeBy> kHomeWays[] = {
    {HomeBy::G53, "G53"}, {HomeBy::G28, "G28"}, {HomeBy::Nothing, "nothing"}};

}  // namespace

std::string toString(HomeBy way) {
    return wordOf(kHomeWays, way);
}

std::optional<HomeBy> homeByFrom(std::string_view word) {
    return valueOf(kHomeWays, word);
}

}  // namespace stepmill
