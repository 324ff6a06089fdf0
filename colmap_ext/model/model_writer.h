// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <span>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/rig.h"
#include "colmap_ext/model/rig_files.h"
#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// Cameras, images and points as COLMAP 3.8 writes them, in the order of the model's vectors.
// Numbers in text are the shortest that read back the same. Preconditions: the invariants of a
// model that was read.
void WriteCamerasBinary(const SparseModel& model, std::ostream& out);
void WriteImagesBinary(const SparseModel& model, std::ostream& out);
void WritePointsBinary(const SparseModel& model, std::ostream& out);
void WriteCamerasText(const SparseModel& model, std::ostream& out);
void WriteImagesText(const SparseModel& model, std::ostream& out);
void WritePointsText(const SparseModel& model, std::ostream& out);

// A file of a model, in the order in which they are written.
struct ModelFile {
  const char* name;
  void (*write)(const SparseModel& model, std::ostream& out);
  bool is_of_rigs = false;  // written only if the model has rigs
};
constexpr ModelFile kBinaryModelFiles[] = {{"cameras.bin", WriteCamerasBinary},
                                           {"images.bin", WriteImagesBinary},
                                           {"points3D.bin", WritePointsBinary},
                                           {"rigs.bin", WriteRigsBinary, true},
                                           {"frames.bin", WriteFramesBinary, true}};
constexpr ModelFile kTextModelFiles[] = {{"cameras.txt", WriteCamerasText},
                                         {"images.txt", WriteImagesText},
                                         {"points3D.txt", WritePointsText},
                                         {"rigs.txt", WriteRigsText, true},
                                         {"frames.txt", WriteFramesText, true}};
std::span<const ModelFile> ModelFilesOf(ModelFlavor flavor);

// Whether images.txt could be read back, whatever the names of images. CheckTextNames throws
// InputError if not, and names the image.
bool HasTextNames(const SparseModel& model);
void CheckTextNames(const SparseModel& model);

// Write these files, each atomically, into a folder, which is created if missing. Existing files of
// rigs and frames are removed first: they would replace the new poses. Throw IoError; the text
// writer also throws what CheckTextNames throws, before anything is changed.
void WriteModelBinary(const SparseModel& model, const OutputPath& folder);
void WriteModelText(const SparseModel& model, const OutputPath& folder);
void WriteModel(const SparseModel& model, ModelFlavor flavor, const OutputPath& folder);

}  // namespace limn::colmap_ext
