#include "toolpath/script/block_partition.h"

#include <algorithm>
#include <numeric>

namespace stepmill::toolpath {

namespace {

/// The block of each spot; blocks are named by their first spot.
class Partition {
  public:
    explicit Partition(std::size_t spots) : block_of_(spots) {
        std::iota(block_of_.begin(), block_of_.end(), std::size_t{0});
    }

    void join(std::size_t a, std::size_t b) {
        const auto [into, from] = std::minmax(block_of_[a], block_of_[b]);
        std::replace(block_of_.begin(), block_of_.end(), std::size_t{from}, std::size_t{into});
    }

    std::vector<std::size_t> blocks() const {
        std::vector<std::size_t> blocks = block_of_;
        std::sort(blocks.begin(), blocks.end());
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        return blocks;
    }

    std::size_t blockOf(std::size_t spot) const { return block_of_[spot]; }

  private:
    std::vector<std::size_t> block_of_;
};

Partition partitionOf(const DepthProgress& cut) {
    const std::vector<Descent>& descents = cut.descents();
    Partition partition(descents.size());
    const auto join_all_before = [&](std::size_t spot) {
        for (std::size_t before = 0; before < spot; ++before)
            partition.join(before, spot);
    };
    for (std::size_t spot = 0; spot < descents.size(); ++spot)
        if (descents[spot].needs_others) join_all_before(spot);
    for (int i = 0; i < cut.count(); ++i) {
        if (!cut.wasCut(i)) continue;
        for (const int j : cut.pass(i).after) {
            if (cut.wasCut(j))
                partition.join(cut.spotOf(i), cut.spotOf(j));
            else
                join_all_before(cut.spotOf(i));  // some of them have cleared its ground
        }
    }
    return partition;
}

SweptGround groundOf(std::size_t block, const Partition& partition, const DepthTask& task,
                     const DepthProgress& cut) {
    SweptGround ground = task.untouched;
    for (int i = 0; i < cut.count(); ++i)
        if (cut.wasCut(i) && partition.blockOf(cut.spotOf(i)) == block)
            for (const Edge& edge : edgesOf(cut.pass(i).path))
                ground.add(edge);
    return ground;
}

DepthBlock makeBlock(std::size_t block, const Partition& partition, const DepthTask& task,
                     const DepthProgress& cut) {
    const std::vector<Descent>& descents = cut.descents();
    const SweptGround ground = groundOf(block, partition, task, cut);
    DepthBlock made;
    for (std::size_t spot = 0; spot < descents.size(); ++spot) {
        if (partition.blockOf(spot) != block) continue;
        const Descent& descent = descents[spot];
        const bool last_spot = spot + 1 == descents.size();
        const std::size_t next = last_spot ? cut.steps().size() : descents[spot + 1].step;
        const std::size_t at = made.steps.size();
        made.steps.insert(made.steps.end(), cut.steps().begin() + static_cast<std::ptrdiff_t>(descent.step),
                          cut.steps().begin() + static_cast<std::ptrdiff_t>(next));
        if (at == 0)
            made.begin = descent.to;
        else
            setOver(made.steps[at], overWay(task.standing, ground, made.end, descent.to));
        made.end = last_spot ? cut.at() : descents[spot + 1].from;
    }
    made.next_over = overWay(task.standing, ground, made.end, made.begin);
    return made;
}

}  // namespace

std::vector<DepthBlock> blocksApart(const DepthTask& task, const DepthProgress& cut) {
    const Partition partition = partitionOf(cut);
    const std::vector<std::size_t> names = partition.blocks();
    std::vector<DepthBlock> blocks;
    if (names.size() < 2) return blocks;
    for (const std::size_t block : names)
        blocks.push_back(makeBlock(block, partition, task, cut));
    return blocks;
}

}  // namespace stepmill::toolpath
