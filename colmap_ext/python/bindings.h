#pragma once

#include <pybind11/pybind11.h>

#include "colmap_ext/python/stages.h"

namespace limn::colmap_ext {

// One function per part of the module; classes before the functions that take or return them.
void BindErrors();
void BindScene(pybind11::module_* module);
void BindImageCurves(pybind11::module_* module);
void BindDrawing(pybind11::module_* module);
void BindMemory(pybind11::module_* module);
void BindStages(pybind11::module_* module);

// Warnings, and stages as dictionaries.
pybind11::list WarningsOf(const RunLog& log);
pybind11::list StagesOf(const RunLog& log);

// A line as the program would print it. Bytes of paths that are not valid text become escapes that
// os.fsencode turns back into the same bytes.
pybind11::str LineOf(const std::string& text);

// The index of Python's item i of n; negative ones count from the end. Raises IndexError.
size_t IndexOf(pybind11::ssize_t i, size_t n);

// An iterator over any sequence with __getitem__.
pybind11::iterator IterateSequence(const pybind11::object& sequence);

// The view of this name. Raises KeyError.
ViewId ViewNamed(const std::vector<View>& views, const std::string& name);

}  // namespace limn::colmap_ext
