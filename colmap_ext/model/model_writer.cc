// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/model_writer.h"

#include <algorithm>

#include "colmap_ext/model/image_name.h"
#include "limn/files/atomic_file.h"
#include "limn/files/writable_folder.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

template <typename T>
void Put(const T& value, std::ostream& out) {
  out.write(reinterpret_cast<const char*>(&value), sizeof(T));
}

void PutVector(const Eigen::Vector3d& v, std::ostream& out) {
  for (const double value : v) Put(value, out);
}

// A number in text, with a space before it.
struct Spaced {
  double value;
};

std::ostream& operator<<(std::ostream& out, Spaced number) {
  return out << ' ' << NumberText(number.value);
}

std::ostream& operator<<(std::ostream& out, const Eigen::Vector3d& v) {
  return out << Spaced{v.x()} << Spaced{v.y()} << Spaced{v.z()};
}

std::ostream& operator<<(std::ostream& out, const Eigen::Quaterniond& q) {
  return out << Spaced{q.w()} << Spaced{q.x()} << Spaced{q.y()} << Spaced{q.z()};
}

void WriteFiles(std::span<const ModelFile> files, const SparseModel& model,
                const OutputPath& folder) {
  for (const ModelFile& file : files) {
    if (file.is_of_rigs) RemoveFile(folder / file.name);
  }
  for (const ModelFile& file : files) {
    if (file.is_of_rigs && model.rigs.empty()) continue;
    WriteFileAtomically(folder / file.name, [&](std::ostream& out) { file.write(model, out); });
  }
}

}  // namespace

std::span<const ModelFile> ModelFilesOf(ModelFlavor flavor) {
  if (flavor == ModelFlavor::kBinary) return kBinaryModelFiles;
  return kTextModelFiles;
}

void WriteCamerasBinary(const SparseModel& model, std::ostream& out) {
  Put<uint64_t>(model.cameras.size(), out);
  for (const Camera& camera : model.cameras) {
    Put(camera.id, out);
    Put(static_cast<int32_t>(camera.model), out);
    Put(camera.width, out);
    Put(camera.height, out);
    for (const double param : camera.params) Put(param, out);
  }
}

void WriteImagesBinary(const SparseModel& model, std::ostream& out) {
  Put<uint64_t>(model.images.size(), out);
  for (const ModelImage& image : model.images) {
    const Eigen::Quaterniond& q = image.cam_from_world.rotation;
    Put(image.id, out);
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) Put(value, out);
    PutVector(image.cam_from_world.translation, out);
    Put(image.camera_id, out);
    const std::string& name = image.StoredName();
    out.write(name.c_str(), static_cast<std::streamsize>(name.size() + 1));
    Put<uint64_t>(image.observations.size(), out);
    for (const Observation& observation : image.observations) {
      Put(observation.position.x(), out);
      Put(observation.position.y(), out);
      Put(observation.point3D_id, out);
    }
  }
}

void WritePointsBinary(const SparseModel& model, std::ostream& out) {
  Put<uint64_t>(model.points.size(), out);
  for (const ModelPoint& point : model.points) {
    Put(point.id, out);
    PutVector(point.position, out);
    Put(point.color, out);
    Put(point.error, out);
    Put<uint64_t>(point.track.size(), out);
    for (const TrackElement& element : point.track) {
      Put(element.image_id, out);
      Put(element.observation, out);
    }
  }
}

bool HasTextNames(const SparseModel& model) {
  return std::ranges::all_of(model.images, [](const ModelImage& image) {
    return ProblemOfNameInText(image.StoredName()).empty();
  });
}

void CheckTextNames(const SparseModel& model) {
  for (const ModelImage& image : model.images) {
    const std::string problem = ProblemOfNameInText(image.StoredName());
    if (!problem.empty()) throw InputError(problem + ": rename the image");
  }
}

void WriteCamerasText(const SparseModel& model, std::ostream& out) {
  out << "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
  for (const Camera& camera : model.cameras) {
    out << camera.id << ' ' << FindCameraModel(static_cast<int32_t>(camera.model))->name << ' '
        << camera.width << ' ' << camera.height;
    for (const double param : camera.params) out << Spaced{param};
    out << '\n';
  }
}

void WriteImagesText(const SparseModel& model, std::ostream& out) {
  out << "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n"
         "# POINTS2D[] as (X, Y, POINT3D_ID)\n";
  for (const ModelImage& image : model.images) {
    out << image.id << image.cam_from_world.rotation << image.cam_from_world.translation << ' '
        << image.camera_id << ' ' << image.StoredName() << '\n';
    for (const Observation& observation : image.observations) {
      // The invalid id is written as -1.
      out << Spaced{observation.position.x()} << Spaced{observation.position.y()} << ' '
          << static_cast<int64_t>(observation.point3D_id);
    }
    out << '\n';
  }
}

void WritePointsText(const SparseModel& model, std::ostream& out) {
  out << "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
  for (const ModelPoint& point : model.points) {
    out << point.id << point.position;
    for (const uint8_t channel : point.color) out << ' ' << static_cast<int>(channel);
    out << Spaced{point.error};
    for (const TrackElement& element : point.track) {
      out << ' ' << element.image_id << ' ' << element.observation;
    }
    out << '\n';
  }
}

void WriteModelBinary(const SparseModel& model, const OutputPath& folder) {
  WriteFiles(kBinaryModelFiles, model, folder);
}

void WriteModelText(const SparseModel& model, const OutputPath& folder) {
  CheckTextNames(model);
  WriteFiles(kTextModelFiles, model, folder);
}

void WriteModel(const SparseModel& model, ModelFlavor flavor, const OutputPath& folder) {
  if (flavor == ModelFlavor::kText) return WriteModelText(model, folder);
  WriteModelBinary(model, folder);
}

}  // namespace limn::colmap_ext
