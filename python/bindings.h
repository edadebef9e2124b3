#pragma once

#include <pybind11/pybind11.h>

namespace stepmill::python {

/// Part, ToolLibrary, Machine and how they are loaded.
void bindInputs(pybind11::module_& module);
/// inspect, rank, plan and quote, and what they give.
void bindResults(pybind11::module_& module);

}  // namespace stepmill::python
