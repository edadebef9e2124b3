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

std::string hashSource(std::string_view text) {
    return "'sha256-" + base64OfHex(sha256(text)) + "'";
}

/// \param script  the only one of the page; empty: none runs
Element policy(std::string_view style, std::string_view script) {
    const std::string scripts = script.empty() ? "" : " script-src " + hashSource(script) + ";";
    return Element("meta")
        .with("http-equiv", "Content-Security-Policy")
        .with("content", "default-src 'none';" + scripts + " style-src " + hashSource(style) +
                             "; base-uri 'none'; form-action 'none'");
}

Element headElement(const std::string& title, std::string_view style, std::string_view script) {
    return Element(
        "head", Element("meta").with("charset", "utf-8"), policy(style, script),
        Element("meta").with("name", "viewport").with("content", "width=device-width, initial-scale=1"),
        Element("title", title), styleElement(style));
}

std::string documentOf(Element head, Element body) {
    return "<!DOCTYPE html>\n" +
           Element("html", std::move(head), std::move(body)).with("lang", "en").markup();
}

}  // namespace

std::string htmlDocument(const std::string& title, Element main) {
    return documentOf(headElement(title, kPageStyle, ""), Element("body", std::move(main)));
}

std::string printedDocument(const std::string& title, Element main, std::string_view style) {
    return documentOf(headElement(title, style, ""), Element("body", std::move(main)));
}

std::string partTableDocument(const std::string& title, Element main, Element data) {
    return documentOf(headElement(title, kPageStyle, kPartTableScript),
                      Element("body", std::move(main), std::move(data), scriptElement(kPartTableScript)));
}

}  // namespace stepmill::report
