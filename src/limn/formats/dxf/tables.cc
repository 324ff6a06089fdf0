// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/tables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "limn/formats/dxf/entities.h"

namespace limn {
namespace {

constexpr const char* kModelSpace = "*Model_Space";
constexpr const char* kPaperSpace = "*Paper_Space";

constexpr const char* kDictionaryWithDefault = "ACDBDICTIONARYWDFLT";
constexpr const char* kPlaceholder = "ACDBPLACEHOLDER";

class TableWriter {
 public:
  TableWriter(int* next_handle, DxfWriter* writer) : next_handle_(next_handle), writer_(*writer) {}

  void Begin(const char* name, size_t num_entries) {
    table_ = (*next_handle_)++;
    writer_.Put(0, "TABLE");
    writer_.Put(2, name);
    writer_.PutHandle(5, table_);
    writer_.PutHandle(330, 0);
    writer_.Put(100, "AcDbSymbolTable");
    writer_.Put(70, static_cast<int>(num_entries));
  }

  void End() { writer_.Put(0, "ENDTAB"); }

  // Returns the handle. `handle_code` is 5 except for dimension styles.
  int Entry(const char* type, const char* subclass, const std::string& name, int handle_code = 5) {
    const int handle = (*next_handle_)++;
    writer_.Put(0, type);
    writer_.PutHandle(handle_code, handle);
    writer_.PutHandle(330, table_);
    writer_.Put(100, "AcDbSymbolTableRecord");
    writer_.Put(100, subclass);
    writer_.Put(2, name);
    return handle;
  }

  void Flags(int flags) { writer_.Put(70, flags); }

  void Viewport(const Eigen::AlignedBox3d& extent);
  void LineTypes();
  void Layers(const std::vector<DxfLayer>& layers, int plot_style);
  void TextStyles();
  void Applications();
  void DimensionStyles(const DxfDimensions& dimensions);
  void BlockRecords(size_t num_dimensions, DxfSpaces* spaces);

