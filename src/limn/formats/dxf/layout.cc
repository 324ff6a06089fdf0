// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/layout.h"

#include <algorithm>

namespace limn {
namespace {

// Millimeters: A3 across, the border around all, the strip below the window, and what is free
// around the plan in it.
constexpr double kPaperWidth = 420, kPaperHeight = 297;
constexpr double kBorder = 10;
constexpr double kStrip = 15;
constexpr double kMargin = 5;
constexpr double kTitleHeight = 5, kTextHeight = 3.5;

struct Paper {
  Eigen::Vector2d size = {kPaperWidth, kPaperHeight};
  Eigen::Vector2d window_min, window_max;

  Eigen::Vector2d WindowCenter() const { return 0.5 * (window_min + window_max); }
  Eigen::Vector2d WindowSize() const { return window_max - window_min; }
};

Paper PaperFor(const DxfLayout& layout, const Eigen::AlignedBox3d& extent) {
  const Eigen::Vector2d plan = extent.isEmpty()
                                   ? Eigen::Vector2d(0, 0)
                                   : Eigen::Vector2d(extent.sizes().head<2>() / layout.mm);
  Paper paper;
  const Eigen::Vector2d around(2 * (kBorder + kMargin), 2 * (kBorder + kMargin) + kStrip);
  paper.size = paper.size.cwiseMax((plan + around).array().ceil().matrix());
  paper.window_min = {kBorder, kBorder + kStrip};
  paper.window_max = paper.size - Eigen::Vector2d(kBorder, kBorder);
  return paper;
}

class PaperWriter {
 public:
  PaperWriter(int paper_space, int* next_handle, DxfWriter* writer)
      : paper_space_(paper_space), next_handle_(next_handle), writer_(*writer) {}

  // A window that shows `height` drawing units around a place of the plan.
  void PutViewport(int id, const Eigen::Vector2d& center, const Eigen::Vector2d& size,
                   const Eigen::Vector2d& seen_center, double seen_height) {
    constexpr int kAlwaysOn = 32 + 64 + 32768, kLocked = 16384;
    Begin("VIEWPORT", "AcDbViewport");
    PutPlace(10, center);
    writer_.Put(40, size.x());
    writer_.Put(41, size.y());
    writer_.Put(68, id);
    writer_.Put(69, id);
    PutPair(12, seen_center);
    PutPair(13, {0, 0});
    PutPair(14, {10, 10});
    PutPair(15, {10, 10});
    writer_.PutPoint(16, Eigen::Vector3d::UnitZ());
    writer_.PutPoint(17, Eigen::Vector3d::Zero());
    writer_.Put(42, 50.0);
    writer_.Put(43, 0.0);
    writer_.Put(44, 0.0);
    writer_.Put(45, seen_height);
    writer_.Put(50, 0.0);
    writer_.Put(51, 0.0);
    writer_.Put(72, 1000);
    writer_.Put(90, id == 1 ? kAlwaysOn : kAlwaysOn + kLocked);
    writer_.Put(1, "");
    writer_.Put(281, 0);
    writer_.Put(71, 1);
    writer_.Put(74, 0);
    writer_.PutPoint(110, Eigen::Vector3d::Zero());
    writer_.PutPoint(111, Eigen::Vector3d::UnitX());
    writer_.PutPoint(112, Eigen::Vector3d::UnitY());
    writer_.Put(79, 0);
    writer_.Put(146, 0.0);
  }

  void PutLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    Begin("LINE", "AcDbLine");
    PutPlace(10, from);
    PutPlace(11, to);
  }

  void PutFrame(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    constexpr int kLineWeight = 50;  // hundredths of a millimeter
    Begin("LWPOLYLINE", "AcDbPolyline", kLineWeight);
    writer_.Put(90, 4);
    writer_.Put(70, 1);
    for (const Eigen::Vector2d& corner :
         {low, Eigen::Vector2d(high.x(), low.y()), high, Eigen::Vector2d(low.x(), high.y())}) {
      PutPair(10, corner);
    }
  }

  // Centered at its middle, or beginning there.
  void PutText(const std::string& text, const Eigen::Vector2d& at, double height, bool centered) {
    if (text.empty()) return;
    Begin("TEXT", "AcDbText");
    PutPlace(10, at);
    writer_.Put(40, height);
    writer_.Put(1, text);
    writer_.Put(72, centered ? 1 : 0);
    PutPlace(11, at);
    writer_.Put(100, "AcDbText");
    writer_.Put(73, 2);
  }

 private:
  void Begin(const char* type, const char* subclass, int line_weight = -1) {
    writer_.Put(0, type);
    writer_.PutHandle(5, (*next_handle_)++);
    writer_.PutHandle(330, paper_space_);
    writer_.Put(100, "AcDbEntity");
    writer_.Put(67, 1);
    writer_.Put(8, kDxfSheetLayer);
    if (line_weight > 0) writer_.Put(370, line_weight);
    writer_.Put(100, subclass);
  }

  void PutPlace(int code, const Eigen::Vector2d& place) {
    writer_.PutPoint(code, {place.x(), place.y(), 0});
  }

  void PutPair(int code, const Eigen::Vector2d& pair) {
    writer_.Put(code, pair.x());
    writer_.Put(code + 10, pair.y());
  }

