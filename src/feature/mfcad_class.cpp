#include <map>

#include "stepmill/core/error.h"
#include "stepmill/feature/part_form.h"

namespace stepmill {
namespace {

std::optional<std::string> bySides(int sides, const std::string& what) {
    static const std::map<int, std::string> kWords{{3, "triangular"}, {4, "rectangular"}, {6, "6sides"}};
    const auto word = kWords.find(sides);
    if (word == kWords.end()) return std::nullopt;
    return word->second + "_" + what;
}

std::string throughStep(const PartForm& form) {
    if (form.sides == 2) return "2sides_through_step";
    return form.square ? "rectangular_through_step" : "slanted_through_step";
}

}  // namespace

std::string toString(FormClass form_class) {
    switch (form_class) {
        case FormClass::Pocket:
            return "pocket";
        case FormClass::Passage:
            return "passage";
        case FormClass::BlindSlot:
            return "blind slot";
        case FormClass::ThroughSlot:
            return "through slot";
        case FormClass::VSlot:
            return "V slot";
        case FormClass::ThroughStep:
            return "through step";
        case FormClass::BlindStep:
            return "blind step";
        case FormClass::Hole:
            return "hole";
        case FormClass::Chamfer:
            return "chamfer";
        case FormClass::EdgeFillet:
            return "edge fillet";
        case FormClass::InnerFillet:
            return "inner fillet";
        case FormClass::FreeForm:
            return "free form";
        case FormClass::Open:
            return "open";
    }
    throw Error(ErrorCode::Internal, "form class", "unknown value");
}

std::optional<std::string> mfcadClass(const PartForm& form) {
    if (!form.flat) return std::nullopt;
    switch (form.form_class) {
        case FormClass::Pocket:
            return bySides(form.sides, "pocket");
        case FormClass::Passage:
            return bySides(form.sides, "passage");
        case FormClass::BlindSlot:
            return "rectangular_blind_slot";
        case FormClass::ThroughSlot:
            return "rectangular_through_slot";
        case FormClass::VSlot:
            return "triangular_through_slot";
        case FormClass::ThroughStep:
            return throughStep(form);
        case FormClass::BlindStep:
            return form.sides == 1 ? "triangular_blind_step" : "rectangular_blind_step";
        case FormClass::Chamfer:
            return "chamfer";
        default:
            return std::nullopt;
    }
}

}  // namespace stepmill