 private:
  int* next_handle_;
  DxfWriter& writer_;
  int table_ = 0;
};

void TableWriter::Viewport(const Eigen::AlignedBox3d& extent) {
  const bool empty = extent.isEmpty();
  const Eigen::Vector3d center = empty ? Eigen::Vector3d(0, 0, 0) : extent.center().eval();
  const Eigen::Vector3d size = empty ? Eigen::Vector3d(1, 1, 1) : extent.sizes().eval();
  const double largest = std::max({size.x(), size.y(), 1e-6 * size.z()});
  const double height = largest > 0 ? 1.1 * largest : 1;  // of a point
  Begin("VPORT", 1);
  Entry("VPORT", "AcDbViewportTableRecord", "*Active");
  Flags(0);
  const auto pair = [&](int code, double x, double y) {
    writer_.Put(code, x);
    writer_.Put(code + 10, y);
  };
  pair(10, 0, 0);                    // lower left of the window
  pair(11, 1, 1);                    // upper right
  pair(12, center.x(), center.y());  // middle of the view
  pair(13, 0, 0);                    // snap and grid
  pair(14, 1, 1);
  pair(15, 1, 1);
  writer_.PutPoint(16, {0, 0, 1});           // looked at from
  writer_.PutPoint(17, {0, 0, center.z()});  // looked at
  writer_.Put(40, height);
  writer_.Put(41, 1.0);  // width over height
  writer_.Put(42, 50.0);
  for (const int code : {43, 44, 50, 51}) writer_.Put(code, 0.0);
  writer_.Put(71, 0);
  writer_.Put(72, 1000);
  writer_.Put(73, 1);
  writer_.Put(74, 3);
  for (const int code : {75, 76, 77, 78}) writer_.Put(code, 0);
  End();
}

void TableWriter::LineTypes() {
  // Lengths of dashes, of gaps negative, millimeters of paper; 0: a dot.
  struct LineType {
    const char* name;
    std::vector<double> pattern;
  };
  const std::vector<LineType> types = {
      {"ByBlock", {}},
      {"ByLayer", {}},
      {DxfLineTypeName(DxfLineType::kContinuous), {}},
      {DxfLineTypeName(DxfLineType::kHidden), {3, -1.5}},
      {DxfLineTypeName(DxfLineType::kCenter), {12, -2, 2, -2}},
      {DxfLineTypeName(DxfLineType::kDotted), {0, -1.5}},
  };
  Begin("LTYPE", types.size());
  for (const auto& [name, pattern] : types) {
    Entry("LTYPE", "AcDbLinetypeTableRecord", name);
    Flags(0);
    writer_.Put(3, "");
    writer_.Put(72, 65);
    writer_.Put(73, static_cast<int>(pattern.size()));
    double length = 0;
    for (const double part : pattern) length += std::abs(part);
    writer_.Put(40, length);
    for (const double part : pattern) {
      writer_.Put(49, part);
      writer_.Put(74, 0);
    }
  }
  End();
}

void TableWriter::Layers(const std::vector<DxfLayer>& layers, int plot_style) {
  Begin("LAYER", layers.size() + 1);
  const auto put = [&](const DxfLayer& layer) {
    Entry("LAYER", "AcDbLayerTableRecord", layer.name);
    Flags(0);
    writer_.Put(62, layer.color);
    writer_.Put(6, DxfLineTypeName(layer.line_type));
    writer_.Put(370, layer.line_weight);
    writer_.PutHandle(390, plot_style);
  };
  put({"0"});
  for (const DxfLayer& layer : layers) put(layer);
  End();
}

void TableWriter::TextStyles() {
  Begin("STYLE", 1);
  Entry("STYLE", "AcDbTextStyleTableRecord", "Standard");
  Flags(0);
  writer_.Put(40, 0.0);
  writer_.Put(41, 1.0);
  writer_.Put(50, 0.0);
  writer_.Put(71, 0);
  writer_.Put(42, 2.5);
  writer_.Put(3, "txt");
  writer_.Put(4, "");
  End();
}

void TableWriter::Applications() {
  Begin("APPID", 2);
  for (const char* name : {"ACAD", kDxfApplication}) {
    Entry("APPID", "AcDbRegAppTableRecord", name);
    Flags(0);
  }
  End();
}

void TableWriter::DimensionStyles(const DxfDimensions& dimensions) {
  Begin("DIMSTYLE", 1);
  writer_.Put(100, "AcDbDimStyleTable");
  writer_.Put(71, 0);
  Entry("DIMSTYLE", "AcDbDimStyleTableRecord", "Standard", 105);
  Flags(0);
  if (!dimensions.all.empty()) {
    // As PutDimensionPicture draws them, for programs that draw them anew.
    const double height = dimensions.text_height;
    writer_.Put(40, 1.0);
    writer_.Put(41, height);         // arrows
    writer_.Put(42, 0.0);            // from the places that are measured
    writer_.Put(44, 0.5 * height);   // beyond the dimension line
    writer_.Put(140, height);        // text
    writer_.Put(142, 0.5 * height);  // oblique ticks
    writer_.Put(147, 0.5 * height);  // between line and text
    writer_.Put(73, 0);              // text is along the line,
    writer_.Put(74, 0);
    writer_.Put(77, 1);  // above it
  }
  End();
}

void TableWriter::BlockRecords(size_t num_dimensions, DxfSpaces* spaces) {
  DxfLayoutRecords& records = spaces->records;
  records.model_layout = (*next_handle_)++;
  records.paper_layout = (*next_handle_)++;
  Begin("BLOCK_RECORD", 2 + num_dimensions);
  records.model = Entry("BLOCK_RECORD", "AcDbBlockTableRecord", kModelSpace);
  writer_.PutHandle(340, records.model_layout);
  records.paper = Entry("BLOCK_RECORD", "AcDbBlockTableRecord", kPaperSpace);
  writer_.PutHandle(340, records.paper_layout);
  for (size_t i = 0; i < num_dimensions; ++i) {
    spaces->dimensions.push_back(
        Entry("BLOCK_RECORD", "AcDbBlockTableRecord", DimensionBlockName(i)));
  }
  End();
}

struct Block {
  std::string name;
  int record = 0;
  bool is_paper = false;
  int flags = 0;
  std::function<void()> put_content = [] {};
};

void PutBlock(const Block& block, int* next_handle, DxfWriter* writer) {
  const auto begin = [&](const char* type, const char* subclass) {
    writer->Put(0, type);
    writer->PutHandle(5, (*next_handle)++);
    writer->PutHandle(330, block.record);
    writer->Put(100, "AcDbEntity");
    if (block.is_paper) writer->Put(67, 1);
    writer->Put(8, "0");
    writer->Put(100, subclass);
  };
  begin("BLOCK", "AcDbBlockBegin");
  writer->Put(2, block.name);
  writer->Put(70, block.flags);
  writer->PutPoint(10, Eigen::Vector3d::Zero());
  writer->Put(3, block.name);
  writer->Put(1, "");
  block.put_content();
  begin("ENDBLK", "AcDbBlockEnd");
}

}  // namespace

void PutDxfClasses(DxfWriter* writer) {
  struct Class {
    const char* record;
    const char* name;
  };
  writer->BeginSection("CLASSES");
  for (const auto& [record, name] : {Class{kDictionaryWithDefault, "AcDbDictionaryWithDefault"},
                                     {kPlaceholder, "AcDbPlaceHolder"},
                                     {"LAYOUT", "AcDbLayout"}}) {
    writer->Put(0, "CLASS");
    writer->Put(1, record);
    writer->Put(2, name);
    writer->Put(3, "ObjectDBX Classes");
    for (const int code : {90, 280, 281}) writer->Put(code, 0);
  }
  writer->EndSection();
}

DxfSpaces PutDxfTables(const std::vector<DxfLayer>& layers, const Eigen::AlignedBox3d& extent,
                       const DxfDimensions& dimensions, int* next_handle, DxfWriter* writer) {
  DxfSpaces spaces;
  spaces.plot_style = (*next_handle)++;
  writer->BeginSection("TABLES");
  TableWriter tables(next_handle, writer);
  tables.Viewport(extent);
  tables.LineTypes();
  tables.Layers(layers, spaces.plot_style);
  tables.TextStyles();
  for (const char* name : {"VIEW", "UCS"}) {
    tables.Begin(name, 0);
    tables.End();
  }
  tables.Applications();
  tables.DimensionStyles(dimensions);
  tables.BlockRecords(dimensions.all.size(), &spaces);
  writer->EndSection();
  return spaces;
}

void PutDxfBlocks(const DxfSpaces& spaces, const DxfDimensions& dimensions, int* next_handle,
                  DxfWriter* writer) {
  constexpr int kAnonymous = 1;
  writer->BeginSection("BLOCKS");
  PutBlock({kModelSpace, spaces.records.model}, next_handle, writer);
  PutBlock({kPaperSpace, spaces.records.paper, /*is_paper=*/true}, next_handle, writer);
  for (size_t i = 0; i < dimensions.all.size(); ++i) {
    const int record = spaces.dimensions[i];
    PutBlock({DimensionBlockName(i), record, false, kAnonymous,
              [&] {
                PutDimensionPicture(dimensions.all[i], dimensions.text_height, record, next_handle,
                                    writer);
              }},
             next_handle, writer);
  }
  writer->EndSection();
}

void PutDxfObjects(const DxfSpaces& spaces, const std::optional<DxfLayout>& layout,
                   const Eigen::AlignedBox3d& extent, int* next_handle, DxfWriter* writer) {
  const int root = (*next_handle)++;
  const int groups = (*next_handle)++;
  const int layouts = (*next_handle)++;
  const int plot_styles = (*next_handle)++;
  const auto begin = [&](int handle, int owner, const char* type = "DICTIONARY") {
    writer->Put(0, type);
    writer->PutHandle(5, handle);
    writer->PutHandle(330, owner);
    writer->Put(100, "AcDbDictionary");
    writer->Put(281, 1);
  };
  writer->BeginSection("OBJECTS");
  begin(root, 0);
  writer->Put(3, "ACAD_GROUP");
  writer->PutHandle(350, groups);
  writer->Put(3, "ACAD_LAYOUT");
  writer->PutHandle(350, layouts);
  writer->Put(3, "ACAD_PLOTSTYLENAME");
  writer->PutHandle(350, plot_styles);
  begin(groups, root);
  PutDxfLayouts(layout, extent, spaces.records, root, layouts, writer);
  begin(plot_styles, root, kDictionaryWithDefault);
  writer->Put(3, "Normal");
  writer->PutHandle(350, spaces.plot_style);
  writer->Put(100, "AcDbDictionaryWithDefault");
  writer->PutHandle(340, spaces.plot_style);
  writer->Put(0, kPlaceholder);
  writer->PutHandle(5, spaces.plot_style);
  writer->PutHandle(330, plot_styles);
  writer->EndSection();
}

}  // namespace limn
