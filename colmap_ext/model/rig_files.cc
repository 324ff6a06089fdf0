// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/rig_files.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/model/record_reading.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

// By type, from 0.
constexpr std::string_view kSensorNames[] = {"CAMERA", "IMU"};
constexpr std::string_view kInvalidSensorName = "INVALID";
constexpr int32_t kInvalidSensor = -1;
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

SensorId ReadSensor(ByteReader& reader) {
  const auto type = reader.Get<int32_t>("sensor type");
  return {type, reader.Get<uint32_t>("sensor id")};
}

// Types that are unknown are kept as invalid.
SensorId ReadSensor(Fields& fields) {
  const std::string_view name = fields.Next("SENSOR_TYPE");
  const auto known = std::find(std::begin(kSensorNames), std::end(kSensorNames), name);
  const bool is_known = known != std::end(kSensorNames);
  const int32_t type = is_known ? static_cast<int32_t>(known - kSensorNames) : kInvalidSensor;
  return {type, fields.Number<uint32_t>("SENSOR_ID")};
}

std::string RigText(uint32_t id) { return "rig " + std::to_string(id); }
std::string FrameText(uint32_t id) { return "frame " + std::to_string(id); }

void PutPose(const Rigid3d& pose, ByteWriter* bytes) {
  const Eigen::Quaterniond& q = pose.rotation;
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) bytes->Put(value);
  for (const double value : pose.translation) bytes->Put(value);
}

void PutSensor(const SensorId& sensor, ByteWriter* bytes) {
  bytes->Put(sensor.type);
  bytes->Put(sensor.id);
}

void PutPose(const Rigid3d& pose, std::ostream& out) {
  const Eigen::Quaterniond& q = pose.rotation;
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) out << ' ' << NumberText(value);
  for (const double value : pose.translation) out << ' ' << NumberText(value);
}

void PutSensor(const SensorId& sensor, std::ostream& out) {
  const bool is_known = sensor.type >= 0 && sensor.type < static_cast<int>(std::size(kSensorNames));
  out << ' ' << (is_known ? kSensorNames[sensor.type] : kInvalidSensorName) << ' ' << sensor.id;
}

}  // namespace

std::vector<Rig> ReadRigsBinary(std::istream& in, const std::string& path) {
  ByteReader reader(path, in);
  std::vector<Rig> rigs(ReadCount(reader, "number of rigs", kRigBytes));
  for (Rig& rig : rigs) {
    rig.id = reader.Get<uint32_t>("rig_id");
    const uint32_t num_sensors = ReadCount32(reader, "number of sensors", kRigSensorBytes);
    for (uint32_t i = 0; i < num_sensors; ++i) {
      RigSensor sensor;
      sensor.sensor = ReadSensor(reader);
      const bool is_reference = i == 0;
      sensor.has_pose = is_reference || reader.Get<uint8_t>("has_pose") != 0;
      if (sensor.has_pose && !is_reference) {
        sensor.sensor_from_rig = ReadPose(reader, RigText(rig.id));
      }
      rig.sensors.push_back(sensor);
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
      RigSensor sensor;
      sensor.sensor = ReadSensor(fields);
      const bool is_reference = i == 0;
      sensor.has_pose = is_reference || fields.Number<int>("HAS_POSE") != 0;
      if (sensor.has_pose && !is_reference) {
        sensor.sensor_from_rig = ReadPose(fields, RigText(rig.id));
      }
      rig.sensors.push_back(sensor);
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
      const SensorId sensor = ReadSensor(reader);
      frame.data.push_back({sensor, reader.Get<uint64_t>("data id")});
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
      const SensorId sensor = ReadSensor(fields);
      frame.data.push_back({sensor, fields.Number<uint64_t>("DATA_ID")});
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

void WriteRigsBinary(const SparseModel& model, std::ostream& out) {
  ByteWriter bytes;
  bytes.PutCount(model.rigs.size());
  for (const Rig& rig : model.rigs) {
    bytes.Put(rig.id);
    bytes.Put(static_cast<uint32_t>(rig.sensors.size()));
    for (size_t i = 0; i < rig.sensors.size(); ++i) {
      const RigSensor& sensor = rig.sensors[i];
      PutSensor(sensor.sensor, &bytes);
      if (i == 0) continue;
      bytes.Put(static_cast<uint8_t>(sensor.has_pose));
      if (sensor.has_pose) PutPose(sensor.sensor_from_rig, &bytes);
    }
  }
  out << bytes.bytes();
}

void WriteRigsText(const SparseModel& model, std::ostream& out) {
  out << "# RIG_ID, NUM_SENSORS, REF_SENSOR_TYPE, REF_SENSOR_ID, SENSORS[] as (SENSOR_TYPE, "
         "SENSOR_ID, HAS_POSE, [QW, QX, QY, QZ, TX, TY, TZ])\n";
  for (const Rig& rig : model.rigs) {
    out << rig.id << ' ' << rig.sensors.size();
    for (size_t i = 0; i < rig.sensors.size(); ++i) {
      const RigSensor& sensor = rig.sensors[i];
      PutSensor(sensor.sensor, out);
      if (i == 0) continue;
      out << ' ' << sensor.has_pose;
      if (sensor.has_pose) PutPose(sensor.sensor_from_rig, out);
    }
    out << '\n';
  }
}

void WriteFramesBinary(const SparseModel& model, std::ostream& out) {
  ByteWriter bytes;
  bytes.PutCount(model.frames.size());
  for (const Frame& frame : model.frames) {
    bytes.Put(frame.id);
    bytes.Put(frame.rig_id);
    PutPose(frame.rig_from_world, &bytes);
    bytes.Put(static_cast<uint32_t>(frame.data.size()));
    for (const FrameData& data : frame.data) {
      PutSensor(data.sensor, &bytes);
      bytes.Put(data.id);
    }
  }
  out << bytes.bytes();
}

void WriteFramesText(const SparseModel& model, std::ostream& out) {
  out << "# FRAME_ID, RIG_ID, RIG_FROM_WORLD[QW, QX, QY, QZ, TX, TY, TZ], NUM_DATA_IDS, DATA_IDS[] "
         "as (SENSOR_TYPE, SENSOR_ID, DATA_ID)\n";
  for (const Frame& frame : model.frames) {
    out << frame.id << ' ' << frame.rig_id;
    PutPose(frame.rig_from_world, out);
    out << ' ' << frame.data.size();
    for (const FrameData& data : frame.data) {
      PutSensor(data.sensor, out);
      out << ' ' << data.id;
    }
    out << '\n';
  }
}

}  // namespace limn::colmap_ext
