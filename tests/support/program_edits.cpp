#include "support/program_edits.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace stepmill::test {
namespace {

constexpr const char* kCodes[] = {"G0",  "G1",  "G2",  "G3",  "G80", "G81", "G90", "G91", "G20",
                                  "G21", "G17", "G18", "G54", "G55", "G43", "G49", "G40", "G61",
                                  "G64", "G94", "G93", "G98", "G99", "G28", "G53", "M3",  "M4",
                                  "M5",  "M6",  "M7",  "M8",  "M9",  "M30", "M0"};
constexpr const char* kWords[] = {"X0", "Y10", "Z-5", "Z5",  "F5000", "F50",  "S500", "S30000",
                                  "P3", "I5",  "R5",  "T1",  "H1",    "G91",  "G0",   "M5",
                                  "M9", "M8",  "G54", "G64", "Q1",    "X1e2", "G61",  "G40"};
constexpr const char* kLines[] = {"G28 X0 Y0 Z-12",
                                  "G91 G28 Z-30",
                                  "G53 G0 Z0",
                                  "G4 P0.5",
                                  "G4 P0 X90 Y70",
                                  "M0",
                                  "M1",
                                  "G0 Z30",
                                  "G0 Z-20",
                                  "X20 Y20",
                                  "T1",
                                  "T2 M6",
                                  "M5",
                                  "M9",
                                  "M3",
                                  "G49",
                                  "G55",
                                  "G91",
                                  "G20",
                                  "S500",
                                  "G64",
                                  "G64 P0.01",
                                  "G61",
                                  "G92 X0",
                                  "%",
                                  "M30",
                                  "G1 X0 Y0",
                                  "G0 X0 Y0",
                                  "G90 G17 G40",
                                  "G28 Z40"};

/// Word boundaries of a line without comments: [begin, end) of each word.
std::vector<std::pair<std::size_t, std::size_t>> wordsOf(const std::string& line) {
    std::vector<std::pair<std::size_t, std::size_t>> words;
    if (line.find('(') != std::string::npos) return words;
    for (std::size_t i = 0; i < line.size();) {
        if (line[i] < 'A' || line[i] > 'Z') {
            ++i;
            continue;
        }
        const std::size_t end = line.find_first_not_of("0123456789.+-", i + 1);
        words.emplace_back(i, end == std::string::npos ? line.size() : end);
        i = words.back().second;
    }
    return words;
}

class Editor {
  public:
    Editor(const std::vector<std::string>& lines, std::mt19937& random) : random_(random) {
        edit_.lines = lines;
    }

    ProgramEdit make() {
        edit_.kind = static_cast<EditKind>(below(kEditKinds));
        switch (edit_.kind) {
            case EditKind::NumberChanged:
                changeNumber();
                break;
            case EditKind::WordRemoved:
                removeWord();
                break;
            case EditKind::WordAdded:
                at_ = codeLine();
                told(at_, line() + " " + kWords[below(std::size(kWords))]);
                break;
            case EditKind::CodeReplaced:
                replaceCode();
                break;
            case EditKind::Harmless:
                harmless();
                break;
            default:
                moveLines();
        }
        return edit_;
    }

  private:
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }
    std::string& line() { return edit_.lines[at_]; }
    auto place(std::size_t index) { return edit_.lines.begin() + static_cast<std::ptrdiff_t>(index); }

    void told(std::size_t index, const std::string& now) {
        at_ = index;
        edit_.what = fmt::format("line {}: {} -> {}", index + 1, line(), now);
        line() = now;
    }

    /// A line with words; one in four is none of the motions, which are most.
    std::size_t codeLine() {
        const bool rare = below(4) == 0;
        for (int i = 0; i < 10000; ++i) {
            const std::size_t index = below(edit_.lines.size());
            if (wordsOf(edit_.lines[index]).empty()) continue;
            if (rare && edit_.lines[index].front() == 'N' && i < 5000) continue;
            return index;
        }
        return 0;
    }

