#include <utility>

#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

constexpr std::pair<Role, const char*> kWords[] = {
    {Role::Face, "face"},           {Role::Rough, "rough"}, {Role::Rest, "rest"},
    {Role::Surrogate, "surrogate"}, {Role::Drill, "drill"}, {Role::Finish, "finish"},
};

}  // namespace

std::string toString(Role role) {
    for (const auto& [known, word] : kWords)
        if (known == role) return word;
    return "rough";
}

std::optional<Role> roleFrom(std::string_view word) {
    for (const auto& [role, known] : kWords)
        if (known == word) return role;
    return std::nullopt;
}

}  // namespace stepmill
