#include "stepmill/post/read_program.h"

#include <charconv>
#include <map>

#include <fmt/format.h>

#include "post/dialect.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// Controllers refuse arcs whose ends are less equally far from the centre (LinuxCNC: 0.028 mm or 0.1 %).
constexpr double kArcDisagreementMm = 0.02;
/// From where LinuxCNC feeds again after a peck: a hundredth of an inch over its bottom [mm].
constexpr double kOverPeckMm = 0.01 * kMillimetresPerInch;

struct Word {
    char letter = 0;
    double value = 0;
};

/// A line in parts: the words, and the text of its last comment.
struct Line {
    std::vector<Word> words;
    std::string comment;
};

class Reader {
  public:
    Reader(std::string_view text, const std::string& file, Dialect dialect)
        : text_(text), rules_(rulesOf(dialect)) {
        program_.file = file;
    }

    ReadProgram read() {
        bool ended = false;
        for (std::size_t from = 0; from < text_.size() && !ended;) {
            const std::size_t end = std::min(text_.find('\n', from), text_.size());
            ++line_;
            const Line line = split(text_.substr(from, end - from));
            if (!line.comment.empty()) noteOperation(line.comment);
            ended = !line.words.empty() && obey(line.words);
            from = end + 1;
        }
        if (!ended) fail("the program has no end (M30)");
        return std::move(program_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", program_.file, line_), what);
    }

    Line split(std::string_view text) const {
        Line line;
        for (std::size_t i = 0; i < text.size();) {
            const char c = text[i];
            if (c == ' ' || c == '\t' || c == '\r' || c == '%') {
                ++i;
            } else if (c == '(') {
                const std::size_t end = text.find(')', i);
                if (end == std::string_view::npos) fail("a comment without an end");
                line.comment = text.substr(i + 1, end - i - 1);
                i = end + 1;
            } else {
                line.words.push_back(word(text, i));
            }
        }
        return line;
    }

    Word word(std::string_view text, std::size_t& at) const {
        const char letter = text[at];
        if (letter < 'A' || letter > 'Z') fail(fmt::format("expected a word, found '{}'", text.substr(at)));
        double value = 0;
        const char* begin = text.data() + at + 1;
        const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
        if (error != std::errc{} || !std::isfinite(value))
            fail(fmt::format("expected a number after {}, found '{}'", letter, text.substr(at + 1)));
        at = static_cast<std::size_t>(end - text.data());
        return {letter, value};
    }

    /// "S1.O3 feature ..." starts an operation.
    void noteOperation(const std::string& comment) {
        const std::string first = comment.substr(0, comment.find(' '));
        const std::size_t dot = first.find(".O");
        if (first.empty() || first[0] != 'S' || dot == std::string::npos) return;
        ReadOperation operation;
        operation.id = first;
        operation.line = line_;
        operation.start = Vec3(x_.value_or(0), y_.value_or(0), z_.value_or(0));
        program_.operations.push_back(operation);
    }

    ReadOperation& operation() {
        if (program_.operations.empty()) fail("a motion before the first operation's comment");
        return program_.operations.back();
    }

    /// What the machine is set to at a motion.
    void takeState(ReadOperation& operation) const {
        operation.tool_number = tool_;
        operation.speed_rpm = spindle_on_ ? speed_rpm_ : 0;
        operation.coolant = coolant_;
    }

    /// Does what a block says; true at the program's end.
    bool obey(const std::vector<Word>& words) {
        std::map<char, double> values;
        std::vector<int> g_words;
        std::vector<int> m_words;
        for (const Word& word : words) {
            if (word.letter == 'G' || word.letter == 'M') {
                if (word.value != std::floor(word.value))
                    fail(fmt::format("{}{} is unknown", word.letter, word.value));
                (word.letter == 'G' ? g_words : m_words).push_back(static_cast<int>(word.value));
            } else if (!values.emplace(word.letter, word.value).second) {
                fail(fmt::format("{} stands twice in a block", word.letter));
            }
        }
        if (const auto s = values.find('S'); s != values.end()) speed_rpm_ = s->second;
        if (const auto t = values.find('T'); t != values.end()) changeTool(static_cast<int>(t->second));
        for (const auto& [letter, value] : values)
            if (std::string_view("NXYZIJFSTHRQPO").find(letter) == std::string_view::npos)
                fail(fmt::format("no post writes a word {}", letter));
        for (const int m : m_words)
            if (obeyM(m)) return true;
        obeyG(g_words, values);
        return false;
    }

    void changeTool(int number) {
        tool_ = number;
        x_ = y_ = z_ = std::nullopt;
        if (!program_.operations.empty()) program_.operations.back().after_tool_change = true;
    }

    bool obeyM(int m) {
        switch (m) {
            case 0:
            case 6:
                return false;
            case 3:
                spindle_on_ = true;
                return false;
            case 5:
                spindle_on_ = false;
                return false;
            case 7:
                coolant_ = Coolant::Mist;
                return false;
            case 8:
                coolant_ = Coolant::Flood;
                return false;
            case 9:
                coolant_ = Coolant::Off;
                return false;
            case 30:
                return true;
            default:
                fail(fmt::format("no post writes M{}", m));
        }
    }

    void obeyG(const std::vector<int>& g_words, const std::map<char, double>& values) {
        int cycle = 0;
        for (const int g : g_words) {
            switch (g) {
                case 0:
                case 1:
                case 2:
                case 3:
                    motion_ = g;
                    break;
                case 20:
                case 21:
                    mm_per_unit_ = g == 20 ? kMillimetresPerInch : 1;
                    break;
                case 4:
                    operation().dwell_s += values.count('P') ? dwell(values.at('P')) : 0;
                    return;
                case 28:
                    z_ = std::nullopt;  // home, over everything
                    return;
                case 81:
                case 82:
                case 83:
                    cycle = g;
                    break;
                case 17:
                case 40:
                case 43:
                case 49:
                case 54:
                case 61:
                case 80:
                case 90:
                case 94:
                case 98:
                    break;
                case 91:
                    if (std::find(g_words.begin(), g_words.end(), 28) != g_words.end()) break;
                    [[fallthrough]];
                default:
                    fail(fmt::format("no post writes G{}", g));
            }
        }
        if (const auto f = values.find('F'); f != values.end()) feed_ = f->second * unit();
        const bool moves = values.count('X') || values.count('Y') || values.count('Z');
        if (cycle != 0) return drill(cycle, values);
        if (moves || values.count('I') || values.count('J')) move(values);
    }

    double unit() const {
        if (mm_per_unit_ == 0) fail("a length before G20 or G21");
        return mm_per_unit_;
    }
    double dwell(double p) const { return rules_.dwell_in_ms ? p / 1000 : p; }

    /// The word's length on the grid, or what stood before.
    std::optional<double> place(const std::map<char, double>& values, char letter,
                                const std::optional<double>& before) const {
        const auto found = values.find(letter);
        return found == values.end() ? before : snapToGrid(found->second * unit());
    }

    bool placeKnown() const { return x_ && y_ && z_; }
    Vec3 at() const { return {*x_, *y_, *z_}; }

    void move(const std::map<char, double>& values) {
        const auto x = place(values, 'X', x_);
        const auto y = place(values, 'Y', y_);
        const auto z = place(values, 'Z', z_);
        if (!placeKnown()) {
            comeFromNowhere(values, x, y, z);
            return;
        }
        const Vec3 to(*x, *y, *z);
        if (motion_ < 2) {
            go(motion_ == 0 ? MoveKind::Rapid : kindOf(to, false), to, std::nullopt);
        } else {
            go(kindOf(to, true), to, arcTo(to.head<2>(), values));
        }
    }

    /// After a tool change: a rapid to a height, then one over to the first place.
    void comeFromNowhere(const std::map<char, double>& values, const std::optional<double>& x,
                         const std::optional<double>& y, const std::optional<double>& z) {
        if (motion_ != 0) fail("a feed from a place that is not known");
        if (!z_ && (values.count('X') || values.count('Y'))) fail("moves across before its height is known");
        x_ = x;
        y_ = y;
        z_ = z;
        ReadOperation& current = operation();
        current.after_tool_change = true;
        if (placeKnown()) current.start = at();
    }

    Arc arcTo(const Vec2& to, const std::map<char, double>& values) const {
        const auto offset = [&](char letter) {
            const auto found = values.find(letter);
            return found == values.end() ? 0.0 : found->second * unit();
        };
        const Vec2 from = at().head<2>();
        const Vec2 centre = snapToGrid(Vec2(from + Vec2(offset('I'), offset('J'))));
        const double start_mm = (from - centre).norm();
        const double end_mm = (to - centre).norm();
        if (start_mm == 0) fail("an arc without I and J");
        if (std::abs(start_mm - end_mm) > kArcDisagreementMm)
            fail(fmt::format("the arc's ends are {:.4f} and {:.4f} mm from its centre", start_mm, end_mm));
        return {centre, snapToGrid((start_mm + end_mm) / 2), motion_ == 3};
    }

    MoveKind kindOf(const Vec3& to, bool arc) const {
        if (to.z() >= *z_) return MoveKind::Feed;
        return !arc && to.head<2>() == at().head<2>() ? MoveKind::Plunge : MoveKind::Ramp;
    }

    void go(MoveKind kind, const Vec3& to, const std::optional<Arc>& arc) {
        if (kind != MoveKind::Rapid && feed_ <= 0) fail("a feed without F");
        if (kind != MoveKind::Rapid && !spindle_on_) fail("a feed with the spindle off");
        if (to == at() && !arc) return;
        takeState(operation());
        operation().moves.push_back({{{kind, to, arc, false}, kind == MoveKind::Rapid ? 0 : feed_}, line_});
        x_ = to.x();
        y_ = to.y();
        z_ = to.z();
    }

    void goTo(MoveKind kind, double z) { go(kind, {*x_, *y_, z}, std::nullopt); }

    void drill(int cycle, const std::map<char, double>& values) {
        if (!placeKnown()) fail("a hole from a place that is not known");
        for (const char letter : {'Z', 'R'})
            if (!values.count(letter)) fail(fmt::format("a cycle without {}", letter));
        const double initial = *z_;
        const double bottom = *place(values, 'Z', z_);
        const double r = *place(values, 'R', z_);
        const double peck = cycle == 83 && values.count('Q') ? values.at('Q') * unit() : r - bottom;
        if (peck <= 0 || r <= bottom || r > initial) fail("the heights of the hole are out of order");
        go(MoveKind::Rapid, {*place(values, 'X', x_), *place(values, 'Y', y_), initial}, std::nullopt);
        goTo(MoveKind::Rapid, r);
        for (double depth = r; depth > bottom;) {
            depth = std::max(bottom, depth - peck);
            goTo(MoveKind::Plunge, depth);
            if (depth == bottom) break;
            goTo(MoveKind::Rapid, r);
            goTo(MoveKind::Rapid, std::min(r, depth + kOverPeckMm));
        }
        if (cycle == 82 && values.count('P')) operation().dwell_s += dwell(values.at('P'));
        goTo(MoveKind::Rapid, initial);
    }

    std::string_view text_;
    const DialectRules& rules_;
    ReadProgram program_;
    int line_ = 0;
    std::optional<double> x_;
    std::optional<double> y_;
    std::optional<double> z_;
    int motion_ = 0;
    double mm_per_unit_ = 0;
    double feed_ = 0;
    double speed_rpm_ = 0;
    bool spindle_on_ = false;
    Coolant coolant_ = Coolant::Off;
    int tool_ = 0;
};

}  // namespace

ReadProgram readProgram(std::string_view text, const std::string& file, Dialect dialect) {
    return Reader(text, file, dialect).read();
}

}  // namespace stepmill