  int paper_space_;
  int* next_handle_;
  DxfWriter& writer_;
};

// Upwards, with its name beside it.
void PutArrow(const std::string& name, const Eigen::Vector2d& foot, PaperWriter* paper) {
  if (name.empty()) return;
  constexpr double kLength = 10, kHead = 2;
  const Eigen::Vector2d tip = foot + Eigen::Vector2d(0, kLength);
  paper->PutLine(foot, tip);
  for (const double side : {-1.0, 1.0}) {
    paper->PutLine(tip, tip + Eigen::Vector2d(0.5 * side * kHead, -kHead));
  }
  paper->PutText(name, foot + Eigen::Vector2d(4, 0.5 * kLength), kTextHeight, true);
}

struct Tab {
  const char* name;
  int order = 0;
  int flags = 0;
  int record = 0;  // its block
  int handle = 0;
  Eigen::Vector2d size = {kPaperWidth, kPaperHeight};
};

void PutTab(const Tab& tab, int owner, DxfWriter* writer) {
  writer->Put(0, "LAYOUT");
  writer->PutHandle(5, tab.handle);
  writer->PutHandle(330, owner);
  writer->Put(100, "AcDbPlotSettings");
  writer->Put(1, "");
  writer->Put(2, "none_device");
  writer->Put(4, "");
  writer->Put(6, "");
  for (const int code : {40, 41, 42, 43}) writer->Put(code, 0.0);  // margins
  writer->Put(44, tab.size.x());
  writer->Put(45, tab.size.y());
  for (const int code : {46, 47, 48, 49, 140, 141}) writer->Put(code, 0.0);
  writer->Put(142, 1.0);  // millimeters of paper
  writer->Put(143, 1.0);  // per unit
  writer->Put(70, tab.flags);
  writer->Put(72, 1);  // millimeters
  writer->Put(73, 0);
  writer->Put(74, 5);  // all of the layout is plotted
  writer->Put(7, "");
  writer->Put(75, 16);  // 1:1
  writer->Put(147, 1.0);
  writer->Put(148, 0.0);
  writer->Put(149, 0.0);
  writer->Put(100, "AcDbLayout");
  writer->Put(1, tab.name);
  writer->Put(70, 1);
  writer->Put(71, tab.order);
  const Eigen::Vector3d corner(tab.size.x(), tab.size.y(), 0);
  const auto pair = [&](int code, const Eigen::Vector3d& place) {
    writer->Put(code, place.x());
    writer->Put(code + 10, place.y());
  };
  pair(10, Eigen::Vector3d::Zero());
  pair(11, corner);
  writer->PutPoint(12, Eigen::Vector3d::Zero());
  writer->PutPoint(14, Eigen::Vector3d::Zero());
  writer->PutPoint(15, corner);
  writer->Put(146, 0.0);
  writer->PutPoint(13, Eigen::Vector3d::Zero());
  writer->PutPoint(16, Eigen::Vector3d::UnitX());
  writer->PutPoint(17, Eigen::Vector3d::UnitY());
  writer->Put(76, 0);
  writer->PutHandle(330, tab.record);
}

}  // namespace

void PutPaperSpace(const DxfLayout& layout, const Eigen::AlignedBox3d& extent, int paper_space,
                   int* next_handle, DxfWriter* writer) {
  const Paper paper = PaperFor(layout, extent);
  PaperWriter put(paper_space, next_handle, writer);
  // The first is the paper itself.
  put.PutViewport(1, 0.5 * paper.size, paper.size, 0.5 * paper.size, paper.size.y());
  const Eigen::Vector2d center =
      extent.isEmpty() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(extent.center().head<2>());
  put.PutViewport(2, paper.WindowCenter(), paper.WindowSize(), center,
                  layout.mm * paper.WindowSize().y());
  const Eigen::Vector2d border(kBorder, kBorder);
  put.PutFrame(border, paper.size - border);
  put.PutLine(paper.window_min, {paper.window_max.x(), paper.window_min.y()});
  const double middle = kBorder + 0.5 * kStrip;
  // Letters are about as wide as high; long titles are lower.
  const double room = 0.75 * paper.size.x() - 5 * kBorder;
  const auto num_letters = std::max<double>(1, static_cast<double>(layout.title.size()));
  const double title_height = std::min(kTitleHeight, room / num_letters);
  put.PutText(layout.title, {kBorder + kMargin, middle}, title_height, false);
  put.PutText(layout.scale, {0.75 * paper.size.x(), middle}, kTitleHeight, true);
  PutArrow(layout.up_name, {paper.window_max.x() - 3 * kMargin, kBorder + 0.5 * kMargin}, &put);
}

void PutDxfLayouts(const std::optional<DxfLayout>& layout, const Eigen::AlignedBox3d& extent,
                   const DxfLayoutRecords& records, int owner, int handle, DxfWriter* writer) {
  constexpr int kModelFlags = 1024 + 688, kPaperFlags = 688;
  Tab model = {"Model", 0, kModelFlags, records.model, records.model_layout};
  Tab paper = {"Layout1", 1, kPaperFlags, records.paper, records.paper_layout};
  if (layout) paper.size = PaperFor(*layout, extent).size;
  writer->Put(0, "DICTIONARY");
  writer->PutHandle(5, handle);
  writer->PutHandle(330, owner);
  writer->Put(100, "AcDbDictionary");
  writer->Put(281, 1);
  for (const Tab& tab : {paper, model}) {
    writer->Put(3, tab.name);
    writer->PutHandle(350, tab.handle);
  }
  for (const Tab& tab : {paper, model}) PutTab(tab, handle, writer);
}

}  // namespace limn
