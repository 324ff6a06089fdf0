// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/tracked_points.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace limn::colmap_ext {
namespace {

uint8_t ReadColor(TextScanner* scanner) {
  const double value = scanner->Number("color");
  if (!(value >= 0 && value <= 255)) scanner->Fail("color outside 0 to 255");
  return static_cast<uint8_t>(std::lround(value));
}

void ReadMeasurement(const ImageOfCamera& image_of_camera, TextScanner* scanner, ModelPoint* point,
                     TrackedPoints* tracked) {
  const int camera = scanner->Count("camera index of a measurement");
  if (camera >= static_cast<int>(image_of_camera.size())) {
    scanner->Fail("camera index " + std::to_string(camera) + ", but there are only " +
                  std::to_string(image_of_camera.size()) + " cameras");
  }
  scanner->Count("feature index of a measurement");
  Observation observation;
  observation.position.x() = scanner->FiniteNumber("x of a measurement");
  observation.position.y() = scanner->FiniteNumber("y of a measurement");
  observation.point3D_id = point->id;
  const int image = image_of_camera[camera];
  if (image < 0) return;
  std::vector<Observation>& observations = tracked->observations[image];
  point->track.push_back(
      {static_cast<uint32_t>(image + 1), static_cast<uint32_t>(observations.size())});
  observations.push_back(observation);
}

}  // namespace

TrackedPoints ReadTrackedPoints(int count, const ImageOfCamera& image_of_camera,
                                TextScanner* scanner) {
  TrackedPoints tracked;
  const auto last = std::max_element(image_of_camera.begin(), image_of_camera.end());
  tracked.observations.resize(last == image_of_camera.end() ? 0 : *last + 1);
  for (int i = 0; i < count; ++i) {
    ModelPoint point;
    point.id = tracked.points.size() + 1;
    point.position = scanner->Point();
    for (uint8_t& channel : point.color) channel = ReadColor(scanner);
    const int num_measurements = scanner->Count("number of measurements");
    for (int m = 0; m < num_measurements; ++m) {
      ReadMeasurement(image_of_camera, scanner, &point, &tracked);
    }
    tracked.points.push_back(std::move(point));
  }
  return tracked;
}

}  // namespace limn::colmap_ext