    /// A word of the line that is no block number, and not a code if `number`.
    std::pair<std::size_t, std::size_t> anyWord(bool is_code) {
        for (int i = 0; i < 200; ++i) {
            at_ = codeLine();
            const auto words = wordsOf(line());
            const auto word = words[below(words.size())];
            const char letter = line()[word.first];
            const bool code = letter == 'G' || letter == 'M';
            if (letter != 'N' && code == is_code) return word;
        }
        return {0, 0};
    }

    void changeNumber() {
        const auto [begin, end] = anyWord(false);
        const double value = std::atof(line().c_str() + begin + 1);
        const double steps[] = {-value,    value + 0.01, value - 0.01, value + 1,   value - 1,  value * 10,
                                value / 2, value + 10,   value - 10,   value - 0.1, value + 0.3};
        const char letter = line()[begin];
        const bool whole = letter == 'T' || letter == 'S' || letter == 'H';
        const double now = steps[below(std::size(steps))];
        told(at_, line().substr(0, begin + 1) +
                      (whole ? fmt::format("{:.0f}", std::abs(now)) : fmt::format("{:.4f}", now)) +
                      line().substr(end));
    }

    void removeWord() {
        const auto [begin, end] = anyWord(below(2) == 0);
        told(at_, line().substr(0, begin) + line().substr(end));
    }

    void replaceCode() {
        const auto [begin, end] = anyWord(true);
        told(at_, line().substr(0, begin) + kCodes[below(std::size(kCodes))] + line().substr(end));
    }

    void moveLines() {
        at_ = codeLine();
        const std::string taken = line();
        const std::size_t other = codeLine();
        edit_.what = fmt::format("line {}: {}", at_ + 1, taken);
        switch (edit_.kind) {
            case EditKind::LineRemoved:
                edit_.lines.erase(place(at_));
                break;
            case EditKind::LineDoubled:
                edit_.lines.insert(place(at_), taken);
                break;
            case EditKind::LinesSwapped:
                std::swap(line(), edit_.lines[std::min(at_ + 1, edit_.lines.size() - 1)]);
                break;
            case EditKind::LineMoved:
                edit_.lines.erase(place(at_));
                edit_.lines.insert(place(std::min(other, edit_.lines.size())), taken);
                edit_.what += fmt::format(" to {}", other + 1);
                break;
            default: {
                const std::string added = kLines[below(std::size(kLines))];
                edit_.lines.insert(place(at_), added);
                edit_.what = fmt::format("line {}: {} comes in", at_ + 1, added);
            }
        }
    }

    void harmless() {
        at_ = codeLine();
        std::string now = line();
        switch (below(9)) {
            case 0:
                now += " (a comment)";
                break;
            case 1:
                now += " ; G0 Z-50";
                break;
            case 2:
                std::transform(now.begin(), now.end(), now.begin(),
                               [](unsigned char c) { return std::tolower(c); });
                break;
            case 3:
                std::erase(now, ' ');
                break;
            case 4:
                now = "  " + now + " \t\r";
                break;
            case 5:
                now = now.front() == 'N' ? now.substr(now.find(' ') + 1) : "N7 " + now;
                break;
            case 6:
                edit_.lines.insert(place(at_), below(2) == 0 ? "" : "(nothing)");
                edit_.what = "a line of nothing";
                return;
            case 7:
                edit_.lines.insert(place(at_), "M1");
                edit_.what = "M1";
                return;
            default:
                for (const auto& [begin, end] : wordsOf(now))
                    if (now[begin] == 'X' || now[begin] == 'Y') {
                        const std::size_t digits = begin + (now[begin + 1] == '-' ? 2 : 1);
                        now.insert(digits, "00");
                        if (digits == begin + 1) now.insert(digits, "+");
                        break;
                    }
        }
        told(at_, now);
    }

    std::mt19937& random_;
    ProgramEdit edit_;
    std::size_t at_ = 0;
};

}  // namespace

std::string toString(EditKind kind) {
    constexpr const char* kNames[] = {"number changed", "word removed", "word added",    "code replaced",
                                      "line removed",   "line doubled", "lines swapped", "line moved",
                                      "line added",     "harmless"};
    return kNames[static_cast<int>(kind)];
}

ProgramEdit editProgram(const std::vector<std::string>& lines, std::mt19937& random) {
    return Editor(lines, random).make();
}

}  // namespace stepmill::test
