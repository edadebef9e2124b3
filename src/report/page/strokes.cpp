#include "report/page/strokes.h"

#include <algorithm>
#include <map>

namespace stepmill::report {
namespace {

/// Takes strokes out one after another.
class Ends {
  public:
    explicit Ends(const std::set<Stroke>& strokes) {
        for (const Stroke& stroke : strokes) {
            ends_[stroke[0]].insert(stroke[1]);
            ends_[stroke[1]].insert(stroke[0]);
        }
    }

    bool empty() const { return ends_.empty(); }

    std::vector<SvgDot> takeLine() {
        std::vector<SvgDot> line{ends_.begin()->first};
        while (ends_.contains(line.back()))
            line.push_back(takeFrom(line.back()));
        return line;
    }

  private:
    SvgDot takeFrom(const SvgDot& from) {
        const SvgDot to = *ends_[from].begin();
        forget(from, to);
        forget(to, from);
        return to;
    }

    void forget(const SvgDot& from, const SvgDot& to) {
        ends_[from].erase(to);
        if (ends_[from].empty()) ends_.erase(from);
    }

    std::map<SvgDot, std::set<SvgDot>> ends_;
};

}  // namespace

std::set<Stroke> strokesOf(const std::vector<std::vector<Vec2>>& lines,
                           const std::function<SvgDot(const Vec2&)>& dot_of) {
    std::set<Stroke> strokes;
    for (const std::vector<Vec2>& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const SvgDot from = dot_of(line[i - 1]);
            const SvgDot to = dot_of(line[i]);
            if (from != to) strokes.insert({std::min(from, to), std::max(from, to)});
        }
    return strokes;
}

std::vector<std::vector<SvgDot>> joined(const std::set<Stroke>& strokes) {
    std::vector<std::vector<SvgDot>> lines;
    for (Ends ends(strokes); !ends.empty();)
        lines.push_back(ends.takeLine());
    return lines;
}

}  // namespace stepmill::report
