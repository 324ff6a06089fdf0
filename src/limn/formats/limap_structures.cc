// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/limap_structures.h"

#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "limn/files/atomic_file.h"
#include "limn/files/text_scanner.h"
#include "limn/files/whole_file.h"
#include "limn/util/byte_stream.h"
#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

// Three ways to pass over a record, value by value: in(value, what) takes it from a file or puts it
// there, in.List(items, min_bytes, pass) does so with each item of a list after their count.
// `min_bytes` is the least size of an item in a binary file.

class BinaryLimapReader {
 public:
  BinaryLimapReader(const std::string& path, std::string_view bytes) : reader_(path, bytes) {}

  template <typename T>
  void operator()(T& value, const char* what) {
    value = reader_.Get<T>(what);
    if constexpr (std::is_floating_point_v<T>) {
      if (!std::isfinite(value)) reader_.Fail(std::string(what) + " is not finite");
    }
  }
  template <typename Items, typename Pass>
  void List(Items& items, size_t min_bytes, const Pass& pass) {
    items.resize(reader_.GetCount(min_bytes));
    for (auto& item : items) pass(item);
  }
  void ExpectEnd() { reader_.ExpectEnd(); }
  [[noreturn]] void Fail(const std::string& reason) { reader_.Fail(reason); }

 private:
  ByteReader reader_;
};

class TextLimapReader {
 public:
  TextLimapReader(const std::string& path, std::string_view text) : scanner_(path, text) {}

  template <typename T>
  void operator()(T& value, const char* what) {
    if constexpr (std::is_floating_point_v<T>) {
      value = scanner_.FiniteNumber(what);
    } else {
      const std::string_view word = scanner_.Word(what);
      const auto number = ParseNumber<T>(word);
      if (!number) {
        scanner_.Fail(std::string(what) + " expected, not \"" + std::string(word.substr(0, 40)) +
                      "\"");
      }
      value = *number;
    }
  }
  // The count is not believed before the items are there.
  template <typename Items, typename Pass>
  void List(Items& items, size_t /*min_bytes*/, const Pass& pass) {
    uint64_t count = 0;
    (*this)(count, "a count");
    for (uint64_t i = 0; i < count; ++i) pass(items.emplace_back());
  }
  void ExpectEnd() {
    if (!scanner_.AtEnd()) scanner_.Fail("more than was announced");
  }
  [[noreturn]] void Fail(const std::string& reason) { scanner_.Fail(reason); }

 private:
  TextScanner scanner_;
};

class BinaryLimapWriter {
 public:
  template <typename T>
  void operator()(const T& value, const char* /*what*/) {
    writer_.Put(value);
  }
  template <typename Items, typename Pass>
  void List(const Items& items, size_t /*min_bytes*/, const Pass& pass) {
    writer_.PutCount(items.size());
    for (const auto& item : items) pass(item);
  }
  const std::string& bytes() const { return writer_.bytes(); }

 private:
  ByteWriter writer_;
};

template <typename Io, typename Vector>
void PassVector(Io& io, Vector& vector, const char* what) {
  for (auto& value : vector) io(value, what);
}

template <typename Io, typename Track>
void PassTrack(Io& io, Track& track) {
  io.List(track, 8, [&](auto& element) {
    io(element.image_id, "image id");
    io(element.index, "index in the image");
  });
}

template <typename Io, typename Members>
void PassMembers(Io& io, Members& members) {
  io.List(members, 12, [&](auto& member) {
    io(member.id, "member");
    io(member.weight, "weight");
  });
}

template <typename Io, typename Wireframe>
void PassWireframe(Io& io, Wireframe& wireframe) {
  io.List(wireframe, 16, [&](auto& incidence) {
    io(incidence.point, "point");
    io(incidence.line, "line");
    io(incidence.weight, "weight");
  });
}

