// The topology of the file: loops, edges and shells as its entities say, before any geometry is made.

#include <fmt/format.h>

#include "part/step/checks.h"
#include "part/step/kinds.h"

namespace stepmill {
namespace {

/// Vertices of two entities at one place: exporters that share none write the same numbers twice.
constexpr double kSamePlaceShare = 1e-7;

using Id = std::uint32_t;

/// How often the faces of a shell run along an edge and against it.
struct EdgeUse {
    int forward = 0;
    int reverse = 0;
};

class ShellCheck {
  public:
    ShellCheck(const StepScreen& screen, StepText& text) : screen_(screen), text_(text) {}

    void checkEntity(const StepEntity& entity) {
        const std::string_view keyword = model().keywordOf(entity);
        if (entity.last - entity.first != 1) return;
        if (isSolidBody(keyword)) checkBody(entity);
        if (keyword == "SHELL_BASED_SURFACE_MODEL")
            for (const Id shell : valuesOf(entity).list(1).references())
                text_.open_shells += findAs(shell, {"OPEN_SHELL"}) ? 1 : 0;
    }

  private:
    void checkBody(const StepEntity& body) {
        const StepValues values = valuesOf(body);
        StepBody entry{body.id, screen_.nameOf(body), 0, 0, 0};
        std::vector<Id> shells{values[1].word};
        for (const Id id : values.list(2).references())
            shells.push_back(id);
        for (const Id id : shells)
            checkShell(id, entry);
        text_.bodies.push_back(entry);
    }

    const StepModel& model() const { return screen_.model; }

    StepValues valuesOf(const StepEntity& entity) const {
        return model().valuesOf(model().recordsOf(entity).front());
    }

    /// Null where the entity is complex or of another kind: then nothing is known of it.
    const StepEntity* findAs(Id id, std::initializer_list<std::string_view> keywords) const {
        const StepEntity* entity = model().find(id);
        if (!entity || entity->last - entity->first != 1) return nullptr;
        const std::string_view own = model().keywordOf(*entity);
        return std::find(keywords.begin(), keywords.end(), own) == keywords.end() ? nullptr : entity;
    }

    void checkShell(Id id, StepBody& body) {
        const StepEntity* shell = model().find(id);
        if (const StepEntity* oriented = findAs(id, {"ORIENTED_CLOSED_SHELL"}))
            shell = model().find(valuesOf(*oriented)[2].word);
        if (!shell || !findAs(shell->id, {"CLOSED_SHELL"})) return;
        uses_.clear();
        poly_ = false;
        std::set<Id> seen;
        for (const Id face : valuesOf(*shell).list(1).references()) {
            if (!seen.insert(face).second)
                screen_.refuse(ErrorCode::StepDamaged, *shell, fmt::format("names the face #{} twice", face));
            checkFace(face);
        }
        ++body.shells;
        body.faces += static_cast<int>(seen.size());
        body.edges += static_cast<int>(uses_.size());
        if (!poly_) checkUses(*shell);
    }

    void checkFace(Id id) {
        bool forward = true;
        const StepEntity* face = model().find(id);
        if (const StepEntity* oriented = findAs(id, {"ORIENTED_FACE"})) {
            forward = valuesOf(*oriented)[3].isTrue();
            face = model().find(valuesOf(*oriented)[2].word);
        }
        if (!face || !findAs(face->id, {"ADVANCED_FACE", "FACE_SURFACE"})) return;
        for (const Id bound : valuesOf(*face).list(1).references()) {
            const StepEntity* entity = findAs(bound, {"FACE_BOUND", "FACE_OUTER_BOUND"});
            if (!entity) continue;
            const StepValues values = valuesOf(*entity);
            checkLoop(values[1].word, values[2].isTrue() == forward);
        }
    }

    void checkLoop(Id id, bool forward) {
        const StepEntity* loop = findAs(id, {"EDGE_LOOP"});
        poly_ = poly_ || findAs(id, {"POLY_LOOP"});
        if (!loop) return;
        std::vector<std::pair<Id, Id>> ends;
        for (const Id oriented_id : valuesOf(*loop).list(1).references()) {
            const StepEntity* oriented = findAs(oriented_id, {"ORIENTED_EDGE"});
            if (!oriented) return;
            const StepValues values = valuesOf(*oriented);
            const bool along = values[4].isTrue();
            const StepEntity* edge = findAs(values[3].word, {"EDGE_CURVE"});
            if (!edge) return;
            EdgeUse& use = uses_[edge->id];
            ++(along == forward ? use.forward : use.reverse);
            const StepValues vertices = valuesOf(*edge);
            ends.emplace_back(vertices[along ? 1 : 2].word, vertices[along ? 2 : 1].word);
        }
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (!isSameVertex(ends[i].second, ends[(i + 1) % ends.size()].first))
                screen_.refuse(ErrorCode::StepDamaged, *loop,
                               fmt::format("is torn: edge {} ends at #{}, the next begins at #{}", i + 1,
                                           ends[i].second, ends[(i + 1) % ends.size()].first));
    }

    bool isSameVertex(Id a, Id b) const {
        if (a == b) return true;
        const std::vector<double> first = placeOf(a);
        const std::vector<double> second = placeOf(b);
        if (first.size() != second.size()) return false;
        double size = 0;
        double distance = 0;
        for (std::size_t i = 0; i < first.size(); ++i) {
            size = std::max(size, std::abs(first[i]));
            distance = std::max(distance, std::abs(first[i] - second[i]));
        }
        return distance <= kSamePlaceShare * size;
    }

    std::vector<double> placeOf(Id vertex) const {
        const StepEntity* entity = findAs(vertex, {"VERTEX_POINT"});
        const StepEntity* point = entity ? findAs(valuesOf(*entity)[1].word, {"CARTESIAN_POINT"}) : nullptr;
        return point ? valuesOf(*point).list(1).numbers() : std::vector<double>{};
    }

    void checkUses(const StepEntity& shell) {
        for (const auto& [id, use] : uses_) {
            const StepEntity& edge = *model().find(id);
            if (use.forward + use.reverse == 1)
                screen_.refuse(
                    ErrorCode::OpenShell, edge,
                    fmt::format("bounds one face of #{} CLOSED_SHELL; it is not closed", shell.id));
            if (use.forward == use.reverse) continue;
            text_.doubts.push_back(
                fmt::format("line {}: {} is used {} times along and {} times against its direction in #{} "
                            "CLOSED_SHELL; a "
                            "face beside it is turned over",
                            edge.line, screen_.nameOf(edge), use.forward, use.reverse, shell.id));
            return;
        }
    }

    const StepScreen& screen_;
    StepText& text_;
    std::map<Id, EdgeUse> uses_;
    bool poly_ = false;  ///< faces bounded by points: edges are not named
};

}  // namespace

void checkShells(const StepScreen& screen, StepText& text) {
    ShellCheck check(screen, text);
    for (const StepEntity& entity : screen.model.entities())
        check.checkEntity(entity);
}

}  // namespace stepmill
