// SPDX-License-Identifier: BSD-3-Clause
// Work that does not look whether it was asked to stop, run as the package runs its own.

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include "colmap_ext/python/run_free.h"
#include "limn/files/temporary_path.h"

namespace limn::colmap_ext {
namespace {

std::atomic<int> num_working = 0;

// Reports progress once, when the file, if it has a name, is half written.
void Work(double seconds, const std::filesystem::path& file, RunMonitor* monitor) {
  ++num_working;
  std::optional<TemporaryPath> half_written;
  if (!file.empty()) {
    half_written.emplace(file, [&](const auto&, const auto&) { std::ofstream(file) << 1; });
  }
  monitor->SetProgress("stubborn", 0, 1);
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  --num_working;
}

}  // namespace
}  // namespace limn::colmap_ext

PYBIND11_MODULE(stubborn_work, module) {
  namespace py = pybind11;
  using limn::colmap_ext::RunMonitor;
  limn::colmap_ext::WatchInterpreter();
  module.def(
      "work",
      [](double seconds, const py::object& progress, const std::filesystem::path& file) {
        limn::colmap_ext::RunWithoutLock(progress, [seconds, file](RunMonitor* monitor) {
          limn::colmap_ext::Work(seconds, file, monitor);
        });
      },
      py::arg("seconds"), py::arg("progress"), py::arg("file") = "");
  module.def("num_working", [] { return limn::colmap_ext::num_working.load(); });
}
