#include "part/step/text.h"
#include "stepmill/core/plain_text.h"

namespace stepmill {

std::string_view skipPreamble(std::string_view text) {
    text = withoutByteOrderMark(text);
    while (true) {
        const std::size_t start = text.find_first_not_of(" \t\r\n");
        text.remove_prefix(start == std::string_view::npos ? text.size() : start);
        if (!text.starts_with("/*")) return text;
        const std::size_t end = text.find("*/");
        if (end == std::string_view::npos) return text;
        text.remove_prefix(end + 2);
    }
}

std::string guessFormat(std::string_view bytes) {
    const std::string_view text = skipPreamble(bytes);
    const auto contains = [&](std::string_view what) {
        return bytes.substr(0, 4096).find(what) != std::string_view::npos;
    };
    if (bytes.starts_with("\x1f\x8b")) return "a gzip archive; unpack it first";
    if (bytes.starts_with("PK\x03\x04")) return "a ZIP archive; unpack it first";
    if (bytes.starts_with("%PDF")) return "a PDF document";
    if (text.starts_with("solid") && contains("facet"))
        return "an ASCII STL mesh; export a STEP solid instead";
    if (text.starts_with("<?xml") || text.starts_with("<")) return "XML or HTML";
    if (text.starts_with("{") || text.starts_with("[")) return "JSON";
    if (bytes.size() > 80 &&
        bytes.substr(72, 8).find_first_not_of(" 0123456789SG") == std::string_view::npos && bytes[72] == 'S')
        return "an IGES file; export STEP instead";
    if (text.starts_with("DBRep_DrawableShape") || contains("CASCADE Topology"))
        return "an OpenCASCADE BREP file; export STEP instead";
    int control = 0;
    int high = 0;
    for (const char c : bytes.substr(0, 4096)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f') ++control;
        if (byte >= 0x80) ++high;
    }
    // A quarter of bytes beyond ASCII is more than any language's letters in Latin-1 text.
    const bool binary = control > 0 || 4 * high > static_cast<int>(std::min<std::size_t>(bytes.size(), 4096));
    return binary ? "binary data" : "plain text";
}

}  // namespace stepmill
