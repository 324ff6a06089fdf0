// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/metashape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/import/xml_text.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/text_scanner.h"
#include "limn/files/whole_file.h"
#include "limn/geometry/similarity3.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr double kMaxDroppedSkewPx = 0.5;

std::vector<double> Numbers(const XmlElement& element, const std::string& text, size_t count,
                            const std::string& path) {
  TextScanner scanner(path, text, element.line);
  std::vector<double> numbers;
  while (!scanner.AtEnd()) numbers.push_back(scanner.FiniteNumber(element.name.c_str()));
  if (numbers.size() != count) {
    FilePlace{path, "line", static_cast<uint64_t>(element.line)}.Fail(
        "<" + element.name + "> is not " + std::to_string(count) + " numbers");
  }
  return numbers;
}

double NumberAttribute(const XmlElement& element, const std::string& name,
                       const std::string& path) {
  return Numbers(element, element.Attribute(name), 1, path)[0];
}

// All cameras, also those in groups.
void CollectCameras(const XmlElement& parent, std::vector<const XmlElement*>* cameras) {
  for (const XmlElement& child : parent.children) {
    if (child.name == "camera") cameras->push_back(&child);
    if (child.name == "group") CollectCameras(child, cameras);
  }
}

bool IsAligned(const XmlElement* camera) { return camera->Child("transform") != nullptr; }

struct Chunk {
  const XmlElement* element = nullptr;
  std::vector<const XmlElement*> cameras;

  auto NumAligned() const { return std::ranges::count_if(cameras, IsAligned); }
};

std::vector<Chunk> ChunksOf(const XmlElement& root) {
  std::vector<Chunk> chunks;
  for (const XmlElement& child : root.children) {
    if (child.name != "chunk") continue;
    chunks.push_back({&child, {}});
    const XmlElement* cameras = child.Child("cameras");
    if (cameras) CollectCameras(*cameras, &chunks.back().cameras);
  }
  return chunks;
}

const Chunk& ChooseChunk(const std::vector<Chunk>& chunks, int index, const std::string& path) {
  const FilePlace start{path, "line", 1};
  if (chunks.empty()) start.Fail("no <chunk> of Metashape in this file");
  if (index >= static_cast<int>(chunks.size())) {
    start.Fail("there are only " + std::to_string(chunks.size()) + " chunks, counted from 0");
  }
  if (index >= 0) return chunks[static_cast<size_t>(index)];
  return *std::ranges::max_element(chunks, {}, &Chunk::NumAligned);
}

// Of a component or chunk; nothing if it has none.
std::optional<Similarity3d> TransformOf(const XmlElement& parent, const std::string& path) {
  const XmlElement* transform = parent.Child("transform");
  if (!transform) return std::nullopt;
  Similarity3d world;
  if (const XmlElement* scale = transform->Child("scale")) {
    world.scale = Numbers(*scale, scale->text, 1, path)[0];
    if (!(world.scale > 0)) {
      FilePlace{path, "line", static_cast<uint64_t>(scale->line)}.Fail("<scale> is not positive");
    }
  }
  if (const XmlElement* rotation = transform->Child("rotation")) {
    const std::vector<double> rows = Numbers(*rotation, rotation->text, 9, path);
    world.rotation = RotationFromMatrix(Eigen::Matrix3d::Map(rows.data()).transpose(),
                                        {path, "line", static_cast<uint64_t>(rotation->line)})
                         .toRotationMatrix();
  }
  if (const XmlElement* translation = transform->Child("translation")) {
    const std::vector<double> shift = Numbers(*translation, translation->text, 3, path);
    world.translation = Eigen::Vector3d::Map(shift.data());
  }
  return world;
}

class ChunkReader {
 public:
  ChunkReader(const Chunk& chunk, const std::string& path, ImageFolder* images)
      : chunk_(chunk), path_(path), images_(*images) {}

  void Read(ImportedScene* scene) {
    ReadSensors();
    ReadTransforms();
    size_t num_not_aligned = 0;
    for (const XmlElement* camera : chunk_.cameras) {
      if (!IsAligned(camera)) {
        ++num_not_aligned;
      } else if (auto image = ReadCamera(*camera)) {
        scene->images.push_back(std::move(*image));
      }
    }
    if (num_not_aligned == chunk_.cameras.size()) {
      PlaceOf(*chunk_.element).Fail("no camera is aligned: align the photographs in Metashape");
    }
    if (num_not_aligned > 0) {
      scene->notes.push_back(std::to_string(num_not_aligned) +
                             " cameras are not aligned and are left out");
    }
    if (dropped_skew_px_ > 0) {
      std::ostringstream skew;
      skew << dropped_skew_px_;
      scene->notes.push_back(
          "No camera of COLMAP has skewed pixels: b2 is dropped, which moves "
          "pixels by up to " +
          skew.str() + " px");
    }
  }

 private:
  FilePlace PlaceOf(const XmlElement& element) const {
    return {path_, "line", static_cast<uint64_t>(element.line)};
  }

  void ReadSensors() {
    const XmlElement* sensors = chunk_.element->Child("sensors");
    if (!sensors) return;
    for (const XmlElement& sensor : sensors->children) sensors_[sensor.Attribute("id")] = &sensor;
  }

  void ReadTransforms() {
    world_from_chunk_ = TransformOf(*chunk_.element, path_).value_or(Similarity3d());
    const XmlElement* components = chunk_.element->Child("components");
    if (!components) return;
    for (const XmlElement& component : components->children) {
      if (const auto transform = TransformOf(component, path_)) {
        world_from_component_[component.Attribute("id")] = *transform;
      }
    }
  }