template <typename Io, typename Lines>
void PassLines(Io& io, Lines& lines) {
  io.List(lines, 72, [&](auto& line) {
    io(line.id, "line id");
    PassVector(io, line.start, "start of a line");
    PassVector(io, line.end, "end of a line");
    PassTrack(io, line.track);
    io(line.uncertainty, "uncertainty");
  });
}

template <typename Io, typename Groups>
void PassGroups(Io& io, Groups& groups) {
  io.List(groups, 44, [&](auto& group) {
    io(group.id, "group id");
    io(group.type, "type of a group");
    PassMembers(io, group.points);
    PassMembers(io, group.lines);
    PassTrack(io, group.track);
    io.List(group.params, 8, [&](auto& value) { io(value, "parameter of a group"); });
  });
}

template <typename Io, typename Images>
void PassImages(Io& io, Images& images) {
  io.List(images, 32, [&](auto& image) {
    io(image.id, "image id");
    io(image.num_points, "number of points");
    io.List(image.segments, 48, [&](auto& segment) {
      PassVector(io, segment.start, "start of a segment");
      PassVector(io, segment.end, "end of a segment");
      io(segment.score, "score");
      io(segment.line, "line of a segment");
    });
    io.List(image.groups, 28, [&](auto& group) {
      io(group.type, "type of a group");
      PassMembers(io, group.points);
      PassMembers(io, group.segments);
      io(group.group, "group");
    });
    PassWireframe(io, image.wireframe);
  });
}

// What `pass` finds in the file.
template <typename Reader, typename Items, typename Pass>
Items ReadRecords(const fs::path& path, const Pass& pass) {
  const std::string bytes = ReadWholeFile(path.string());
  Reader reader(path.string(), bytes);
  Items items;
  pass(reader, items);
  reader.ExpectEnd();
  return items;
}

template <typename Items>
void CheckUniqueIds(const Items& items, const fs::path& path, const char* what) {
  std::unordered_set<uint64_t> ids;
  for (const auto& item : items) {
    if (!ids.insert(item.id).second) {
      throw IoError(path.string(), what + std::to_string(item.id) + " is there twice");
    }
  }
}

std::vector<LimapLine> ReadLines(const fs::path& path) {
  using Lines = std::vector<LimapLine>;
  const auto pass = [](auto& reader, Lines& lines) { PassLines(reader, lines); };
  Lines lines = FileExtension(path.string()) == ".txt"
                    ? ReadRecords<TextLimapReader, Lines>(path, pass)
                    : ReadRecords<BinaryLimapReader, Lines>(path, pass);
  CheckUniqueIds(lines, path, "line ");
  return lines;
}

LimapWireframe ReadWireframe(const fs::path& path, const std::vector<LimapLine>& lines) {
  const auto pass = [](auto& reader, LimapWireframe& found) { PassWireframe(reader, found); };
  LimapWireframe wireframe = FileExtension(path.string()) == ".txt"
                                 ? ReadRecords<TextLimapReader, LimapWireframe>(path, pass)
                                 : ReadRecords<BinaryLimapReader, LimapWireframe>(path, pass);
  std::unordered_set<uint64_t> ids;
  for (const LimapLine& line : lines) ids.insert(line.id);
  for (const auto& incidence : wireframe) {
    if (ids.contains(incidence.line)) continue;
    throw IoError(path.string(), "line " + std::to_string(incidence.line) + " does not exist");
  }
  return wireframe;
}

std::vector<LimapGroup> ReadGroups(const fs::path& path) {
  using Groups = std::vector<LimapGroup>;
  Groups groups = ReadRecords<BinaryLimapReader, Groups>(
      path, [](auto& reader, Groups& found) { PassGroups(reader, found); });
  CheckUniqueIds(groups, path, "group ");
  return groups;
}

std::vector<LimapImage> ReadImages(const fs::path& path) {
  using Images = std::vector<LimapImage>;
  Images images = ReadRecords<BinaryLimapReader, Images>(
      path, [](auto& reader, Images& found) { PassImages(reader, found); });
  CheckUniqueIds(images, path, "image ");
  return images;
}

