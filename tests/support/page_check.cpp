#include "support/page_check.h"

#include <algorithm>
#include <memory>
#include <regex>

#include <expat.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace stepmill::test {
namespace {

/// None of these runs a script, loads a file or styles itself.
const std::set<std::string> kHarmlessTags{
    "html", "head", "meta", "title", "style",  "body",       "main",    "nav",     "section", "h1",
    "h2",   "h3",   "p",    "div",   "ul",     "li",         "table",   "thead",   "tbody",   "tr",
    "th",   "td",   "b",    "i",     "figure", "figcaption", "details", "summary", "span",    "a",
    "svg",  "g",    "path", "text",  "rect",   "circle",     "line"};
const std::set<std::string> kHarmlessAttributes{
    "aria-label", "charset", "class", "content", "cx",   "cy",    "d",         "href",    "http-equiv",
    "id",         "lang",    "name",  "r",       "role", "scope", "transform", "viewBox", "x",
    "x1",         "x2",      "y",     "y1",      "y2",   "xmlns", "width",     "height"};

struct Reading {
    PageContent content;
    std::string open_tag;
};

void XMLCALL onTag(void* data, const XML_Char* name, const XML_Char** attributes) {
    auto& reading = *static_cast<Reading*>(data);
    PageContent& content = reading.content;
    reading.open_tag = name;
    ++content.tags[name];
    for (; *attributes != nullptr; attributes += 2) {
        const std::string attribute = attributes[0];
        content.attributes.insert(attribute);
        if (attribute == "id") content.ids.emplace_back(attributes[1]);
        if (attribute == "href" || attribute == "src") content.references.emplace_back(attributes[1]);
    }
}

void XMLCALL onEnd(void* data, const XML_Char* /*name*/) {
    static_cast<Reading*>(data)->open_tag.clear();
}

void XMLCALL onText(void* data, const XML_Char* text, int length) {
    auto& reading = *static_cast<Reading*>(data);
    if (reading.open_tag != "style") reading.content.text.append(text, static_cast<std::size_t>(length));
}

}  // namespace

PageContent readPage(const std::string& page) {
    Reading reading;
    const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate("UTF-8"),
                                                                              &XML_ParserFree);
    XML_SetUserData(parser.get(), &reading);
    XML_SetElementHandler(parser.get(), onTag, onEnd);
    XML_SetCharacterDataHandler(parser.get(), onText);
    if (XML_Parse(parser.get(), page.data(), static_cast<int>(page.size()), 1) != XML_STATUS_OK)
        reading.content.errors.push_back(fmt::format("line {}: {}", XML_GetCurrentLineNumber(parser.get()),
                                                     XML_ErrorString(XML_GetErrorCode(parser.get()))));
    return reading.content;
}

std::string withoutOwnScripts(const std::string& page, int scripts) {
    static const std::regex element("<script([^>]*)>");
    const std::string end = "</script>";
    std::string rest;
    std::size_t at = 0;
    int run = 0;
    std::smatch tag;
    for (auto from = page.begin(); std::regex_search(from, page.end(), tag, element);
         from = page.begin() + static_cast<std::ptrdiff_t>(at)) {
        const auto begin = static_cast<std::size_t>(tag[0].first - page.begin());
        rest += page.substr(at, begin - at);
        at = page.find(end, begin) + end.size();
        if (tag[1].str().find("type=\"application/json\"") == std::string::npos) ++run;
    }
    EXPECT_EQ(run, scripts);
    const std::string policy = page.substr(
        page.find("script-src "), page.find(';', page.find("script-src ")) - page.find("script-src "));
    EXPECT_EQ(std::count(policy.begin(), policy.end(), '-'), 1 + scripts) << policy;
    return rest + page.substr(at);
}

void expectSoundPage(const std::string& page, const std::string& what) {
    const PageContent content = readPage(page);
    EXPECT_EQ(content.errors, std::vector<std::string>()) << what;
    for (const auto& [tag, count] : content.tags)
        EXPECT_TRUE(kHarmlessTags.count(tag) != 0) << what << ": <" << tag << ">";
    for (const std::string& attribute : content.attributes)
        EXPECT_TRUE(kHarmlessAttributes.count(attribute) != 0) << what << ": " << attribute << "=";
    std::set<std::string> places;
    for (const std::string& id : content.ids)
        EXPECT_TRUE(places.insert("#" + id).second) << what << ": two elements have the id " << id;
    for (const std::string& reference : content.references)
        EXPECT_TRUE(places.count(reference) != 0) << what << ": nothing has the id of the link " << reference;
}

}  // namespace stepmill::test
