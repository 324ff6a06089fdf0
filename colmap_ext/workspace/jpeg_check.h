#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limn::colmap_ext {

// What the decoder finds wrong with a JPEG file whose header it can read.
struct JpegComplaint {
  std::string text;
  // The codes of pixels are wrong. Where that begins is unknown: codes depend on those before them,
  // and the decoder takes garbage for codes until it meets one that is impossible.
  bool is_damage = false;
};

// The first complaint, one of damage if there is any. Nothing for whole files, for files of other
// formats, and for padding at the end. Reads all codes of the file, but makes no pixels. Throws
// IoError if the header cannot be read.
std::optional<JpegComplaint> CheckJpeg(const std::filesystem::path& path);

}  // namespace limn::colmap_ext
