#include <map>

#include "stepmill/core/enum_words.h"
#include "stepmill/feature/part_form.h"

namespace stepmill {
namespace {

constexpr EnumWord<FormClass> kFormClasses[] = {{FormClass::Pocket, "pocket"},
                                                {FormClass::Passage, "passage"},
                                                {FormClass::BlindSlot, "blind slot"},
                                                {FormClass::ThroughSlot, "through slot"},
                                                {FormClass::VSlot, "V slot"},
                                                {FormClass::ThroughStep, "through step"},
                                                {FormClass::BlindStep, "blind step"},
                                                {FormClass::Hole, "hole"},
                                                {FormClass::Chamfer, "chamfer"},
                                                {FormClass::EdgeFillet, "edge fillet"},
                                                {FormClass::InnerFillet, "inner fillet"},
                                                {FormClass::FreeForm, "free form"},
                                                {FormClass::Open, "open"}};

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
    return wordOf(kFormClasses, form_class);
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
