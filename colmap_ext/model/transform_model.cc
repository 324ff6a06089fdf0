// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/transform_model.h"

namespace limn::colmap_ext {

void TransformModel(const Similarity3d& b_from_a, SparseModel* model) {
  for (ModelImage& image : model->images) {
    image.cam_from_world = CamFromB(image.cam_from_world, b_from_a);
  }
  for (Frame& frame : model->frames) {
    frame.rig_from_world = CamFromB(frame.rig_from_world, b_from_a);
  }
  for (Rig& rig : model->rigs) {
    for (RigSensor& sensor : rig.sensors) sensor.sensor_from_rig.translation *= b_from_a.scale;
  }
  for (ModelPoint& point : model->points) point.position = b_from_a * point.position;
}

}  // namespace limn::colmap_ext