  // As adjusted, else as it was given.
  const XmlElement& CalibrationOf(const XmlElement& sensor, const XmlElement& camera) const {
    const XmlElement* found = nullptr;
    for (const XmlElement& child : sensor.children) {
      if (child.name != "calibration") continue;
      if (!found || child.Attribute("class") == "adjusted") found = &child;
    }
    if (!found) {
      PlaceOf(camera).Fail("sensor \"" + sensor.Attribute("id") + "\" of camera \"" +
                           camera.Attribute("label") +
                           "\" has no <calibration>: align the photographs in Metashape first");
    }
    return *found;
  }

  double Value(const XmlElement& calibration, const char* name) const {
    const XmlElement* child = calibration.Child(name);
    return child ? Numbers(*child, child->text, 1, path_)[0] : 0;
  }

  void SetLens(const XmlElement& calibration, const std::string& sensor_type, Camera* camera) {
    const FilePlace place = PlaceOf(calibration);
    const auto value = [&](const char* name) { return Value(calibration, name); };
    if (!calibration.Child("f")) place.Fail("<calibration> has no <f>");
    if (value("p3") != 0 || value("p4") != 0) {
      place.Fail("P3 and P4 are in none of COLMAP's cameras: export undistorted images");
    }
    const double f = value("f");
    camera->params = {f + value("b1"), f, 0.5 * static_cast<double>(camera->width) + value("cx"),
                      0.5 * static_cast<double>(camera->height) + value("cy")};
    DropSkew(value("b2"), place, *camera);
    const BrownLens lens = {
        {value("k1"), value("k2"), value("k3"), value("k4")}, value("p2"), value("p1")};
    const std::string own_type = calibration.Attribute("type");
    const std::string& type = own_type.empty() ? sensor_type : own_type;
    if (type == "frame" || type.empty()) {
      SetBrownLens(lens, place, camera);
    } else if (type == "fisheye" || type == "equidistant_fisheye") {
      SetFisheyeLens(lens, camera);
    } else {
      place.Fail("cameras of type \"" + type + "\" are not read: export undistorted images");
    }
  }

  void DropSkew(double b2, const FilePlace& place, const Camera& camera) {
    const double skew_px =
        std::abs(b2) * 0.5 * static_cast<double>(camera.height) / std::abs(camera.params[1]);
    if (!(skew_px <= kMaxDroppedSkewPx)) {
      place.Fail("b2 skews the pixels by " + std::to_string(skew_px) +
                 " px at the border of the image, which no camera of COLMAP can hold: optimize "
                 "cameras without b2, or export undistorted images");
    }
    dropped_skew_px_ = std::max(dropped_skew_px_, skew_px);
  }

  std::optional<ImportedImage> ReadCamera(const XmlElement& camera) {
    const FilePlace place = PlaceOf(camera);
    const auto found =
        images_.Find(camera.Attribute("label"), fs::path(path_).parent_path(), place);
    if (!found) return std::nullopt;
    const auto sensor = sensors_.find(camera.Attribute("sensor_id"));
    if (sensor == sensors_.end()) {
      place.Fail("sensor \"" + camera.Attribute("sensor_id") + "\" is not among the sensors");
    }
    ImportedImage image;
    image.path = path_;
    image.number = place.number;
    image.name = found->name;
    const XmlElement& calibration = CalibrationOf(*sensor->second, camera);
    const XmlElement* size = calibration.Child("resolution");
    if (!size) size = sensor->second->Child("resolution");
    if (!size) place.Fail("its sensor has no <resolution>");
    SetStatedSize(NumberAttribute(*size, "width", path_), NumberAttribute(*size, "height", path_),
                  *found, place, &image);
    SetLens(calibration, sensor->second->Attribute("type"), &image.camera);
    image.cam_from_world = PoseOf(camera);
    return image;
  }

  Rigid3d PoseOf(const XmlElement& camera) const {
    const XmlElement& transform = *camera.Child("transform");
    const std::vector<double> rows = Numbers(transform, transform.text, 16, path_);
    const Eigen::Matrix4d matrix = Eigen::Matrix4d::Map(rows.data()).transpose();
    if (!(matrix.row(3).transpose() - Eigen::Vector4d::UnitW()).isZero(1e-9)) {
      PlaceOf(transform).Fail("the last row of <transform> is not 0 0 0 1");
    }
    const auto component = world_from_component_.find(camera.Attribute("component_id"));
    const Similarity3d& world =
        component == world_from_component_.end() ? world_from_chunk_ : component->second;
    const Rigid3d chunk_from_cam = {
        RotationFromMatrix(matrix.topLeftCorner<3, 3>(), PlaceOf(transform)),
        matrix.topRightCorner<3, 1>()};
    return CamFromB(Inverse(chunk_from_cam), world);
  }

  const Chunk& chunk_;
  const std::string& path_;
  ImageFolder& images_;
  std::map<std::string, const XmlElement*> sensors_;
  Similarity3d world_from_chunk_;
  std::map<std::string, Similarity3d> world_from_component_;
  double dropped_skew_px_ = 0;
};

}  // namespace

bool HoldsMetashape(const fs::path& path) { return HoldsCameraFile(path, kMetashapeType); }

ImportedScene ReadMetashape(const ImportInput& input) {
  const std::string path = TheCameraFile(input.path, kMetashapeType).string();
  const XmlElement root = ParseXml(path, ReadWholeFile(path, kMaxJsonBytes));
  const std::vector<Chunk> chunks = ChunksOf(root);
  const Chunk& chunk = ChooseChunk(chunks, input.model_index, path);
  ImportedScene scene;
  scene.notes = {"Read " + path + ", chunk " + std::to_string(&chunk - chunks.data()) + " of " +
                 std::to_string(chunks.size()) + " (counted from 0)"};
  ChunkReader(chunk, path, input.images).Read(&scene);
  return scene;
}

}  // namespace limn::colmap_ext
