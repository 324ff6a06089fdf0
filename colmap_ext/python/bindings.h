// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "colmap_ext/python/stages.h"

namespace limn::colmap_ext {

// One function per part of the module; classes before the functions that take or return them.
// Python makes no instances of the classes (Seal), and copies of what cannot be changed are the
// same object. Drawings and what is in them, cameras and scenes of folders can be pickled.
void BindErrors();
void BindScene(pybind11::module_* module);
void BindImageCurves(pybind11::module_* module);
void BindDrawing(pybind11::module_* module);
void BindMemory(pybind11::module_* module);
void BindStages(pybind11::module_* module);

// The last: after it, instances of the classes of the module come from its functions only, since
// __new__ would leave their memory as it is.
void Seal(const pybind11::module_& module);

// What Python sees of a view.
struct SceneCamera {
  std::string name;
  PinholeCamera camera;
  Rigid3d cam_from_world;
  bool has_lens = false;
};
std::vector<SceneCamera> CamerasOf(const std::vector<View>& views);

// Warnings, and stages as dictionaries.
pybind11::list WarningsOf(const RunLog& log);
pybind11::list StagesOf(const RunLog& log);

// A line as the program would print it. Bytes of paths that are not valid text become escapes that
// os.fsencode turns back into the same bytes.
pybind11::str LineOf(const std::string& text);

// A pickle is a call: of the function that makes an object again, with what it is made from.
pybind11::tuple CallOf(const pybind11::object& function, const pybind11::tuple& arguments);

// A function of limn._pickles.
pybind11::object PickleFunction(const char* name);

// The index of Python's item i of n; negative ones count from the end. Raises IndexError.
size_t IndexOf(pybind11::ssize_t i, size_t n);

// What item(i) gives of every index of a slice of a sequence of n.
template <typename Item>
auto SliceOf(const pybind11::slice& slice, size_t n, const Item& item) {
  size_t start = 0, stop = 0, step = 0, length = 0;
  if (!slice.compute(n, &start, &stop, &step, &length)) throw pybind11::error_already_set();
  std::vector<decltype(item(start))> items;
  items.reserve(length);
  for (size_t i = 0; i < length; ++i, start += step) items.push_back(item(start));
  return items;
}

// An iterator over any sequence with __getitem__.
pybind11::iterator IterateSequence(const pybind11::object& sequence);

// The view of this name. Raises KeyError.
ViewId ViewNamed(const std::vector<View>& views, const std::string& name);

}  // namespace limn::colmap_ext
