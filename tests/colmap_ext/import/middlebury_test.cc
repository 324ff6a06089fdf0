// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/middlebury.h"

#include "colmap_ext/import/import_test_base.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr char kMiddleburyFormat[] = "middlebury";
constexpr char kCalibration[] = " 600.25 0 316.25 0 611.5 250.625 0 0 1 ";

class Middlebury : public ImportTest {
 protected:
  std::string Lines() const {
    std::string text;
    for (const ModelImage& image : known_.images) {
      text += image.name + kCalibration + Text(image.cam_from_world.rotation.toRotationMatrix()) +
              Text(image.cam_from_world.translation) + "\n";
    }
    return text;
  }
  std::string ErrorWith(const std::string& text) {
    return Error(kMiddleburyFormat, dir_.WriteFile("known_par.txt", text));
  }

  const SparseModel known_ = KnownModel();
};

TEST_F(Middlebury, GivesTheSameProjections) {
  dir_.WriteFile("known_par.txt", "3\n" + Lines());
  const SparseModel model = Import(kMiddleburyFormat, dir_.path());
  ExpectSameProjections(model, known_);
  EXPECT_EQ(model.cameras.size(), 1u);
}

TEST_F(Middlebury, BadFilesAreRefused) {
  EXPECT_THAT(ErrorWith("4\n" + Lines()),
              HasSubstr("known_par.txt: line 5: the file ends before the line of every image"));
  EXPECT_THAT(ErrorWith("2\n" + Lines()), HasSubstr("line 4: more lines than the 2 images"));
  EXPECT_THAT(ErrorWith("some\n" + Lines()), HasSubstr("line 1: number of images expected"));
  EXPECT_THAT(ErrorWith("-1\n"), HasSubstr("line 1: number of images is not a count"));
  EXPECT_THAT(ErrorWith("1\nnone.png" + std::string(kCalibration) + "1 0 0 0 1 0 0 0 1 0 0 5\n"),
              HasSubstr("line 2: image \"none.png\" is not in the image folder"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png" + std::string(kCalibration) + "1 0 0 0 1 0 0 0 1 0 0 nan\n"),
              HasSubstr("line 2: element of t is not finite"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 600 1 320 0 600 240 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5\n"),
              HasSubstr("line 2: the pixels are skewed"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png" + std::string(kCalibration) + "0 0 0 0 0 0 0 0 0 0 0 5\n"),
              HasSubstr("line 2: the rotation matrix is none"));
  const std::string line = "img_1.png" + std::string(kCalibration) + "1 0 0 0 1 0 0 0 1 0 0 5";
  EXPECT_THAT(ErrorWith("1\n" + line + " 7\n"), HasSubstr("line 2: more than a name and 21"));
  EXPECT_THAT(ErrorWith("2\n" + line + "\n" + line + "\n"),
              HasSubstr("line 3: image 2: image name \"img_1.png\" occurs twice"));
}

TEST_F(Middlebury, AnImageThatCannotBeReadIsRefused) {
  const std::string path = dir_.WriteFile("known_par.txt", "3\n" + Lines());
  dir_.WriteFile("images/img_2.png", "no picture");
  EXPECT_THAT(Error(kMiddleburyFormat, path), HasSubstr("img_2.png"));
}

}  // namespace
}  // namespace limn::colmap_ext
