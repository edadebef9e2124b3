// Tool bits (.fctb) and libraries (.fctl) of FreeCAD.

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "crib/freecad_folder.h"
#include "crib/json_reader.h"
#include "crib/tool_maker.h"
#include "crib/type_words.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;
using crib::fieldText;
using crib::JsonReader;

class FreeCadBit {
  public:
    FreeCadBit(const JsonReader& from, const std::string& file, const ForeignOptions& options)
        : from_(from), file_(file), options_(options) {}

    ForeignTool read(int number) {
        ToolAssembly& tool = foreign_.tool;
        foreign_.place = from_.pointer();
        tool.number = number;
        tool.description = fieldText(from_.text("name"), 900);
        takeType();
        const std::optional<JsonReader> parameters = from_.object("parameter");
        if (!foreign_.unfit.empty() || !parameters) {
            crib::finishTool(foreign_, 0, file_, options_);
            return std::move(foreign_);
        }
        takeSizes(*parameters);
        takeForm(*parameters);
        takeWords(*parameters);
        if (const auto attributes = from_.object("attribute")) takeWords(*attributes);
        crib::finishTool(foreign_, length(*parameters, "Pitch"), file_, options_);
        return std::move(foreign_);
    }

  private:
    /// Older bits name a shape's file alone.
    void takeType() {
        const std::string type = from_.text("shape-type");
        const std::string shape = from_.text("shape");
        crib::TypeWord word = crib::typeOfWords(type);
        if (!word.type && word.unfit.empty()) word = crib::typeOfWords(fs::path(shape).stem().string());
        if (word.type) crib::setType(foreign_.tool, *word.type);
        if (!word.type)
            foreign_.unfit = !word.unfit.empty() ? word.unfit
                                                 : fmt::format("'{}' is no shape of tool that Stepmill knows",
                                                               fieldText(type.empty() ? shape : type, 60));
    }

    void takeSizes(const JsonReader& parameters) {
        ToolAssembly& tool = foreign_.tool;
        tool.diameter_mm = length(parameters, "Diameter");
        tool.flute_length_mm = length(parameters, "CuttingEdgeHeight");
        tool.stick_out_mm = length(parameters, "Stickout");
        // Where a shank begins is not told: right over the flutes is the safe side.
        tool.shank.diameter_mm = length(parameters, "ShankDiameter");
        tool.shank.bottom_mm = tool.flute_length_mm;
        tool.shank.top_mm = tool.stick_out_mm;
    }

    void takeForm(const JsonReader& parameters) {
        ToolAssembly& tool = foreign_.tool;
        if (tool.type == ToolType::Bull) {
            tool.corner_radius_mm =
                length(parameters, parameters.has("CornerRadius") ? "CornerRadius" : "TorusRadius");
            if (tool.corner_radius_mm == 0 && parameters.has("FlatRadius"))
                foreign_.notes.push_back(
                    "FlatRadius left aside: programs differ on what it means; expected "
                    "CornerRadius");
        }
        if ((tool.isDrill() || tool.isSpot()) && parameters.has("TipAngle"))
            tool.point_angle_deg = angle(parameters, "TipAngle");
        if (tool.hasFlanks()) {
            tool.tip_diameter_mm = length(parameters, "TipDiameter");
            tool.included_angle_deg = angle(parameters, "CuttingEdgeAngle");
        }
    }

    void takeWords(const JsonReader& from) {
        ToolAssembly& tool = foreign_.tool;
        if (from.has("Flutes"))
            tool.flutes = static_cast<int>(std::clamp(quantity(from, "Flutes").first, 0.0, 100.0));
        if (from.has("Material") && crib::plainWords(from.text("Material")) == " hss ")
            tool.cutter_material = CutterMaterial::Hss;
        if (from.has("Vendor")) tool.vendor = fieldText(from.text("Vendor"), 900);
        if (from.has("PartNumber")) tool.product_id = fieldText(from.text("PartNumber"), 900);
    }

    double length(const JsonReader& from, const char* field) {
        if (!from.has(field)) return 0;
        const auto [value, unit] = quantity(from, field);
        if (value < 0) from.refuseField(field, "a length of 0 or more");
        if (unit.empty() || unit == "mm") return value;
        if (unit == "in" || unit == "\"") {
            foreign_.is_inch = true;
            return value * crib::mmPerUnit("inch").value();
        }
        constexpr double kMmPerMetre = 1000;
        constexpr double kMmPerUm = 1e-3;
        if (unit == "m") return value * kMmPerMetre;
        if (unit == "cm") return value * 10;
        if (unit == "um" || unit == "µm") return value * kMmPerUm;
        from.refuseField(field, "a length in mm, cm, m or in");
    }

    static double angle(const JsonReader& from, const char* field) {
        if (!from.has(field)) return 0;
        const auto [value, unit] = quantity(from, field);
        if (value < 0 || !(unit.empty() || unit == "°" || unit == "deg"))
            from.refuseField(field, "an angle in degrees");
        return value;
    }

