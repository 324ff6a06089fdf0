// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include <pybind11/pybind11.h>

#include "colmap_ext/python/bindings.h"
#include "colmap_ext/python/run_free.h"
#include "limn/util/errors.h"
#include "limn/util/latest_stage.h"
#include "limn/version.h"

namespace limn::colmap_ext {

namespace py = pybind11;

namespace {

// Sets the exception of this name of limn.errors.
void Raise(const char* name, const char* text) {
  const py::object type = py::module_::import("limn.errors").attr(name);
  PyErr_SetObject(type.ptr(), LineOf(text).ptr());
}

void Translate(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const OptionError& known) {
    Raise("OptionError", known.what());
  } catch (const InputError& known) {
    Raise("InputError", known.what());
  } catch (const IoError& known) {
    Raise("IoError", known.what());
  } catch (const std::filesystem::filesystem_error& known) {
    Raise("IoError", known.what());
  } catch (const std::bad_alloc&) {
    PyErr_SetString(PyExc_MemoryError, OutOfMemoryText("").c_str());
  } catch (const std::system_error& known) {
    // No memory for another thread.
    const bool is_short = known.code() == std::errc::resource_unavailable_try_again;
    const std::string text = is_short ? OutOfMemoryText("") : known.what();
    PyErr_SetString(is_short ? PyExc_MemoryError : PyExc_RuntimeError, text.c_str());
  }
}

// Of objects that cannot be changed.
py::object Itself(const py::object& self) { return self; }
py::object DeepItself(const py::object& self, const py::object&) { return self; }

}  // namespace

void Seal(const py::module_& module) {
  for (const auto& [name, value] : module.attr("__dict__").cast<py::dict>()) {
    if (!PyType_Check(value.ptr())) continue;
    const auto type = py::reinterpret_borrow<py::object>(value);
    // pybind11 makes its instances by tp_alloc.
    reinterpret_cast<PyTypeObject*>(type.ptr())->tp_new = nullptr;
    type.attr("__copy__") = py::cpp_function(Itself, py::is_method(type), py::name("__copy__"));
    type.attr("__deepcopy__") = py::cpp_function(DeepItself, py::is_method(type),
                                                 py::name("__deepcopy__"), py::arg("memo"));
    PyType_Modified(reinterpret_cast<PyTypeObject*>(type.ptr()));
  }
}

void BindErrors() { py::register_exception_translator(Translate); }

}  // namespace limn::colmap_ext

PYBIND11_MODULE(_limn, module) {
  module.doc() = "The compiled part of limn.";
  module.attr("__version__") = LIMN_VERSION;
  limn::colmap_ext::WatchInterpreter();
  limn::colmap_ext::BindErrors();
  limn::colmap_ext::BindScene(&module);
  limn::colmap_ext::BindImageCurves(&module);
  limn::colmap_ext::BindDrawing(&module);
  limn::colmap_ext::BindMemory(&module);
  limn::colmap_ext::BindStages(&module);
  limn::colmap_ext::Seal(module);
}
