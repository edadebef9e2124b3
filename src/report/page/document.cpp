#include "report/page/document.h"

#include <vector>

#include <fmt/format.h>

#include "report/page/base64.h"
#include "report/page/page_style.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill::report {
namespace {

std::uint8_t hexValue(char digit) {
    return static_cast<std::uint8_t>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
}

std::vector<std::uint8_t> bytesOfHex(const std::string& hex) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(hexValue(hex[i]) * 16 + hexValue(hex[i + 1])));
    return bytes;
}

std::string hashSource(std::string_view text) {
    return "'sha256-" + base64(bytesOfHex(sha256(text))) + "'";
}

/// \param scripts  as they stand in the page; without any none runs
Element policy(std::string_view style, const std::vector<std::string>& scripts) {
    std::string allowed;
    for (const std::string& script : scripts)
        allowed += (allowed.empty() ? " script-src " : " ") + hashSource(script);
    return Element("meta")
        .with("http-equiv", "Content-Security-Policy")
        .with("content",
              fmt::format("default-src 'none';{}{} style-src {}; base-uri 'none'; form-action 'none'",
                          allowed, allowed.empty() ? "" : ";", hashSource(style)));
}

Element headElement(const std::string& title, std::string_view style,
                    const std::vector<std::string>& scripts) {
    return Element(
        "head", Element("meta").with("charset", "utf-8"), policy(style, scripts),
        Element("meta").with("name", "viewport").with("content", "width=device-width, initial-scale=1"),
        Element("title", title), styleElement(style));
}

/// A script as both readers of a page take it, HTML's and XML's: the marks of its ends are comments to the
/// one and keep "<" and "&" text to the other.
std::string forBothReaders(std::string_view script) {
    for (const char* end : {"]]>", "</script", "<!--"})
        STEPMILL_CHECK(script.find(end) == std::string_view::npos, "a script stays within its element");
    return "//<![CDATA[\n" + std::string(script) + "\n//]]>";
}

std::string documentOf(Element head, Element body) {
    return "<!DOCTYPE html>\n" +
           Element("html", std::move(head), std::move(body)).with("lang", "en").markup();
}

}  // namespace

std::string htmlDocument(const std::string& title, Element main) {
    return documentOf(headElement(title, kPageStyle, {}), Element("body", std::move(main)));
}

std::string printedDocument(const std::string& title, Element main, std::string_view style) {
    return documentOf(headElement(title, style, {}), Element("body", std::move(main)));
}

std::string scriptedDocument(const std::string& title, Element main, Element data, const PageScripts& with) {
    std::vector<std::string> scripts;
    for (const std::string_view script : with.scripts)
        scripts.push_back(forBothReaders(script));
    Element body("body", std::move(main), std::move(data));
    for (const std::string& script : scripts)
        body.add(scriptElement(script));
    return documentOf(headElement(title, std::string(kPageStyle) + std::string(with.style), scripts),
                      std::move(body));
}

}  // namespace stepmill::report
