#include "report/page/html_page.h"

#include <array>

#include <fmt/format.h>

#include "report/page/text.h"
#include "stepmill/core/file.h"

namespace stepmill {
namespace {

constexpr std::string_view kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

unsigned hexValue(char digit) {
    return static_cast<unsigned>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
}

/// Six bits a character, filled up with "=" to four characters a group.
std::string base64OfHex(const std::string& hex) {
    std::string text;
    unsigned bits = 0;
    int count = 0;
    for (const char digit : hex) {
        bits = (bits << 4U) | hexValue(digit);
        count += 4;
        if (count < 6) continue;
        count -= 6;
        text += kBase64[(bits >> static_cast<unsigned>(count)) & 0x3FU];
        bits &= (1U << static_cast<unsigned>(count)) - 1;
    }
    if (count > 0) text += kBase64[(bits << static_cast<unsigned>(6 - count)) & 0x3FU];
    while (text.size() % 4 != 0)
        text += '=';
    return text;
}

}  // namespace

std::string pageHead(const std::string& title, const std::string& style) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-{}'; "
        "base-uri 'none'; form-action 'none'\">\n"
        "<title>{}</title>\n<style>{}</style></head>\n<body><main>\n",
        base64OfHex(sha256(style)), escapeHtml(title), style);
}

std::string pageEnd() {
    return "</main></body></html>\n";
}

}  // namespace stepmill
