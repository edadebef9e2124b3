#include "support/random_programs.h"

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <fmt/format.h>

namespace stepmill::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInch = 25.4;

/// Blocks that a controller refuses wherever they stand, or in most places.
constexpr const char* kFaults[] = {"G0 G1 X1",
                                   "G2 X1 R5 I1",
                                   "G1 X1e2",
                                   "T5.7",
                                   "G1 X1 (open",
                                   "G1 X1 X2",
                                   "G90 G91",
                                   "M3 M4",
                                   "M7 M9",
                                   "G1 X",
                                   "G1 Y-",
                                   "G1 X1.2.3",
                                   "G1 X1 N7",
                                   "G2 X1000 I1",
                                   "G2 X1",
                                   "G3 X50 R1",
                                   "G2 I1 P1.5",
                                   "G2 I1 P0",
                                   "G80 X1",
                                   "G4",
                                   "G4 P-1",
                                   "G4 P1 G2 I1",
                                   "G28 G1 X1",
                                   "G91 G53 G0 Z0",
                                   "H3",
                                   "P3",
                                   "R3",
                                   "Q3",
                                   "D3",
                                   "S-100",
                                   "F-100",
                                   "G83 X1 Z-3 R1",
                                   "G82 X1 Z-3 R1",
                                   "G81 X1 Z-3",
                                   "G81 R1 Z-1",
                                   "G90 G81 X1 Z3 R1",
                                   "G54 G55",
                                   "%",
                                   "G1 X1 %",
                                   "G1 X1 (a(b)) Y1",
                                   "G1 X1) Y1",
                                   "M5 M5",
                                   "G43 H2.5",
                                   "G93 G1 X1",
                                   "G1.5 X1",
                                   "M3.5",
                                   "G200",
                                   "G61 G64",
                                   "X1 Y",
                                   "G17 G19",
                                   "S100 S200",
                                   "K1",
                                   "G1 X5 K1",
                                   "!",
                                   "G1 X$5"};

/// Blocks that LinuxCNC obeys in most places and our reader refuses.
constexpr const char* kBeyond[] = {"#1=5",
                                   "G4 P-2",
                                   "G1 X#5220 F100",
                                   "G1 X[1+2] F100",
                                   "G92 X0",
                                   "/G0 X1",
                                   "G10 L2 P1 X0",
                                   "G41 D1",
                                   "G0 A5",
                                   "G43.1 Z1",
                                   "G53 G1 X1 F100",
                                   "G53 G0 Z1",
                                   "M60",
                                   "G97 S100",
                                   "M48",
                                   "N1.5 G0 X1",
                                   "G0 X-+5",
                                   "G90.1 G17 G90 G81 X1 Z-3 R1 L2 F100",
                                   "(ABORT, stop)",
                                   "G91 G73 X1 Z-3 R-1 Q1 F50",
                                   "G0 X200000"};

template <typename List, typename Random>
const auto& oneOf(const List& list, Random& random) {
    return list[std::uniform_int_distribution<std::size_t>(0, std::size(list) - 1)(random)];
}

/// Keeps the place as a controller would, so that arcs fit.
class Generator {
  public:
    explicit Generator(unsigned seed) : random_(seed) {}

    RandomProgram make() {
        const bool percent = chance(0.2);
        if (percent) program_.text += chance(0.5) ? "%\n" : "%  \n";
        begin();
        changeTool();
        const int blocks = whole(5, 40);
        const int fault_at = chance(0.3) ? whole(0, blocks) : -1;
        const int beyond_at = chance(0.1) ? whole(0, blocks) : -1;
        for (int i = 0; i < blocks; ++i) {
            if (i == fault_at) addFault(percent);
            if (i == beyond_at && fault_at < 0) {
                program_.beyond = oneOf(kBeyond, random_);
                program_.text += program_.beyond + "\n";
            }
            anything();
        }
        end(percent);
        return program_;
    }

