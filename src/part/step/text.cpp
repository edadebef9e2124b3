#include "part/step/text.h"

#include "part/step/checks.h"
#include "part/step/kinds.h"
#include "part/step/syntax.h"
#include "stepmill/core/plain_text.h"

namespace stepmill {
namespace {

void countKinds(const StepModel& model, StepText& text) {
    for (const StepEntity& entity : model.entities()) {
        const std::string_view keyword = model.keywordOf(entity);
        if (isShapeEntity(keyword)) ++text.kinds[std::string(keyword)];
    }
}

}  // namespace

StepText screenStep(std::string_view text, const std::string& file) {
    if (text.empty()) throw Error(ErrorCode::NotStep, file, "the file is empty");
    const std::string_view body = skipPreamble(text);
    if (body.empty()) throw Error(ErrorCode::NotStep, file, "the file holds nothing but blank space");
    if (!body.starts_with("ISO-10303-21"))
        throw Error(
            ErrorCode::NotStep, file,
            "not a STEP file: it should begin with ISO-10303-21; and looks like " + guessFormat(text));
    StepText result;
    StepModel model;
    StepSyntax(withoutByteOrderMark(text), file, result, model).read();
    countKinds(model, result);
    const StepScreen screen{model, file};
    checkReferences(screen, result);
    checkParameters(screen);
    checkSplines(screen);
    checkShells(screen, result);
    checkContext(screen, result);
    return result;
}

}  // namespace stepmill
