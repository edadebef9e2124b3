#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/part/face_graph.h"

namespace stepmill {

/// What a group of part faces is by itself, whatever setup machines it.
enum class FormClass {
    Pocket,       ///< floor with walls all round
    Passage,      ///< walls all round, no floor
    BlindSlot,    ///< floor with three walls, the outer two parallel
    ThroughSlot,  ///< floor between two parallel walls
    VSlot,        ///< two walls that lean against each other
    ThroughStep,  ///< floor and one wall that runs from end to end
    BlindStep,    ///< floor and walls round one corner
    Hole,         ///< a stack of bores on one axis
    Chamfer,      ///< one flat or conical face across an edge
    EdgeFillet,   ///< outer round that runs smoothly into its neighbours
    InnerFillet,  ///< inner round that runs smoothly into its neighbours
    FreeForm,     ///< faces that are neither flat nor round about an axis
    Open          ///< joined faces that are none of these: part of an outside
};
std::string toString(FormClass form_class);

/// Faces that meet in inner edges, with what they make.
struct PartForm {
    std::string id;  ///< "P1", by least face index
    FormClass form_class = FormClass::Open;
    std::vector<int> faces;  ///< ascending
    /// Surfaces that bound it, a floor not counted; faces in one plane are one.
    int sides = 0;
    /// The face that all sides stand upon, where there is one.
    std::optional<int> floor;
    /// Are all its faces flat?
    bool flat = true;
    /// Flat forms: is every face parallel to a face of the stock, or square to all others of the form?
    bool square = true;
    /// Do the sides turn by a right angle where they meet?
    bool right_angles = true;
};

/// The part's faces sorted into forms. Faces on the stock's skin belong to none.
///
/// Two cuts that cross meet in outer edges, the faces of one cut in inner ones: groups joined by inner (and,
/// at rounds, smooth) edges are single cuts even where cuts cross. Faces in one plane count once, so a side
/// that another cut splits is one side. A group is named by its sides, its floor, and whether the sides'
/// normals go all round.
/// \param on_stock  by face: lies on the raw stock's skin
/// \note  O(faces + edges) but for faces of one form, which are compared with each other.
std::vector<PartForm> partForms(const FaceGraph& graph, const std::vector<bool>& on_stock,
                                const Tolerances& tol);

/// The class of the MFCAD data set that a form is, nothing where none fits: its 16 classes know flat faces
/// and 3, 4 or 6 sides alone.
/// \see docs/algorithms/features.md for the table
std::optional<std::string> mfcadClass(const PartForm& form);

}  // namespace stepmill
