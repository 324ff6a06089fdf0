// SPDX-License-Identifier: BSD-3-Clause
// Bad cameras: cases 12 to 17 of tests/README.md. The cameras.txt of most are in tests/corpus.
#include "end_to_end/corpus_case.h"

namespace limn::testing {
namespace {

using W = CorpusWorkspace;

// One camera per image, all alike.
void GiveEveryImageItsCamera(const W& w) {
  colmap_ext::SparseModel model = w.Model();
  const colmap_ext::Camera camera = model.cameras[0];
  model.cameras.clear();
  for (colmap_ext::ModelImage& image : model.images) {
    model.cameras.push_back(camera);
    model.cameras.back().id = image.camera_id = 1000 - image.id;
  }
  w.WriteBinary(model);
}

const CorpusCase kCases[] = {
    {.name = "Case12_UnknownModelId",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/cameras.bin", 8 + 4, Bytes<int32_t>(99));
         },
     .said = {"cameras.bin: byte 8: camera 1 has the unknown camera model id 99; supported: "
              "SIMPLE_PINHOLE, PINHOLE, "}},
    {.name = "Case12_UnknownModelName",
     .said = {"cameras.txt: line 2: camera 1 has the unknown camera model \"PINHOLE_STEREO\"; "
              "supported: SIMPLE_PINHOLE, PINHOLE, "}},
    {.name = "Case13_TooFewParameters",
     .said = {"cameras.txt: line 1: camera 1: PINHOLE has 4 parameters, found 3"}},
    {.name = "Case13_TooManyParameters",
     .said = {"cameras.txt: line 1: camera 1: PINHOLE has 4 parameters, found 5"}},
    {.name = "Case14_NanFocalLength",
     .said = {"cameras.txt: line 1: camera 1: a parameter is not "
              "finite"}},
    {.name = "Case14_InfiniteFocalLength", .said = {"camera 1: a parameter is not finite"}},
    {.name = "Case14_NegativeFocalLength", .said = {"camera 1: the focal length is not positive"}},
    {.name = "Case14_NoWidth", .said = {"camera 1: image size 0 x 480 makes no sense"}},
    {.name = "Case14_HugeHeight", .said = {"camera 1: image size 640 x 2000000 makes no sense"}},
    {.name = "Case14_DecimalComma",
     .said = {"cameras.txt: line 1: \"640,25\" is not a number (PARAMS)"}},
    {.name = "Case14_PrincipalPointOutside",
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: 1 cameras have their principal point outside the image"}},
    {.name = "Case15_MixedModelsAndUnusedCameras",
     .spoil =
         [](const W& w) {
           w.Replace("sparse/images.txt", " 1 view_01.jpg", " 2 view_01.jpg");
           w.Replace("sparse/images.txt", " 1 view_02.jpg", " 3 view_02.jpg");
         },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case15_OneCameraPerImage",
     .spoil = GiveEveryImageItsCamera,
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    // Whether a lens is needed is said by the camera, not by the name of the folder.
    {.name = "Case16_FisheyeInADenseFolder",
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case16_RadialWithoutDistortion",
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case16_Spherical",
     .said = {"cameras.txt: line 1: camera 1: an EQUIRECTANGULAR image of 640 x 480 pixels is not "
              "twice as wide as high"}},
    {.name = "Case17_DuplicateCamera", .said = {"cameras.txt: line 2: camera 1 is defined twice"}},
};

class CorpusCameras : public Corpus {};
TEST_P(CorpusCameras, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusCameras, ::testing::ValuesIn(kCases), NameOf);

}  // namespace
}  // namespace limn::testing