    /// "5.0000 mm", "1/4 in", "90 °" or a number: FreeCAD's own units are mm and degrees.
    static std::pair<double, std::string> quantity(const JsonReader& from, const char* field) {
        const nlohmann::json& value = from.value()[field];
        if (value.is_number()) return {from.number(field), ""};
        const std::string text = from.text(field);
        const std::size_t end = text.find_first_not_of("0123456789.,+-eE/ ");
        std::string number = text.substr(0, end);
        number.erase(std::remove(number.begin(), number.end(), ' '), number.end());
        std::string unit = end == std::string::npos ? "" : text.substr(end);
        while (!unit.empty() && unit.back() == ' ')
            unit.pop_back();
        const std::size_t stroke = number.find('/');
        const auto above = crib::numberOf(number.substr(0, stroke));
        const auto below =
            stroke == std::string::npos ? std::optional(1.0) : crib::numberOf(number.substr(stroke + 1));
        if (!above || !below || *below == 0)
            from.refuseField(field, "a number with a unit, such as \"5 mm\"");
        return {*above / *below, unit};
    }

    const JsonReader& from_;
    const std::string& file_;
    const ForeignOptions& options_;
    ForeignTool foreign_;
};

/// A library beside its bits: FreeCAD keeps both in one folder, or in Library and Bit side by side.
class FreeCadFolder {
  public:
    FreeCadFolder(fs::path folder, const ForeignOptions& options)
        : folder_(std::move(folder)), options_(options) {}

    ForeignLibrary library(const fs::path& file) const {
        const std::string name = file.filename().string();
        const nlohmann::json root = JsonReader::parse(readFile(file, options_.max_file_bytes), name);
        const JsonReader reader(root, name);
        if (!reader.has("tools"))
            crib::refuse(name, "#", "expected the list \"tools\" of a FreeCAD tool library, found none");
        ForeignLibrary library{name, {}};
        for (const JsonReader& entry : reader.list("tools")) {
            if (library.tools.size() == crib::kMostTools)
                crib::refuse(name, entry.pointer(),
                             fmt::format("expected at most {} tools", crib::kMostTools));
            const double number = std::clamp(entry.number("nr"), 0.0, 99999.0);
            library.tools.push_back(bit(bitOf(entry), static_cast<int>(number)));
        }
        return library;
    }

    /// Every bit of the folder by name, without numbers.
    ForeignLibrary all() const {
        std::vector<fs::path> bits;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            if (entry.path().extension() == ".fctb") bits.push_back(entry.path());
        std::sort(bits.begin(), bits.end());
        ForeignLibrary library{fs::absolute(folder_).lexically_normal().filename().string(), {}};
        if (library.file.empty()) library.file = folder_.string();
        if (bits.empty()) crib::refuse(library.file, "folder", "expected .fctb or .fctl files, found none");
        if (bits.size() > crib::kMostTools)
            crib::refuse(library.file, "folder", fmt::format("expected at most {} tools", crib::kMostTools));
        for (const fs::path& file : bits)
            library.tools.push_back(bit(file, 0));
        return library;
    }

    ForeignTool bit(const fs::path& file, int number) const {
        ForeignTool tool = freeCadBitFromText(readFile(file, options_.max_file_bytes),
                                              file.filename().string(), number, options_);
        tool.place = file.filename().string();
        return tool;
    }

  private:
    /// A library names its bits; a name with a way to other folders is none.
    fs::path bitOf(const JsonReader& entry) const {
        const std::string path = entry.text("path");
        const bool is_name = !path.empty() && path.find_first_of("/\\") == std::string::npos &&
                             path != ".." && path.find('\0') == std::string::npos;
        if (!is_name) entry.refuseField("path", "the name of a .fctb file without folders");
        for (const fs::path& folder : {folder_, folder_.parent_path() / "Bit", folder_ / "Bit"})
            if (fs::is_regular_file(folder / path)) return folder / path;
        entry.refuseField("path", "a file beside the library or in the folder Bit");
    }

    fs::path folder_;
    const ForeignOptions& options_;
};

}  // namespace

ForeignTool freeCadBitFromText(std::string_view text, const std::string& name, int number,
                               const ForeignOptions& options) {
    const nlohmann::json root = JsonReader::parse(text, name);
    if (!root.is_object()) crib::refuse(name, "#", "expected a tool bit of FreeCAD, found something else");
    const JsonReader reader(root, name);
    return FreeCadBit(reader, name, options).read(number);
}

ForeignLibrary crib::readFreeCad(const fs::path& file, const ForeignOptions& options) {
    if (fs::is_directory(file)) {
        std::vector<fs::path> libraries;
        for (const fs::directory_entry& entry : fs::directory_iterator(file))
            if (entry.path().extension() == ".fctl") libraries.push_back(entry.path());
        const FreeCadFolder folder(file, options);
        if (libraries.size() > 1)
            crib::refuse(file.string(), "folder",
                         "expected one .fctl, found several; name the one to import");
        return libraries.empty() ? folder.all() : folder.library(libraries.front());
    }
    const fs::path folder = fs::absolute(file).parent_path();
    if (file.extension() == ".fctl") return FreeCadFolder(folder, options).library(file);
    return {file.filename().string(), {FreeCadFolder(folder, options).bit(file, 0)}};
}

}  // namespace stepmill