  private:
    using Words = std::vector<std::string>;

    bool chance(double share) { return std::bernoulli_distribution(share)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    double real(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

    double unit() const { return inch_ ? kInch : 1; }

    /// A number in one of its spellings, and what it says.
    std::string spelt(double value, int decimals) {
        std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
        if (text.find('.') != std::string::npos && chance(0.3))
            while (text.back() == '0')
                text.pop_back();
        if (text.starts_with("0.") && text.size() > 2 && chance(0.3)) text.erase(0, 1);
        if (chance(0.1)) text.insert(0, text.front() == '.' ? "0" : "00");
        const std::string sign = value < 0 ? "-" : chance(0.1) ? "+" : "";
        return sign + text;
    }

    int decimals() const { return inch_ ? 5 : 4; }
    double rounded(double number) const {
        const double grid = std::pow(10.0, decimals());
        return std::round(number * grid) / grid;
    }
    std::string word(char letter, double number) {
        return fmt::format("{}{}", letter, spelt(number, decimals()));
    }

    /// The axis word that leads to `to_mm`; the place is then where the written number leads.
    std::string axis(int index, double to_mm) {
        double& at = at_[static_cast<std::size_t>(index)];
        const double number = rounded((absolute_ ? to_mm : to_mm - at) / unit());
        at = absolute_ ? number * unit() : at + number * unit();
        return word("XYZ"[index], number);
    }

    void block(Words words, bool shuffle = false) {
        if (shuffle) std::shuffle(words.begin(), words.end(), random_);
        std::string text;
        if (chance(0.2)) text = fmt::format("N{}{}", ++number_ * 10, chance(0.5) ? " " : "");
        for (const std::string& one : words) {
            text += one;
            if (chance(0.7)) text += chance(0.1) ? "\t " : " ";
            if (chance(0.03)) text += "(hm)";
        }
        if (chance(0.05)) text += "; " + std::string(chance(0.5) ? "G0 Z-5" : "(");
        if (chance(0.15))
            for (char& c : text)
                if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        if (chance(0.05)) text += "\r";
        program_.text += text + "\n";
        if (chance(0.03)) program_.text += chance(0.5) ? "\n" : "(a comment)\n";
    }

    std::string g(int code) { return (code < 10 && chance(0.3) ? "G0" : "G") + std::to_string(code); }
    std::string m(int code) { return (code < 10 && chance(0.3) ? "M0" : "M") + std::to_string(code); }

    void begin() {
        inch_ = chance(0.3);
        block({g(inch_ ? 20 : 21), g(17), g(40), g(49), g(80), g(90), g(94), g(54), g(98)}, true);
        if (chance(0.5)) block({chance(0.5) ? "G61" : "G64 P0.01"});
    }

    void addFault(bool percent) {
        const std::string fault = oneOf(kFaults, random_);
        block({fault});
        // Between two % signs a third ends the program, and words come after it.
        if (percent && fault == "%") program_.beyond = fault;
    }

    void changeTool() {
        const int tool = whole(1, 8);
        if (chance(0.5)) {
            block({fmt::format("T{}", tool), m(6)}, true);
        } else {
            block({fmt::format("T{}", tool)});
            if (chance(0.3) && known_) anything();
            block({m(6)});
        }
        block({fmt::format("S{}", whole(100, 20000)), m(chance(0.8) ? 3 : 4)}, true);
        block({g(43), fmt::format("H{}", tool)}, true);
        approach();
        setFeed();
    }

    void approach() {
        if (!absolute_) block({g(90)});
        absolute_ = true;
        block({g(0), axis(2, real(5, 60))}, true);
        block({g(0), axis(0, real(-50, 50)), axis(1, real(-50, 50))}, true);
        known_ = true;
        cycle_ = false;
        motion_ = 0;
    }

    void setFeed() {
        block({fmt::format("F{}", spelt(inch_ ? real(1, 50) : real(20, 2000), 2))});
        fed_ = true;
    }

    void anything() {
        switch (whole(0, 19)) {
            case 0:
                return block({m(std::array{7, 8, 9}[static_cast<std::size_t>(whole(0, 2))])});
            case 1:
                return block({g(4), "P" + spelt(real(0, 3), 2)}, true);
            case 2:
                return changeDistance();
            case 3:
                return chance(0.4) ? changeUnits() : straight();
            case 4:
                return block({fmt::format("S{}", whole(1, 9000)), m(whole(3, 5))}, true);
            case 5:
                return chance(0.3) ? changeTool() : setFeed();
            case 6:
                return chance(0.3) ? home() : straight();
            case 7:
                return inverseTime();
            case 8:
            case 9:
            case 10:
                return cycle();
            case 11:
            case 12:
            case 13:
            case 14:
                return arc();
            case 15:
                return smallWords();
            default:
                return straight();
        }
    }

    void smallWords() {
        static constexpr const char* kSmall[] = {
            "M0",  "M1",  "G61",  "G64", "G64 P0.02", "G61.1", "G91.1",           "G98", "G99", "G17",
            "G54", "G40", "S500", "T3",  "N5",        "G0",    "(S1.O1 comment)", "G94", "G80"};
        const std::string words = oneOf(kSmall, random_);
        block({words});
        if (words == "G94") setFeed();
        if (words == "G0") motion_ = 0;
        if (words == "G80") motion_ = -1;
        if (words == "G0" || words == "G80") cycle_ = false;
    }

    void changeDistance() {
        absolute_ = !absolute_;
        block({g(absolute_ ? 90 : 91)});
    }

    void changeUnits() {
        block({g(80)});
        motion_ = -1;
        inch_ = !inch_;
        cycle_ = false;
        block({g(inch_ ? 20 : 21)});
        if (chance(0.7)) setFeed();
    }

    void straight() {
        const int code = chance(0.4) ? 0 : 1;
        Words words;
        const bool modal = motion_ == code && chance(0.6);
        if (!modal) words.push_back(g(code));
        if (chance(0.1)) words.push_back(fmt::format("F{}", spelt(inch_ ? real(1, 50) : real(20, 2000), 1)));
        int axes = 0;
        for (int i = 0; i < 3; ++i) {
            if (!chance(0.5) && !(i == 2 && axes == 0)) continue;
            words.push_back(axis(i, i == 2 ? real(-20, 60) : real(-50, 50)));
            ++axes;
        }
        if (!absolute_ && chance(0.1)) words.push_back("G91");
        block(words, true);
        motion_ = code;
        cycle_ = false;
    }

    void arc() {
        const bool ccw = chance(0.5);
        const double radius = real(0.5, 30);
        const double start = real(0, 2 * kPi);
        const bool full = chance(0.1);
        double sweep = full ? 2 * kPi : real(0.05, 2 * kPi - 0.05);
        // Near a half circle the two ways round are one last decimal apart.
        if (std::abs(sweep - kPi) < 0.05) sweep = kPi / 2;
        const double turn = ccw ? sweep : -sweep;
        const double cx = at_[0] + radius * std::cos(start);
        const double cy = at_[1] + radius * std::sin(start);
        const double from_x = at_[0];
        const double from_y = at_[1];
        const double c = std::cos(turn);
        const double s = std::sin(turn);
        const double ex = cx + c * (from_x - cx) - s * (from_y - cy);
        const double ey = cy + s * (from_x - cx) + c * (from_y - cy);
        Words words{g(ccw ? 3 : 2)};
        if (!full || chance(0.5)) {
            words.push_back(axis(0, full && absolute_ ? from_x : ex));
            words.push_back(axis(1, full && absolute_ ? from_y : ey));
        }
        if (chance(0.3)) words.push_back(axis(2, at_[2] + real(-5, 5)));
        if (!full && chance(0.3)) {
            words.push_back(word('R', rounded((sweep > kPi ? -radius : radius) / unit())));
        } else if (chance(0.1)) {
            words.insert(words.end(),
                         {"G90.1", word('I', rounded(cx / unit())), word('J', rounded(cy / unit()))});
            block(words, true);
            block({"G91.1"});
            motion_ = ccw ? 3 : 2;
            cycle_ = false;
            return;
        } else {
            words.push_back(word('I', rounded((cx - from_x) / unit())));
            words.push_back(word('J', rounded((cy - from_y) / unit())));
        }
        if (chance(0.15)) words.push_back(fmt::format("P{}", whole(1, 4)));
        block(words, true);
        motion_ = ccw ? 3 : 2;
        cycle_ = false;
    }

    void cycle() {
        if (cycle_ && chance(0.6)) return repeatCycle();
        const int code = whole(81, 83);
        Words words{g(code)};
        if (chance(0.4)) words.push_back(g(whole(98, 99)));
        if (chance(0.7)) words.push_back(axis(0, real(-50, 50)));
        if (chance(0.7) || words.size() == 1) words.push_back(axis(1, real(-50, 50)));
        const double r = absolute_ ? real(-5, 30) : real(-20, 10);
        const double depth = real(0, 30);
        words.push_back(word('R', rounded(r / unit())));
        words.push_back(word('Z', rounded((absolute_ ? r - depth : -depth) / unit())));
        if (code == 82) words.push_back("P" + spelt(real(0, 2), 2));
        if (code == 83) words.push_back(word('Q', rounded(std::max(0.2, real(0.05, 1.2) * depth) / unit())));
        block(words, true);
        endOfCycleIsAnywhere();
        cycle_ = true;
        motion_ = code;
    }

    /// Another hole by its place alone.
    void repeatCycle() {
        Words words;
        if (chance(0.8)) words.push_back(axis(0, real(-50, 50)));
        if (chance(0.5) || words.empty()) words.push_back(axis(1, real(-50, 50)));
        if (chance(0.2)) words.push_back(g(whole(98, 99)));
        block(words, true);
        endOfCycleIsAnywhere();
    }

    /// Where a cycle ends depends on G98 and G99: a rapid names the height.
    void endOfCycleIsAnywhere() {
        if (!cycle_ && chance(0.3)) return;
        const bool was_absolute = absolute_;
        if (!was_absolute) return;
        if (chance(0.4)) {
            block({g(80)});
            motion_ = -1;
            block({g(0), axis(2, real(10, 60))}, true);
            motion_ = 0;
            cycle_ = false;
        }
    }

    void home() {
        Words words{g(chance(0.7) ? 28 : 30)};
        for (int i = 0; i < 3; ++i)
            if (chance(0.5)) words.push_back(axis(i, real(-20, 50)));
        block(words, true);
        approach();
    }

    void inverseTime() {
        block({g(93)});
        Words words{g(1), axis(0, real(-50, 50)), fmt::format("F{}", spelt(real(0.5, 20), 2))};
        block(words, true);
        block({g(94)});
        setFeed();
        motion_ = 1;
        cycle_ = false;
    }

    void end(bool percent) {
        if (percent && chance(0.3)) {
            program_.text += "%\n";
            return;
        }
        block({m(chance(0.5) ? 2 : 30)});
        if (percent && chance(0.5)) program_.text += "%\n";
    }

    std::mt19937 random_;
    RandomProgram program_;
    std::array<double, 3> at_{};
    bool inch_ = false;
    bool absolute_ = true;
    bool known_ = false;
    bool fed_ = false;
    bool cycle_ = false;
    int motion_ = -1;
    int number_ = 0;
};

}  // namespace

RandomProgram randomProgram(unsigned seed) {
    return Generator(seed).make();
}

}  // namespace stepmill::test
