// The Python module: stepmill::Error becomes stepmill.Error.

#include "bindings.h"
#include "stepmill/core/error.h"

namespace py = pybind11;

namespace {

/// Errors of input are Error; what is a bug of Stepmill is InternalError, which is an Error too.
void translate(std::exception_ptr thrown, PyObject* error, PyObject* internal) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const stepmill::Error& wrong) {
        PyObject* const type = stepmill::isInputError(wrong.code()) ? error : internal;
        py::object value = py::reinterpret_borrow<py::object>(type)(wrong.what());
        value.attr("subject") = wrong.subject();
        PyErr_SetObject(type, value.ptr());
    }
}

}  // namespace

PYBIND11_MODULE(_stepmill, module) {
    module.doc() = "Stepmill's own objects; import stepmill, which documents them.";
    module.attr("__version__") = STEPMILL_VERSION;
    // Never freed: exceptions outlive the module.
    static PyObject* const error = PyErr_NewException("stepmill.Error", PyExc_ValueError, nullptr);
    static PyObject* const internal = PyErr_NewException("stepmill.InternalError", error, nullptr);
    module.add_object("Error", error);
    module.add_object("InternalError", internal);
    py::register_exception_translator([](std::exception_ptr thrown) { translate(thrown, error, internal); });
    stepmill::python::bindInputs(module);
    stepmill::python::bindResults(module);
}
