#pragma once

#include <algorithm>
#include <initializer_list>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace stepmill::test {

/// Does one line of the text have all of these names, numbers and key words, in whatever sentence? What a
/// user is told may be worded better without a test that fails.
inline testing::AssertionResult tells(const std::string& text, std::initializer_list<const char*> words) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const bool has_all = std::all_of(words.begin(), words.end(), [&](const char* word) {
            return line.find(word) != std::string::npos;
        });
        if (has_all) return testing::AssertionSuccess();
    }
    auto failure = testing::AssertionFailure() << "no line has all of:";
    for (const char* word : words)
        failure << " '" << word << "'";
    return failure << "\n" << text;
}

}  // namespace stepmill::test
