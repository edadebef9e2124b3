#include <algorithm>
#include <map>

#include "feature/form_class.h"
#include "stepmill/core/groups.h"
#include "stepmill/feature/hole.h"
#include "stepmill/feature/part_form.h"

namespace stepmill {
namespace {

bool isRound(const FaceShape& face) {
    return face.surface == "cylinder" || face.surface == "cone" || face.surface == "sphere" ||
           face.surface == "torus";
}

bool isFreeForm(const FaceShape& face) {
    return face.surface != "plane" && !isRound(face);
}

struct Contacts {
    int smooth = 0;
    int concave = 0;
    int convex = 0;
};

std::vector<Contacts> contactsOf(const FaceGraph& graph) {
    std::vector<Contacts> contacts(graph.faces.size());
    for (const FaceEdge& edge : graph.edges)
        for (const int face : {edge.first, edge.second})
            ++(edge.bend == Bend::Smooth    ? contacts[face].smooth
               : edge.bend == Bend::Concave ? contacts[face].concave
                                            : contacts[face].convex);
    return contacts;
}

/// Forms of one face, named without their neighbours' help.
std::optional<FormClass> alone(const FaceShape& face, const Contacts& contacts) {
    if (isFreeForm(face)) return FormClass::FreeForm;
    if (!isRound(face)) return std::nullopt;
    // A blend runs smoothly into a face on either side.
    if (contacts.smooth >= 2) return face.hollow ? FormClass::InnerFillet : FormClass::EdgeFillet;
    if (face.surface == "cone" && contacts.concave == 0 && contacts.convex > 0) return FormClass::Chamfer;
    return std::nullopt;
}

class FormFinder {
  public:
    FormFinder(const FaceGraph& graph, const std::vector<bool>& on_stock, const Tolerances& tol)
        : graph_(graph), on_stock_(on_stock), tol_(tol), taken_(on_stock) {}

    std::vector<PartForm> run() {
        for (const Hole& hole : findHoles(graph_, tol_))
            addWhole(FormClass::Hole, hole.faces);
        const std::vector<Contacts> contacts = contactsOf(graph_);
        for (const FaceShape& face : graph_.faces)
            if (const auto form = alone(face, contacts[face.index])) addWhole(*form, {face.index});
        addGroups();
        std::sort(forms_.begin(), forms_.end(),
                  [](const PartForm& a, const PartForm& b) { return a.faces.front() < b.faces.front(); });
        for (std::size_t i = 0; i < forms_.size(); ++i)
            forms_[i].id = "P" + std::to_string(i + 1);
        return std::move(forms_);
    }

  private:
    /// Faces of a form that are all there, none of them taken before.
    void addWhole(FormClass form_class, const std::vector<int>& faces) {
        PartForm form;
        form.form_class = form_class;
        for (const int face : faces)
            if (!taken_[face]) form.faces.push_back(face);
        if (form.faces.empty()) return;
        for (const int face : form.faces)
            taken_[face] = true;
        form.flat = false;
        form.square = false;
        form.right_angles = false;
        forms_.push_back(std::move(form));
    }

    void addGroups() {
        const auto free = [&](int face) { return !taken_[face]; };
        Groups groups(graph_.faces.size());
        for (const FaceEdge& edge : graph_.edges)
            if (edge.bend == Bend::Concave && free(edge.first) && free(edge.second))
                groups.join(edge.first, edge.second);
        joinAcrossRounds(groups);
        std::map<int, std::vector<int>> members;
        for (const FaceShape& face : graph_.faces)
            if (free(face.index)) members[groups.of(face.index)].push_back(face.index);
        for (auto& [root, faces] : members)
            forms_.push_back(feature::nameForm(graph_, on_stock_, std::move(faces)));
    }

    /// A round between two faces of a cut stands for the inner edge it breaks.
    void joinAcrossRounds(Groups& groups) const {
        std::map<int, std::vector<int>> beside;
        for (const FaceEdge& edge : graph_.edges) {
            if (edge.bend != Bend::Smooth) continue;
            for (const auto& [round, other] : {std::pair(edge.first, edge.second), {edge.second, edge.first}})
                if (isInnerFillet(round) && !taken_[other]) beside[round].push_back(other);
        }
        for (const auto& [round, faces] : beside)
            for (const int face : faces)
                groups.join(faces.front(), face);
    }

    bool isInnerFillet(int face) const {
        return std::any_of(forms_.begin(), forms_.end(), [&](const PartForm& form) {
            return form.form_class == FormClass::InnerFillet && form.faces.front() == face;
        });
    }

    const FaceGraph& graph_;
    const std::vector<bool>& on_stock_;
    const Tolerances& tol_;
    std::vector<bool> taken_;
    std::vector<PartForm> forms_;
};

}  // namespace

std::vector<PartForm> partForms(const FaceGraph& graph, const std::vector<bool>& on_stock,
                                const Tolerances& tol) {
    return FormFinder(graph, on_stock, tol).run();
}

}  // namespace stepmill
