#include "plan/operations/make_operations.h"

namespace stepmill {
namespace {

Move rapidTo(const Vec3& to) {
    Move move;
    move.kind = MoveKind::Rapid;
    move.to = to;
    return move;
}

/// Rapids between two retracted positions, over the higher of the two.
std::vector<Move> rapidsBetween(const Vec3& from, const Vec3& to) {
    const Vec3 corner = to.z() > from.z() ? Vec3(from.x(), from.y(), to.z()) : Vec3(to.x(), to.y(), from.z());
    std::vector<Move> moves;
    if (corner != from) moves.push_back(rapidTo(corner));
    if (to != corner) moves.push_back(rapidTo(to));
    return moves;
}

}  // namespace

void linkOperations(std::vector<Operation>& operations, const Machine& machine) {
    for (std::size_t i = 1; i < operations.size(); ++i) {
        // After a tool change the tool comes down at the operation's own start: nothing to link.
        if (operations[i].tool_id != operations[i - 1].tool_id) continue;
        const Toolpath& before = operations[i - 1].path;
        Toolpath& path = operations[i].path;
        const Vec3 from = before.moves.empty() ? before.start : before.moves.back().to;
        const std::vector<Move> link = rapidsBetween(from, path.start);
        path.moves.insert(path.moves.begin(), link.begin(), link.end());
        path.start = from;
        path.totals = measure(path, machine);
    }
}

}  // namespace stepmill
