#include "support/page_text.h"

#include <cctype>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace stepmill::test {
namespace {

/// The page without every element of that name.
std::string without(const std::string& element, const std::string& html) {
    const std::string end = "</" + element + ">";
    std::string text;
    std::size_t at = 0;
    for (std::size_t from = html.find("<" + element); from != std::string::npos;
         from = html.find("<" + element, at)) {
        text += html.substr(at, from - at);
        at = html.find(end, from);
        if (at == std::string::npos) return text;
        at += end.size();
    }
    return text + html.substr(at);
}

/// What stands in the text for a tag such as "/td".
std::string insteadOf(const std::string& tag) {
    static const std::set<std::string> kInline{"b", "i", "/i", "span", "/span", "a", "/a", "em", "/em"};
    if (tag == "/td" || tag == "/th") return " | ";
    if (tag == "/b") return " ";
    if (tag == "td" || tag == "th" || kInline.contains(tag)) return "";
    return "\n";
}

std::string tagName(const std::string& inside) {
    return inside.substr(0, inside.find_first_of(" \n"));
}

std::string withoutTags(const std::string& html) {
    std::string text;
    for (std::size_t at = 0; at < html.size();) {
        const std::size_t end = html[at] == '<' ? html.find('>', at) : std::string::npos;
        if (end == std::string::npos) {
            // Line ends of the page's source mean nothing.
            text += html[at] == '\n' ? ' ' : html[at];
            ++at;
        } else {
            text += insteadOf(tagName(html.substr(at + 1, end - at - 1)));
            at = end + 1;
        }
    }
    return text;
}

/// Characters instead of the names that pages have for them.
std::string withoutEntities(std::string text) {
    static const std::vector<std::pair<std::string, std::string>> kEntities{
        {"&lt;", "<"},           {"&gt;", ">"},         {"&quot;", "\""}, {"&#39;", "'"},
        {"&times;", "\xC3\x97"}, {"&deg;", "\xC2\xB0"}, {"&nbsp;", " "},  {"&middot;", "\xC2\xB7"},
        {"&amp;", "&"}};
    for (const auto& [name, character] : kEntities)
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
            text.replace(at, name.size(), character);
    return text;
}

/// Single spaces, none at the ends.
std::string tidy(const std::string& line) {
    std::istringstream words(line);
    std::string text;
    for (std::string word; words >> word;)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

}  // namespace

std::string pageText(const std::string& html) {
    std::istringstream lines(
        withoutEntities(withoutTags(without("svg", without("style", without("script", html))))));
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (const std::string words = tidy(line); !words.empty()) text += words + "\n";
    return text;
}

}  // namespace stepmill::test
