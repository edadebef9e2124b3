#include <fmt/format.h>

#include "part/step/checks.h"
#include "part/step/kinds.h"

namespace stepmill {
namespace {

/// A face is some ten entities above its points; readers recurse, some with half a kilobyte a level.
constexpr int kDeepestShape = 200;

bool isReference(const StepValue& value) {
    return value.is(StepValue::Kind::Reference);
}

void checkTargets(const StepScreen& screen, StepText& text) {
    int dangling = 0;
    std::string first;
    for (const StepEntity& from : screen.model.entities()) {
        const bool shape = isShapeEntity(screen.model.keywordOf(from));
        for (const StepValue& value : screen.model.allValuesOf(from)) {
            if (!isReference(value)) continue;
            if (value.word == from.id)
                screen.refuse(ErrorCode::StepDamaged, from, "contains itself; another entity expected");
            if (screen.model.indexOf(value.word)) continue;
            if (shape)
                screen.refuse(ErrorCode::StepDamaged, from,
                              fmt::format("refers to #{}, which the file does not define", value.word));
            if (dangling++ == 0) first = fmt::format("in line {} to #{}", from.line, value.word);
        }
    }
    if (dangling > 0)
        text.remarks.push_back(
            fmt::format("{} references outside the shape lead nowhere, the first {}", dangling, first));
}

/// A shape is a tree with shared leaves; a path that comes back to where it began would send the reader
/// round for ever, a path without end through its stack. Depth-first search with a stack of its own, since
/// files nest as deep as they like.
class DepthSearch {
  public:
    explicit DepthSearch(const StepScreen& screen)
        : screen_(screen), nodes_(screen.model.entities().size()) {}

    void visit(std::size_t root) {
        if (nodes_[root].state != State::Fresh || !isShape(root)) return;
        open(root);
        while (!path_.empty())
            step(path_.back());
    }

  private:
    enum class State : unsigned char { Fresh, Open, Done };
    struct Node {
        State state = State::Fresh;
        int depth = 1;           ///< of what hangs below, once done
        std::uint32_t next = 0;  ///< value to look at
    };

    const StepEntity& entity(std::size_t index) const { return screen_.model.entities()[index]; }
    bool isShape(std::size_t index) const { return isShapeEntity(screen_.model.keywordOf(entity(index))); }

    void open(std::size_t index) {
        nodes_[index].state = State::Open;
        path_.push_back(index);
    }

    void close(std::size_t index) {
        Node& node = nodes_[index];
        node.state = State::Done;
        path_.pop_back();
        if (node.depth > kDeepestShape)
            screen_.refuse(ErrorCode::StepDamaged, entity(index),
                           fmt::format("nests entities deeper than {}", kDeepestShape));
        if (!path_.empty()) nodes_[path_.back()].depth = std::max(nodes_[path_.back()].depth, node.depth + 1);
    }

    /// Looks at the next reference of the entity, closes it where there is none.
    void step(std::size_t at) {
        Node& node = nodes_[at];
        const std::span<const StepValue> values = screen_.model.allValuesOf(entity(at));
        while (node.next < values.size() && !isReference(values[node.next]))
            ++node.next;
        if (node.next >= values.size()) return close(at);
        const std::size_t* target = screen_.model.indexOf(values[node.next++].word);
        if (!target || !isShape(*target)) return;
        const Node& other = nodes_[*target];
        if (other.state == State::Open)
            screen_.refuse(
                ErrorCode::StepDamaged, entity(*target),
                fmt::format("contains itself by way of #{}; another entity expected", entity(at).id));
        if (other.state == State::Done)
            node.depth = std::max(node.depth, other.depth + 1);
        else
            open(*target);
    }

    const StepScreen& screen_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> path_;
};

}  // namespace

std::string StepScreen::nameOf(const StepEntity& entity) const {
    return fmt::format("#{} {}", entity.id, model.keywordOf(entity));
}

void StepScreen::refuse(ErrorCode code, const StepEntity& entity, const std::string& message) const {
    throw Error(code, file, fmt::format("line {}: {} {}", entity.line, nameOf(entity), message));
}

void checkReferences(const StepScreen& screen, StepText& text) {
    checkTargets(screen, text);
    DepthSearch search(screen);
    for (std::size_t root = 0; root < screen.model.entities().size(); ++root)
        search.visit(root);
}

}  // namespace stepmill
