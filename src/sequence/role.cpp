#include "stepmill/core/enum_words.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

constexpr EnumWord<Role> kRoles[] = {
    {Role::Face, "face"}, {Role::Rough, "rough"},   {Role::Rest, "rest"}, {Role::Surrogate, "surrogate"},
    {Role::Spot, "spot"}, {Role::Drill, "drill"},   {Role::Ream, "ream"}, {Role::Bore, "bore"},
    {Role::Tap, "tap"},   {Role::Finish, "finish"}, {Role::Form, "form"}};

}  // namespace

std::string toString(Role role) {
    return wordOf(kRoles, role);
}

bool isClearing(Role role) {
    return role == Role::Face || role == Role::Rough || role == Role::Rest || role == Role::Surrogate;
}

bool isSizing(Role role) {
    return role == Role::Ream || role == Role::Bore;
}

bool isForHoles(Role role) {
    return role == Role::Spot || role == Role::Drill || role == Role::Tap || isSizing(role);
}

std::optional<Role> roleFrom(std::string_view word) {
    return valueOf(kRoles, word);
}

}  // namespace stepmill
