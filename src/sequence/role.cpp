#include "stepmill/core/enum_words.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

constexpr EnumWord<Role> kRoles[] = {
    {Role::Face, "face"},   {Role::Rough, "rough"},   {Role::Rest, "rest"}, {Role::Surrogate, "surrogate"},
    {Role::Drill, "drill"}, {Role::Finish, "finish"}, {Role::Form, "form"}};

}  // namespace

std::string toString(Role role) {
    return wordOf(kRoles, role);
}

std::optional<Role> roleFrom(std::string_view word) {
    return valueOf(kRoles, word);
}

}  // namespace stepmill
