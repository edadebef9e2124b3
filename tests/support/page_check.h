#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace stepmill::test {

/// What a reader of XML finds in a page.
struct PageContent {
    std::vector<std::string> errors;      ///< of the markup itself; empty when it is well-formed
    std::map<std::string, int> tags;      ///< how often each stands there
    std::set<std::string> attributes;     ///< names
    std::vector<std::string> ids;         ///< in order
    std::vector<std::string> references;  ///< values of href and src
    std::string text;                     ///< between the tags, style sheets left out
};

/// Reads a page as XML, which is stricter than any browser.
PageContent readPage(const std::string& page);

/// Expects that the page is well-formed, has only tags and attributes that do nothing by themselves, that ids
/// stand once, and that it refers to nothing but its own ids: it then needs neither a network nor a folder
/// beside it, whatever names stand in it.
/// \param what  named by failures
void expectSoundPage(const std::string& page, const std::string& what);

/// The page without the scripts that its policy allows by hash, and without the data they read: what is left
/// is to be sound. Expects that every script that runs is one of these.
/// \param scripts  how many there are to be
std::string withoutOwnScripts(const std::string& page, int scripts);

}  // namespace stepmill::test
