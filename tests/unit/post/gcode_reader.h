#pragma once

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace stepmill::test {

/// One motion block of a program, as read back.
struct Block {
    int number = 0;
    int g = 0;
    double from[3] = {0, 0, 0};
    double to[3] = {0, 0, 0};
    double centre[2] = {0, 0};
    double feed = 0;

    double radiusAtStart() const { return std::hypot(from[0] - centre[0], from[1] - centre[1]); }
    double radiusAtEnd() const { return std::hypot(to[0] - centre[0], to[1] - centre[1]); }

    double length() const {
        const double dz = to[2] - from[2];
        if (g < 2) return std::hypot(to[0] - from[0], to[1] - from[1], dz);
        const double a = std::atan2(from[1] - centre[1], from[0] - centre[0]);
        const double b = std::atan2(to[1] - centre[1], to[0] - centre[0]);
        double sweep = g == 3 ? b - a : a - b;
        if (sweep <= 0) sweep += 2 * std::acos(-1.0);
        return std::hypot(sweep * radiusAtStart(), dz);
    }
};

/// A program as a controller without canned cycles sees it: words of a line, comments dropped.
struct Program {
    std::vector<Block> blocks;
    /// Lines without a motion to a place of the work offset's, without N words and comments, in order.
    std::vector<std::string> others;

    double length(bool rapids) const {
        double sum = 0;
        for (const Block& block : blocks)
            sum += (block.g == 0) == rapids ? block.length() : 0;
        return sum;
    }
};

inline std::string withoutComment(const std::string& line) {
    std::string text;
    bool comment = false;
    for (const char c : line) {
        if (c == '(') {
            if (comment) throw std::runtime_error("bracket within a comment: " + line);
            comment = true;
        } else if (c == ')') {
            comment = false;
        } else if (!comment) {
            text.push_back(c);
        }
    }
    if (comment) throw std::runtime_error("comment without an end: " + line);
    return text;
}

inline Program readProgram(const std::string& text) {
    Program program;
    double at[3] = {0, 0, 0};
    double feed = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::string code = withoutComment(line);
        if (code.empty()) continue;
        std::map<char, double> words;
        std::istringstream stream(code);
        for (std::string word; stream >> word;)
            if (const double value = std::stod(word.substr(1)); word[0] != 'G' || value < 4)
                words[word[0]] = value;
        if (words.count('N') == 0 || words.count('G') == 0) {
            program.others.push_back(words.count('N') == 0 ? code : code.substr(code.find(' ') + 1));
            continue;
        }
        Block block;
        block.number = static_cast<int>(words.at('N'));
        block.g = static_cast<int>(words.at('G'));
        for (int i = 0; i < 3; ++i) {
            block.from[i] = at[i];
            if (const auto found = words.find("XYZ"[i]); found != words.end()) at[i] = found->second;
            block.to[i] = at[i];
        }
        if (const auto found = words.find('F'); found != words.end()) feed = found->second;
        block.feed = feed;
        if (block.g >= 2) {
            block.centre[0] = block.from[0] + words.at('I');
            block.centre[1] = block.from[1] + words.at('J');
        }
        program.blocks.push_back(block);
    }
    return program;
}

}  // namespace stepmill::test
