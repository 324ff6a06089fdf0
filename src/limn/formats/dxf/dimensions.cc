// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/dimensions.h"

#include <cmath>

#include "limn/formats/dxf/entities.h"
#include "limn/formats/dxf/layers.h"
#include "limn/formats/dxf/object_axes.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Of the height of the text: how far lines go beyond the dimension line, half a tick, and the
// distance of the text's middle from the line.
constexpr double kOvershoot = 0.5;
constexpr double kTick = 0.5;
constexpr double kTextDistance = 1;

// Directions in the plane of a dimension.
struct TextFrame {
  Eigen::Vector3d normal;  // towards who reads it
  Eigen::Vector3d along;   // of the text
  Eigen::Vector3d up;
};

// Seen from above, or from the front if the plane is upright; the text runs to the right, or up.
TextFrame FrameOf(const DimensionLines& lines) {
  constexpr double kLevel = 1e-6;
  const auto is_back = [](double first, double second) {
    return first < -kLevel || (first <= kLevel && second < 0);
  };
  TextFrame frame = {lines.along.cross(lines.aside), lines.along, lines.aside};
  if (is_back(frame.normal.z(), -frame.normal.y())) frame.normal = -frame.normal;
  const Eigen::Vector3d in_object = ObjectFromWorld(frame.normal) * frame.along;
  if (is_back(in_object.x(), in_object.y())) frame.along = -frame.along;
  frame.up = frame.normal.cross(frame.along);
  return frame;
}

Eigen::Vector3d TextMiddle(const DimensionLines& lines, const TextFrame& frame, double height) {
  return 0.5 * (lines.from + lines.to) + kTextDistance * height * frame.up;
}

class PictureWriter {
 public:
  PictureWriter(int owner, int* next_handle, DxfWriter* writer)
      : owner_(owner), next_handle_(next_handle), writer_(*writer) {}

  void PutLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    Begin("LINE", "AcDbLine");
    writer_.PutPoint(10, from);
    writer_.PutPoint(11, to);
  }

  void PutText(const DxfDimension& dimension, double height) {
    const TextFrame frame = FrameOf(dimension.lines);
    const Eigen::Matrix3d object_from_world = ObjectFromWorld(frame.normal);
    const Eigen::Vector3d middle = object_from_world * TextMiddle(dimension.lines, frame, height);
    const Eigen::Vector3d along = object_from_world * frame.along;
    Begin("TEXT", "AcDbText");
    writer_.PutPoint(10, middle);
    writer_.Put(40, height);
    writer_.Put(1, dimension.text);
    writer_.Put(50, Degrees(std::atan2(along.y(), along.x())));
    writer_.Put(72, 1);  // centered at:
    writer_.PutPoint(11, middle);
    writer_.PutPoint(210, frame.normal);
    writer_.Put(100, "AcDbText");
    writer_.Put(73, 2);  // its middle
  }

 private:
  void Begin(const char* type, const char* subclass) {
    writer_.Put(0, type);
    writer_.PutHandle(5, (*next_handle_)++);
    writer_.PutHandle(330, owner_);
    writer_.Put(100, "AcDbEntity");
    writer_.Put(8, kDxfDimensionLayer);
    writer_.Put(100, subclass);
  }

  int owner_;
  int* next_handle_;
  DxfWriter& writer_;
};

// Of a dimension that the view shortens: what programs measure times this is its length.
void PutLengthFactor(const DxfDimension& dimension, DxfWriter* writer) {
  constexpr int kLengthFactor = 144;  // DIMLFAC
  constexpr double kSame = 1e-9;
  const double drawn = (dimension.lines.measured_to - dimension.lines.measured_from).norm();
  const double factor = dimension.length / drawn;
  if (std::abs(factor - 1) < kSame) return;
  writer->Put(1001, "ACAD");
  writer->Put(1000, "DSTYLE");
  writer->Put(1002, "{");
  writer->Put(1070, kLengthFactor);
  writer->Put(1040, factor);
  writer->Put(1002, "}");
}

}  // namespace

std::string DimensionBlockName(size_t index) { return "*D" + std::to_string(index); }

void PutDimensionPicture(const DxfDimension& dimension, double text_height, int owner,
                         int* next_handle, DxfWriter* writer) {
  const DimensionLines& lines = dimension.lines;
  PictureWriter picture(owner, next_handle, writer);
  picture.PutLine(lines.from, lines.to);
  const Eigen::Vector3d beyond = kOvershoot * text_height * lines.aside;
  if (lines.from != lines.measured_from) {
    picture.PutLine(lines.measured_from, lines.from + beyond);
    picture.PutLine(lines.measured_to, lines.to + beyond);
  }
  const TextFrame frame = FrameOf(lines);
  const Eigen::Vector3d tick = kTick * text_height * (frame.along + frame.up);
  for (const Eigen::Vector3d& end : {lines.from, lines.to}) picture.PutLine(end - tick, end + tick);
  picture.PutText(dimension, text_height);
}

void PutDimension(const DxfDimension& dimension, size_t index, double text_height, int owner,
                  int* next_handle, DxfWriter* writer) {
  const DimensionLines& lines = dimension.lines;
  const TextFrame frame = FrameOf(lines);
  writer->Put(0, "DIMENSION");
  writer->PutHandle(5, (*next_handle)++);
  writer->PutHandle(330, owner);
  writer->Put(100, "AcDbEntity");
  writer->Put(8, kDxfDimensionLayer);
  writer->Put(100, "AcDbDimension");
  writer->Put(2, DimensionBlockName(index));
  writer->PutPoint(10, lines.to);
  writer->PutPoint(11, ObjectFromWorld(frame.normal) * TextMiddle(lines, frame, text_height));
  writer->Put(70, 1 + 32);  // aligned; no other dimension has its block
  writer->Put(71, 5);       // the text's place is its middle
  writer->Put(42, dimension.length);
  writer->Put(1, dimension.text);
  writer->Put(3, "Standard");
  writer->PutPoint(210, frame.normal);
  writer->Put(100, "AcDbAlignedDimension");
  writer->PutPoint(13, lines.measured_from);
  writer->PutPoint(14, lines.measured_to);
  PutLengthFactor(dimension, writer);
  writer->Put(1001, kDxfApplication);
  writer->Put(1071, dimension.id);
}

}  // namespace limn
