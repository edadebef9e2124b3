// What is made of a part. Results leave as the JSON that the program writes: one model, one schema.

#include <pybind11/stl.h>

#include "bindings.h"
#include "stepmill/catalog/material.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/region.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/report/inspection.h"
#include "stepmill/report/quote.h"
#include "stepmill/report/rank.h"
#include "stepmill/study/inspection.h"

namespace py = pybind11;

namespace stepmill::python {
namespace {

/// A loop's points as rows x, y: memoryview() and numpy.asarray() read it without a copy.
struct Points {
    std::vector<Vec2> points;
};

std::vector<Points> loopsOf(const Region& region, double chord_mm) {
    if (!(chord_mm > 0)) throw Error(ErrorCode::Usage, "chord_mm", "expected a chord's height above 0");
    std::vector<Points> loops;
    for (const Loop& loop : region.loops)
        loops.push_back({tessellate(loop, chord_mm)});
    return loops;
}

SetupRequest setupRequest(const std::vector<std::string>& setups) {
    SetupRequest request;
    request.stock_tolerance_mm = kSawnToleranceMm;
    for (const std::string& setup : setups) {
        const std::optional<Vec3> axis = parseAxis(setup);
        if (!axis)
            throw Error(ErrorCode::Usage, "setups",
                        "expected axes such as +z or x,y,z, found '" + setup + "'");
        request.axes.push_back(*axis);
    }
    return request;
}

SequenceOptions sequenceOptions(const Machine& machine, const std::string& material, bool by_cost) {
    SequenceOptions options;
    options.material = material;
    options.objective = by_cost ? Objective::Cost : Objective::Time;
    options.retract_mm = machine.safe_height_mm;
    return options;
}

/// As `stepmill plan` asks without options.
PlanRequest planRequest(const std::vector<std::string>& setups, const Machine& machine,
                        const std::string& material, bool by_cost) {
    PlanRequest request;
    request.setup = setupRequest(setups);
    request.sequence = sequenceOptions(machine, material, by_cost);
    request.scallop_mm = 0.02;
    const MaterialFile materials = defaultMaterials();
    request.materials_file = materials.file;
    if (const Material* known = materials.find(material)) request.sequence.cut_material = *known;
    return request;
}

ProvenPlan plan(const Part& part, const ToolLibrary& tools, const Machine& machine,
                const std::string& material, const std::vector<std::string>& setups, bool by_cost,
                const std::string& unit) {
    const py::gil_scoped_release free;
    PlanRequest request = planRequest(setups, machine, material, by_cost);
    request.unit = unit;
    return planProven(part, request, tools, machine, Tolerances());
}

std::map<std::string, std::string> programsOf(const ProvenPlan& proven) {
    std::map<std::string, std::string> programs;
    if (proven.mayRun())
        for (const auto& [setup, posted] : proven.files.programs)
            for (const PostedProgram& program : posted)
                programs[program.file] = program.text;
    return programs;
}

const Feature& featureOf(const Plan& planned, const std::string& id) {
    for (const PlannedSetup& setup : planned.setups)
        for (const PlannedFeature& feature : setup.features)
            if (feature.feature.id == id) return feature.feature;
    throw Error(ErrorCode::Usage, id, "expected the id of a feature of the plan");
}

void bindPlan(py::module_& module) {
    py::class_<ProvenPlan>(module, "_Plan")
        .def_property_readonly("json_text", [](const ProvenPlan& proven) { return proven.files.plan_json; })
        .def_property_readonly("may_run", &ProvenPlan::mayRun)
        .def_property_readonly("complete",
                               [](const ProvenPlan& proven) { return proven.plan.complete(Tolerances()); })
        .def_property_readonly("programs", &programsOf)
        .def_property_readonly("features",
                               [](const ProvenPlan& proven) {
                                   std::vector<std::string> ids;
                                   for (const PlannedSetup& setup : proven.plan.setups)
                                       for (const PlannedFeature& feature : setup.features)
                                           ids.push_back(feature.feature.id);
                                   return ids;
                               })
        .def("target", [](const ProvenPlan& proven, const std::string& id,
                          double chord_mm) { return loopsOf(featureOf(proven.plan, id).target, chord_mm); })
        .def("obstruction", [](const ProvenPlan& proven, const std::string& id, double chord_mm) {
            return loopsOf(featureOf(proven.plan, id).obstruction, chord_mm);
        });
    module.def("_plan", &plan);
}

void bindStudies(py::module_& module) {
    module.def("_inspect", [](const Part& part, const std::vector<std::string>& setups) {
        const py::gil_scoped_release free;
        InspectRequest request;
        request.setup = setupRequest(setups);
        return inspectionJson(inspectPart(part, request, Tolerances()));
    });
    module.def("_rank", [](const Part& part, const ToolLibrary& tools, const Machine& machine,
                           const std::string& material, const std::vector<std::string>& setups,
                           const std::string& feature) {
        const py::gil_scoped_release free;
        RankRequest request;
        request.setup = setupRequest(setups);
        request.sequence = sequenceOptions(machine, material, false);
        request.feature = feature;
        return rankJson(rankPart(part, request, tools, machine, Tolerances()));
    });
    module.def("_quote", [](const ProvenPlan& proven, const std::vector<int>& quantities) {
        const py::gil_scoped_release free;
        QuoteTerms terms;
        terms.quantities = quantities;
        return quoteJson(quotePlan(proven.plan, terms, Tolerances()));
    });
}

}  // namespace

void bindResults(py::module_& module) {
    py::class_<Points>(module, "Points", py::buffer_protocol())
        .def_buffer([](Points& points) {
            return py::buffer_info(
                points.points.empty() ? nullptr : points.points.front().data(), sizeof(double),
                py::format_descriptor<double>::format(), 2,
                {static_cast<py::ssize_t>(points.points.size()), py::ssize_t{2}},
                {static_cast<py::ssize_t>(sizeof(Vec2)), static_cast<py::ssize_t>(sizeof(double))}, true);
        })
        .def("__len__", [](const Points& points) { return points.points.size(); });
    bindPlan(module);
    bindStudies(module);
}

}  // namespace stepmill::python
