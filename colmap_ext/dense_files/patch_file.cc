// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/patch_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/workspace/pmvs_model.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

constexpr int kMaxImages = 1 << 20;

class PatchReader {
 public:
  explicit PatchReader(const std::string& path) : in_(OpenFile(path)), lines_(in_, path) {}

  void Run(const std::function<void(const Patch&)>& visit) {
    if (Record("PATCHES") != "PATCHES") lines_.Here().Fail("not a .patch file");
    Record("number of patches");
    Fields header(lines_);
    const auto count = header.Number<uint64_t>("number of patches");
    for (uint64_t k = 0; k < count; ++k) visit(ReadPatch());
  }

 private:
  std::string Record(const char* what) {
    if (!lines_.NextRecord()) {
      lines_.Here().Fail(std::string("the file ends before ") + what);
    }
    Fields fields(lines_);
    return std::string(fields.Rest());
  }

  double Finite(Fields* fields, const char* what) {
    const auto value = fields->Number<double>(what);
    if (!std::isfinite(value)) lines_.Here().Fail(std::string(what) + " is not finite");
    return value;
  }

  Eigen::Vector3d Vector(const char* what) {
    Record(what);
    Fields fields(lines_);
    Eigen::Vector3d vector;
    for (double& value : vector) value = Finite(&fields, what);
    return vector;
  }

  std::vector<int> Images(const char* what) {
    Record(what);
    Fields header(lines_);
    const int count = header.Number<int>(what);
    if (count < 0 || count > kMaxImages) lines_.Here().Fail(std::string("bad ") + what);
    std::vector<int> images;
    if (!lines_.NextLine() && count > 0) lines_.Here().Fail("the file ends before the images");
    Fields fields(lines_);
    for (int k = 0; k < count; ++k) {
      images.push_back(fields.Number<int>("image number"));
      if (images.back() < 0) lines_.Here().Fail("negative image number");
    }
    return images;
  }

  Patch ReadPatch() {
    const std::string kind = Record("a patch");
    if (kind != "PATCHS" && kind != "PATCHA") lines_.Here().Fail("PATCHS expected");
    Patch patch;
    patch.position = Vector("position");
    patch.normal = Vector("normal");
    Record("scores");
    Fields scores(lines_);
    patch.photometric_score = Finite(&scores, "score");
    for (double& scale : patch.scales) scale = Finite(&scores, "scale");
    if (kind == "PATCHA") {
      Record("type");
      Record("direction");
    }
    patch.images = Images("number of images");
    patch.more_images = Images("number of further images");
    return patch;
  }

  std::ifstream in_;
  LineReader lines_;
};

void PutVector(const Eigen::Vector3d& vector, double last, std::ostream& out) {
  for (const double value : vector) out << NumberText(value) << ' ';
  out << NumberText(last) << '\n';
}

void PutImages(const std::vector<int>& images, std::ostream& out) {
  out << images.size() << '\n';
  for (const int image : images) out << image << ' ';
  out << '\n';
}

}  // namespace

void ReadPatchFile(const std::string& path, const std::function<void(const Patch&)>& visit) {
  PatchReader(path).Run(visit);
}

void WritePatchHeader(uint64_t num_patches, std::ostream& out) {
  out << "PATCHES\n" << num_patches << '\n';
}

void WritePatch(const Patch& patch, std::ostream& out) {
  out << "PATCHS\n";
  PutVector(patch.position, 1, out);
  PutVector(patch.normal, 0, out);
  out << patch.photometric_score << ' ' << patch.scales[0] << ' ' << patch.scales[1] << '\n';
  PutImages(patch.images, out);
  PutImages(patch.more_images, out);
  out << '\n';
}

std::vector<int> PmvsNumbers(const std::filesystem::path& file_in_models,
                             const std::vector<View>& views) {
  const std::vector<std::string> names =
      ReadPmvsImageNames(file_in_models.parent_path().parent_path());
  std::vector<int> numbers;
  for (const View& view : views) {
    const auto named = std::find(names.begin(), names.end(), view.name);
    if (names.empty()) {
      numbers.push_back(view.model_index);
    } else {
      numbers.push_back(named == names.end() ? -1 : static_cast<int>(named - names.begin()));
    }
  }
  return numbers;
}

}  // namespace limn::colmap_ext
