#include "report/page/document.h"

#include "report/page/page_style.h"
#include "stepmill/core/file.h"

namespace stepmill::report {
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

Element policy(std::string_view style) {
    return Element("meta")
        .with("http-equiv", "Content-Security-Policy")
        .with("content", "default-src 'none'; style-src 'sha256-" + base64OfHex(sha256(style)) +
                             "'; base-uri 'none'; form-action 'none'");
}

Element headElement(const std::string& title) {
    return Element(
        "head", Element("meta").with("charset", "utf-8"), policy(kPageStyle),
        Element("meta").with("name", "viewport").with("content", "width=device-width, initial-scale=1"),
        Element("title", title), styleElement(kPageStyle));
}

}  // namespace

std::string htmlDocument(const std::string& title, Element main) {
    return "<!DOCTYPE html>\n" +
           Element("html", headElement(title), Element("body", std::move(main))).with("lang", "en").markup();
}

}  // namespace stepmill::report