void CheckTracks(const LimapStructures& structures, const fs::path& path) {
  std::unordered_map<uint32_t, size_t> num_segments;
  for (const LimapImage& image : structures.images) {
    num_segments.emplace(image.id, image.segments.size());
  }
  for (const LimapLine& line : structures.lines) {
    for (const LimapTrackElement& element : line.track) {
      const auto image = num_segments.find(element.image_id);
      if (image != num_segments.end() && element.index < image->second) continue;
      throw IoError(path.string(), "line " + std::to_string(line.id) + ": segment " +
                                       std::to_string(element.index) + " of image " +
                                       std::to_string(element.image_id) + " does not exist");
    }
  }
}

CurveSet CurvesOf(const std::vector<LimapLine>& lines) {
  CurveSet set;
  for (const LimapLine& line : lines) {
    if (line.start != line.end) set.polylines.push_back({line.start, line.end});
  }
  return set;
}

template <typename Items, typename Pass>
void WriteRecords(const Items& items, const OutputPath& path, const Pass& pass) {
  BinaryLimapWriter writer;
  pass(writer, items);
  WriteFileAtomically(path, writer.bytes());
}

}  // namespace

fs::path FindLimapLines(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name :
       {"structures/lines3D.bin", "structures/lines3D.txt", "lines3D.bin", "lines3D.txt"}) {
    if (fs::exists(folder / name, ignored)) return folder / name;
  }
  return {};
}

LimapStructures ReadLimapStructures(const fs::path& folder) {
  std::error_code ignored;
  LimapStructures structures;
  if (!fs::exists(folder / "lines3D.bin", ignored)) {
    structures.lines = ReadLines(folder / "lines3D.txt");
    structures.wireframe = ReadWireframe(folder / "wireframe3D.txt", structures.lines);
    return structures;
  }
  structures.images = ReadImages(folder / "structures2d.bin");
  structures.lines = ReadLines(folder / "lines3D.bin");
  structures.groups = ReadGroups(folder / "groups3D.bin");
  structures.wireframe = ReadWireframe(folder / "wireframe3D.bin", structures.lines);
  CheckTracks(structures, folder / "lines3D.bin");
  return structures;
}

CurveSet ReadLimapLines(const std::string& path) { return CurvesOf(ReadLines(path)); }

CurveSet ReadLimapTracks(const std::string& path) {
  const auto pass = [](auto& reader, std::vector<LimapLine>& lines) {
    reader.List(lines, 0, [&](LimapLine& line) {
      uint32_t num_segments = 0;
      uint32_t number = 0;
      reader(line.id, "track id");
      reader(num_segments, "number of segments");
      reader(number, "number of images");
      PassVector(reader, line.start, "start of a line");
      PassVector(reader, line.end, "end of a line");
      for (uint64_t i = 0; i < uint64_t{2} * num_segments; ++i) {
        reader(number, "image or segment of a track");
      }
    });
  };
  return CurvesOf(ReadRecords<TextLimapReader, std::vector<LimapLine>>(path, pass));
}

void WriteLimapStructures(const LimapStructures& structures, const OutputPath& folder) {
  WriteRecords(structures.images, folder / "structures2d.bin",
               [](auto& writer, const auto& images) { PassImages(writer, images); });
  WriteRecords(structures.lines, folder / "lines3D.bin",
               [](auto& writer, const auto& lines) { PassLines(writer, lines); });
  WriteRecords(structures.groups, folder / "groups3D.bin",
               [](auto& writer, const auto& groups) { PassGroups(writer, groups); });
  WriteRecords(structures.wireframe, folder / "wireframe3D.bin",
               [](auto& writer, const auto& wireframe) { PassWireframe(writer, wireframe); });
}

}  // namespace limn
