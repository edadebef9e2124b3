#include "report/viewer/viewer_section.h"

#include "report/page/document.h"
#include "report/viewer/viewer_scripts.h"

namespace stepmill::report {
namespace {

/// All of ours as one script that leaves no name behind.
const std::string& viewerScript() {
    static const std::string script = [] {
        std::string text = "\"use strict\";\n{\n";
        for (const std::string_view piece :
             {kViewerDataScript, kViewerPathScript, kViewerFieldScript, kViewerRunScript, kViewerShapesScript,
              kViewerStageScript, kViewerPanelScript, kViewerMainScript})
            text += piece;
        return text + "}\n";
    }();
    return script;
}

}  // namespace

Element viewerSection() {
    return Element(
               "section", Element("h2", "Viewer"),
               Element("p.soft",
                       "The viewer needs a browser with JavaScript and WebGL. What it shows stands in this "
                       "page as tables and drawings as well.")
                   .at(Anchor("viewer", "message")),
               Element("div.viewer").at(Anchor("viewer", "frame")))
        .at(Anchor("part", "viewer"));
}

std::string viewerDocument(const std::string& title, Element main, const std::string& data) {
    const PageScripts scripts{{kThreeLicence, kThree, kOrbitControls, viewerScript()}, kViewerStyle};
    return scriptedDocument(title, std::move(main), dataElement(Anchor("data", "viewer"), data), scripts);
}

}  // namespace stepmill::report
