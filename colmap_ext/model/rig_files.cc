#include <array>
#include <utility>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/model/record_reading.h"
#include "colmap_ext/model/rig.h"

namespace limn::colmap_ext {
namespace {

constexpr int32_t kCameraSensor = 0;
constexpr uint64_t kRigBytes = 8;        // without sensors
constexpr uint64_t kFrameBytes = 68;     // without data
constexpr uint64_t kRigSensorBytes = 8;  // without has_pose, as the reference sensor
constexpr uint64_t kFrameDataBytes = 16;

Rigid3d ReadPose(ByteReader& reader, const std::string& what) {
  const FilePlace place = reader.Here();
  const auto quaternion = reader.Get<std::array<double, 4>>("rotation");
  const auto translation = reader.Get<std::array<double, 3>>("translation");
  return MakePose(quaternion, {translation[0], translation[1], translation[2]}, what, place);
}

Rigid3d ReadPose(Fields& fields, const std::string& what) {
  std::array<double, 4> quaternion;
  for (double& q : quaternion) q = fields.Number<double>("QW QX QY QZ");
  Eigen::Vector3d translation;
  for (double& t : translation) t = fields.Number<double>("TX TY TZ");
  return MakePose(quaternion, translation, what, fields.place());
}

std::string RigText(uint32_t id) { return "rig " + std::to_string(id); }
std::string FrameText(uint32_t id) { return "frame " + std::to_string(id); }

}  // namespace

std::vector<Rig> ReadRigsBinary(std::istream& in, const std::string& path) {
  ByteReader reader(path, in);
  std::vector<Rig> rigs(ReadCount(reader, "number of rigs", kRigBytes));
  for (Rig& rig : rigs) {
    rig.id = reader.Get<uint32_t>("rig_id");
    const uint32_t num_sensors = ReadCount32(reader, "number of sensors", kRigSensorBytes);
    for (uint32_t i = 0; i < num_sensors; ++i) {
      const auto type = reader.Get<int32_t>("sensor type");
      const auto id = reader.Get<uint32_t>("sensor id");
      const bool is_reference = i == 0;
      RigCamera camera;
      camera.has_pose = is_reference || reader.Get<uint8_t>("has_pose") != 0;
      if (camera.has_pose && !is_reference) camera.cam_from_rig = ReadPose(reader, RigText(rig.id));
      if (type == kCameraSensor) rig.cameras.emplace(id, camera);
    }
  }
  reader.ExpectEnd();
  return rigs;
}

std::vector<Rig> ReadRigsText(std::istream& in, const std::string& path) {
  LineReader reader(in, path);
  std::vector<Rig> rigs;
  while (reader.NextRecord()) {
    Fields fields(reader);
    Rig rig;
    rig.id = fields.Number<uint32_t>("RIG_ID");
    const auto num_sensors = fields.Number<uint32_t>("NUM_SENSORS");
    for (uint32_t i = 0; i < num_sensors; ++i) {
      const std::string type(fields.Next("SENSOR_TYPE"));
      const auto id = fields.Number<uint32_t>("SENSOR_ID");
      const bool is_reference = i == 0;
      RigCamera camera;
      camera.has_pose = is_reference || fields.Number<int>("HAS_POSE") != 0;
      if (camera.has_pose && !is_reference) camera.cam_from_rig = ReadPose(fields, RigText(rig.id));
      if (type == "CAMERA") rig.cameras.emplace(id, camera);
    }
    rigs.push_back(std::move(rig));
  }
  return rigs;
}

std::vector<Frame> ReadFramesBinary(std::istream& in, const std::string& path) {
  ByteReader reader(path, in);
  std::vector<Frame> frames(ReadCount(reader, "number of frames", kFrameBytes));
  for (Frame& frame : frames) {
    frame.id = reader.Get<uint32_t>("frame_id");
    frame.rig_id = reader.Get<uint32_t>("rig_id");
    frame.rig_from_world = ReadPose(reader, FrameText(frame.id));
    const uint32_t num_data = ReadCount32(reader, "number of data ids", kFrameDataBytes);
    for (uint32_t i = 0; i < num_data; ++i) {
      const auto type = reader.Get<int32_t>("sensor type");
      reader.Get<uint32_t>("sensor id");
      const auto data_id = reader.Get<uint64_t>("data id");
      if (type == kCameraSensor) frame.image_ids.push_back(data_id);
    }
  }
  reader.ExpectEnd();
  return frames;
}

std::vector<Frame> ReadFramesText(std::istream& in, const std::string& path) {
  LineReader reader(in, path);
  std::vector<Frame> frames;
  while (reader.NextRecord()) {
    Fields fields(reader);
    Frame frame;
    frame.id = fields.Number<uint32_t>("FRAME_ID");
    frame.rig_id = fields.Number<uint32_t>("RIG_ID");
    frame.rig_from_world = ReadPose(fields, FrameText(frame.id));
    const auto num_data = fields.Number<uint32_t>("NUM_DATA_IDS");
    for (uint32_t i = 0; i < num_data; ++i) {
      const std::string type(fields.Next("SENSOR_TYPE"));
      fields.Number<uint32_t>("SENSOR_ID");
      const auto data_id = fields.Number<uint64_t>("DATA_ID");
      if (type == "CAMERA") frame.image_ids.push_back(data_id);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace limn::colmap_ext
