#include "stepmill/plan/sequence_memory.h"

#include <algorithm>
#include <optional>
#include <type_traits>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {
namespace {

/// Trials that are turned down come between plans that are alike.
constexpr int kPlansKept = 4;

/// All that a sequence follows from, byte by byte: equal bytes, equal sequences.
class Key {
  public:
    template <typename Value>
    requires std::is_arithmetic_v<Value> || std::is_enum_v<Value>
    void add(Value value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
    void add(const std::string& text) {
        add(text.size());
        bytes_ += text;
    }
    void add(const Vec2& p) {
        add(p.x());
        add(p.y());
    }
    template <typename Value>
    void add(const std::optional<Value>& value) {
        add(value.has_value());
        if (value) add(*value);
    }
    template <typename Value>
    void add(const std::vector<Value>& values) {
        add(values.size());
        for (const Value& value : values)
            add(value);
    }
    void add(const Arc& arc) {
        add(arc.centre);
        add(arc.radius_mm);
        add(arc.ccw);
    }
    void add(const Segment& segment) {
        add(segment.to);
        add(segment.arc);
    }
    void add(const Path& path) {
        add(path.start);
        add(path.segments);
    }
    void add(const Region& region) { add(region.loops); }
    void add(const Obstacle& obstacle) {
        add(obstacle.bottom_z_mm);
        add(obstacle.top_z_mm);
        add(obstacle.section);
    }
    void add(const BoundaryPiece& piece) {
        add(piece.path);
        add(piece.open);
    }
    void add(const DiameterRange& range) {
        add(range.least_mm);
        add(range.most_mm);
    }
    void add(const Feature& feature) {
        add(feature.band.has_value() && feature.band->isUpper());
        add(feature.feature_class);
        for (const double mm :
             {feature.top_z_mm, feature.floor_z_mm, feature.point_mm, feature.open_length_mm,
              feature.closed_length_mm, feature.area_mm2, feature.volume_mm3})
            add(mm);
        add(feature.through);
        add(feature.room_below_mm);
        add(feature.drilled);
        add(feature.min_corner_radius_mm);
        add(feature.target);
        add(feature.obstruction);
        add(feature.skirt);
        add(feature.boundary);
        add(feature.obstacles);
    }
    void add(const SequenceOptions& options) {
        add(options.material);
        add(options.cut_material ? options.cut_material->name : std::string());
        add(options.objective);
        add(options.retract_mm);
        add(options.surrogates);
        add(options.cost_model);
        add(options.clear_of_own_material);
        add(options.pattern);
        add(options.patterns);
        add(options.finish.walls_mm);
        add(options.finish.floors_mm);
        add(options.first_at_least_mm);
    }
    /// Under a taller stock a tool may be of no use that is of use under others.
    void add(const ToolLibrary& library, const std::string& material) {
        add(library.tools.size());
        for (const ToolAssembly& tool : library.tools) {
            add(tool.id);
            add(tool.cuttingFor(material) != nullptr);
        }
    }
    std::string hashed() const { return sha256(bytes_); }

  private:
    std::string bytes_;
};

}  // namespace

ToolSequence SequenceMemory::sequence(const Feature& feature, const ToolLibrary& library,
                                      const SequenceOptions& options, const Make& make) {
    Key key;
    key.add(feature);
    key.add(library, options.material);
    key.add(options);
    const std::string what = key.hashed();
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = known_.find(what); found != known_.end()) {
            found->second.asked_in = plan_;
            ToolSequence same = found->second.sequence;
            same.feature_id = feature.id;
            return same;
        }
        if (const auto given = in_vain_.find(what);
            given != in_vain_.end() && options.deadline.secondsLeft() <= given->second)
            throw Error(ErrorCode::TimedOut, feature.id, "it was given as long in a plan before");
    }
    // Not under the lock: it is the long part, and starts tasks. Two threads that make the same make equals.
    const double given_s = options.deadline.secondsLeft();
    try {
        ToolSequence made = make();
        const std::lock_guard lock(mutex_);
        known_.insert_or_assign(what, Known{made, plan_});
        return made;
    } catch (const Error& error) {
        if (error.code() != ErrorCode::TimedOut) throw;
        const std::lock_guard lock(mutex_);
        double& longest_s = in_vain_.try_emplace(what, given_s).first->second;
        longest_s = std::max(longest_s, given_s);
        throw;
    }
}

void SequenceMemory::beginPlan() {
    const std::lock_guard lock(mutex_);
    std::erase_if(known_, [&](const auto& entry) { return entry.second.asked_in + kPlansKept <= plan_; });
    ++plan_;
}

}  // namespace stepmill
