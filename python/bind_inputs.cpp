// Parts, tools and machines.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/drawing/drawing.h"
#include "stepmill/part/part.h"
#include "stepmill/part/square_up.h"

namespace py = pybind11;

namespace stepmill::python {
namespace {

namespace fs = std::filesystem;

py::tuple corners(const Box3& box) {
    const auto corner = [](const Vec3& p) { return py::make_tuple(p.x(), p.y(), p.z()); };
    return py::make_tuple(corner(box.min()), corner(box.max()));
}

std::vector<Part> load(const fs::path& file, const std::string& unit,
                       const std::map<std::string, double>& depths, const std::string& outline,
                       double thickness) {
    const py::gil_scoped_release free;
    DrawingOptions drawing;
    drawing.depths = depths;
    drawing.outline = outline;
    drawing.thickness = thickness;
    drawing.unit = unit;
    if (isDrawing(file) || drawing.given()) return {readDrawing(file, drawing)};
    ReadOptions options;
    options.unit = unit;
    std::vector<Part> parts = readStep(file, options);
    for (Part& part : parts)
        part = squaredUp(std::move(part));
    return parts;
}

void bindPart(py::module_& module) {
    py::class_<Part>(module, "Part")
        .def_readonly("file", &Part::file)
        .def_readonly("name", &Part::name)
        .def_readonly("sha256", &Part::sha256)
        .def_readonly("unit_in_file", &Part::unit_in_file)
        .def_readonly("volume_mm3", &Part::volume_mm3)
        .def_readonly("surfaces", &Part::surfaces)
        .def_property_readonly("faces", [](const Part& part) { return part.faces.size(); })
        .def_property_readonly("box_mm", [](const Part& part) { return corners(part.bbox_mm); })
        .def_property_readonly("remarks",
                               [](const Part& part) {
                                   std::vector<std::pair<std::string, std::string>> remarks;
                                   for (const Remark& remark : part.remarks)
                                       remarks.emplace_back(remark.code, remark.text);
                                   return remarks;
                               })
        .def("__repr__", [](const Part& part) { return "<stepmill.Part " + part.name + ">"; });
    module.def("_load", &load, py::arg("file"), py::arg("unit"), py::arg("depths"), py::arg("outline"),
               py::arg("thickness"));
}

void bindLibrary(py::module_& module) {
    py::class_<ToolLibrary>(module, "ToolLibrary")
        .def_readonly("file", &ToolLibrary::file)
        .def_readonly("unit", &ToolLibrary::unit)
        .def_property_readonly("materials", &ToolLibrary::materials)
        .def_property_readonly("tools",
                               [](const ToolLibrary& library) {
                                   std::vector<std::string> ids;
                                   for (const ToolAssembly& tool : library.tools)
                                       ids.push_back(tool.id);
                                   return ids;
                               })
        .def("__len__", [](const ToolLibrary& library) { return library.tools.size(); });
    module.def("_load_tools", [](const std::optional<fs::path>& file) {
        return file ? readToolLibrary(*file) : defaultToolLibrary();
    });
    py::class_<Machine>(module, "Machine").def_readonly("name", &Machine::name);
    module.def("_load_machine", [](const std::optional<fs::path>& file) {
        return file ? readMachine(*file) : defaultMachine();
    });
}

}  // namespace

void bindInputs(py::module_& module) {
    bindPart(module);
    bindLibrary(module);
}

}  // namespace stepmill::python
