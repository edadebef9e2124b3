#include "post/comment.h"

namespace stepmill {
namespace {

/// LinuxCNC refuses lines over 252 characters; other controllers less. Long enough for any line of ours.
constexpr std::size_t kLongest = 120;

bool continuesUtf8(unsigned char c) {
    return (c & 0xC0U) == 0x80U;
}

}  // namespace

std::string comment(std::string_view text) {
    std::string inner;
    for (const char raw : text) {
        const auto c = static_cast<unsigned char>(raw);
        if (continuesUtf8(c)) continue;  // one question mark a character, not a byte
        char shown = raw;
        if (c < 0x20 || c >= 0x7F) shown = c < 0x20 ? ' ' : '?';
        if (shown == '(') shown = '[';
        if (shown == ')') shown = ']';
        // '%' ends a program and ';' starts a comment in some readers, even within brackets.
        if (shown == '%' || shown == ';') shown = ' ';
        if (inner.size() < kLongest) inner.push_back(shown);
    }
    return "(" + inner + ")";
}

}  // namespace stepmill
