// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/write_drawing.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "limn/files/atomic_file.h"
#include "limn/formats/graphml_drawing_writer.h"
#include "limn/formats/json_drawing_writer.h"
#include "limn/formats/ply_drawing_writer.h"
#include "limn/formats/ply_faces_writer.h"
#include "limn/formats/ply_sketch_writer.h"
#include "limn/formats/tracks_writer.h"
#include "limn/formats/wireframe_files.h"
#include "limn/model/curve_set.h"
#include "limn/util/errors.h"
#include "limn/util/lower_case.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

struct Job {
  const std::string& path;
  const DrawingGraph& graph;
  const DrawingMetadata& metadata;
  const DrawingFormatOptions& options;
  std::vector<std::string>* left_out;  // what the format cannot hold
};

struct Format {
  const char* name;
  std::vector<std::string> extensions;
  void (*write)(const Job& job, std::ostream& out);
};

void WriteSvg(const Job& job, std::ostream& out) {
  const SvgPicture& picture = job.options.svg;
  if (picture.view) {
    WriteDrawingSvg(job.graph, *picture.view, picture.is_hidden, picture.style, out);
  } else {
    WriteDrawingSvg(job.graph, MakeSheet(job.graph, picture.sheet), picture.is_hidden,
                    picture.style, out);
  }
}

// `what` begins with what the ids are those of.
std::string NoteOn(const std::vector<int>& ids, size_t count, const std::string& what) {
  constexpr size_t kMaxNamed = 10;
  std::string text = std::to_string(ids.size()) + " of " + std::to_string(count) + ' ' + what + ":";
  for (size_t i = 0; i < std::min(ids.size(), kMaxNamed); ++i) {
    text += ' ' + std::to_string(ids[i]);
  }
  return ids.size() > kMaxNamed ? text + " ..." : text;
}

void WriteStep(const Job& job, std::ostream& out) {
  const size_t num_faces = job.graph.faces.size();
  const StepNotes notes =
      job.options.write_step(job.graph, job.options.step, job.options.unit, out);
  if (!notes.apart.empty()) {
    job.left_out->push_back(
        NoteOn(notes.apart, num_faces,
               "faces share no edges in the file, since their borders do not fit "
               "those of their neighbors"));
  }
  if (!notes.left_out.empty()) {
    job.left_out->push_back(
        NoteOn(notes.left_out, num_faces,
               "faces are not in the file, since they have no valid shape there"));
  }
  if (!notes.rods_left_out.empty()) {
    const auto num_rods = std::ranges::count(job.graph.links, LinkKind::kRod, &DrawingLink::kind);
    job.left_out->push_back(NoteOn(notes.rods_left_out, num_rods,
                                   "rods are curves in the file, since no tube along them is a "
                                   "valid solid"));
  }
}

std::string ExtensionOf(const std::string& path) {
  return LowerCase(std::filesystem::path(path).extension().string());
}

constexpr const char* kWireframeFormat = "wireframe";

void WriteWireframe(const Job& job, std::ostream& out) {
  const std::vector<Polyline3d> lines = ToCurveSet(job.graph).polylines;
  WireframeOptions options = job.options.wireframe;
  if (options.tolerance == 0) options.tolerance = DefaultWireframeTolerance(lines);
  const Wireframe wireframe = ReduceToWireframe(lines, options);
  if (wireframe.edges.empty() && !lines.empty()) {
    job.left_out->push_back("the wireframe has no edges: all curves are within its tolerance of " +
                            ShortNumber(options.tolerance));
  }
  const WireframeStamp stamp = {job.options.unit, options.tolerance};
  if (ExtensionOf(job.path) == ".json") {
    WriteWireframeJson(wireframe, stamp, out);
  } else {
    WriteWireframeObj(wireframe, job.options.obj, stamp, out);
  }
}

