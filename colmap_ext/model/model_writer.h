#pragma once

#include <filesystem>
#include <ostream>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// The files of a model as COLMAP 3.8 writes them, in the order of the model's vectors. Numbers in
// text are the shortest that read back the same. Preconditions: the invariants of a model that was
// read.
void WriteCamerasBinary(const SparseModel& model, std::ostream& out);
void WriteImagesBinary(const SparseModel& model, std::ostream& out);
void WritePointsBinary(const SparseModel& model, std::ostream& out);
void WriteCamerasText(const SparseModel& model, std::ostream& out);
void WriteImagesText(const SparseModel& model, std::ostream& out);
void WritePointsText(const SparseModel& model, std::ostream& out);

// Throws InputError if images.txt could not be read back because of the name of an image.
void CheckTextNames(const SparseModel& model);

// Write cameras, images, points3D and, where the model has some, rigs and frames into an existing
// folder. Throw IoError, as text also what
// CheckTextNames throws.
void WriteModelBinary(const SparseModel& model, const std::filesystem::path& folder);
void WriteModelText(const SparseModel& model, const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
