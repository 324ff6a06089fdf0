// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "colmap_ext/host/mpi_backend.h"
#include "limn/formats/step/step_drawing_writer.h"

namespace limn::colmap_ext {

// Parts of the program in libraries of their own (plugins/), which are loaded when they are needed,
// so that nobody must have the libraries they use: limn_step.so and limn_mpi.so, in the folder
// lib/limn/plugins that belongs to the program or the Python module. Once loaded they stay until
// the process ends.
//
// Throw IoError if there is none, one of another build, one that others can write, or one that
// cannot be loaded, such as without the libraries that it uses.

// WriteDrawingStep.
StepFileWriter LoadStepWriter();

// Initializes MPI.
std::unique_ptr<MpiBackend> LoadMpi();

}  // namespace limn::colmap_ext