// One line per format.
const std::vector<Format>& Formats() {
  using Out = std::ostream;
  static const std::vector<Format> formats = {
      {"ply",
       {".ply"},
       [](const Job& job, Out& out) { WriteDrawingPly(job.graph, job.options.unit, out); }},
      // Only by its name: a .ply file is the curves.
      {"faces",
       {},
       [](const Job& job, Out& out) { WriteFacesPly(job.graph, job.options.unit, out); }},
      // Only by its name: these files are drawings.
      {kWireframeFormat, {}, WriteWireframe},
      {"obj",
       {".obj"},
       [](const Job& job, Out& out) {
         WriteDrawingObj(job.graph, job.options.obj, job.options.unit, out);
       }},
      {"json",
       {".json"},
       [](const Job& job, Out& out) { WriteDrawingJson(job.graph, job.metadata, out); }},
      {"dxf",
       {".dxf"},
       [](const Job& job, Out& out) {
         WriteDrawingDxf(job.graph, job.options.dxf, job.options.unit, out);
       }},
      {"glb",
       {".glb"},
       [](const Job& job, Out& out) {
         WriteDrawingGlb(job.graph, job.options.glb, job.options.unit, out);
       }},
      {"svg", {".svg"}, [](const Job& job, Out& out) { WriteSvg(job, out); }},
      {"graphml",
       {".graphml"},
       [](const Job& job, Out& out) { WriteDrawingGraphml(job.graph, job.options.unit, out); }},
      {"step", {".step", ".stp"}, [](const Job& job, Out& out) { WriteStep(job, out); }},
  };
  return formats;
}

std::string JoinedExtensions() {
  std::string text;
  for (const Format& format : Formats()) {
    for (const std::string& extension : format.extensions) {
      text += (text.empty() ? "" : ", ") + extension;
    }
  }
  return text;
}

const Format& FormatByName(const std::string& path, const std::string& name) {
  if (name == kWireframeFormat && ExtensionOf(path) != ".obj" && ExtensionOf(path) != ".json") {
    throw IoError(path, "wireframes are written as .obj or .json");
  }
  for (const Format& format : Formats()) {
    if (format.name == name) return format;
  }
  throw IoError(path, "unknown format " + name);
}

const Format& FormatByExtension(const std::string& path) {
  const std::string extension = ExtensionOf(path);
  for (const Format& format : Formats()) {
    const auto& extensions = format.extensions;
    if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
      return format;
    }
  }
  throw IoError(path, "unknown extension; drawings are written as " + JoinedExtensions());
}

const Format& FormatOf(const std::string& path, const DrawingFormatOptions& options) {
  return options.format == kAutoFormat ? FormatByExtension(path)
                                       : FormatByName(path, options.format);
}

}  // namespace

std::string DrawingFormatOf(const std::string& path, const DrawingFormatOptions& options) {
  return FormatOf(path, options).name;
}

std::vector<std::string> DrawingFormats() {
  std::vector<std::string> names;
  for (const Format& format : Formats()) names.push_back(format.name);
  return names;
}

std::vector<std::string> WriteDrawing(const OutputPath& path, const DrawingGraph& graph,
                                      const DrawingMetadata& metadata,
                                      const DrawingFormatOptions& options) {
  const std::vector<std::string> violations = Validate(graph);
  if (!violations.empty()) throw InputError("no valid drawing: " + violations.front());
  const std::string wrong = metadata.alignment ? Validate(*metadata.alignment) : "";
  if (!wrong.empty()) throw InputError("no valid alignment: " + wrong);
  const Format& format = FormatOf(path.string(), options);
  if (std::string_view(format.name) == "step" && !options.write_step) {
    throw IoError(path.string(), "STEP files need the writer of limn::step (write_step)");
  }
  std::vector<std::string> left_out;
  WriteFileAtomically(path, [&](std::ostream& out) {
    format.write({path.string(), graph, metadata, options, &left_out}, out);
  });
  return left_out;
}

void WriteSketch(const OutputPath& path, const CurveSketch& sketch) {
  WriteFileAtomically(path, [&](std::ostream& out) { WriteSketchPly(sketch, out); });
}

void WriteTracks(const OutputPath& path, const DrawingGraph& graph, const LinkSelection& selection,
                 const std::vector<View>& views) {
  WriteFileAtomically(path, [&](std::ostream& out) { WriteTracks(graph, selection, views, out); });
}

}  // namespace limn
