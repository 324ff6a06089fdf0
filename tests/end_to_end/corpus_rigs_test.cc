// SPDX-License-Identifier: BSD-3-Clause
// Bad rigs and frames: case 28 of tests/README.md. The six images are of camera 1.
#include "colmap_ext/model/model.h"
#include "end_to_end/corpus_case.h"

namespace limn::testing {
namespace {

using W = CorpusWorkspace;
constexpr Outcome kAccepted = Outcome::kAccepted;

// frames.txt with the poses of images.txt, one frame per image, all of rig 1.
std::string Frames(const W& w, const Eigen::Vector3d& error) {
  std::ostringstream frames;
  frames.precision(17);
  for (const colmap_ext::ModelImage& image : w.Model().images) {
    const Eigen::Quaterniond& q = image.cam_from_world.rotation;
    const Eigen::Vector3d t = image.cam_from_world.translation + error;
    frames << image.id << " 1 " << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << ' '
           << t.x() << ' ' << t.y() << ' ' << t.z() << " 1 CAMERA 1 " << image.id << '\n';
  }
  return frames.str();
}

void Write(const W& w, const std::string& rigs, const std::string& frames) {
  w.Write("sparse/rigs.txt", rigs);
  w.Write("sparse/frames.txt", frames);
}

constexpr char kOneCamera[] = "1 1 CAMERA 1\n";
constexpr char kKept[] =
    " images have no pose by rigs and frames; that of the images file was kept";

const CorpusCase kCases[] = {
    {.name = "Case28_Agreeing",
     .spoil =
         [](const W& w) {
           Write(w, kOneCamera, Frames(w, {0, 0, 0}));
         },
     .outcome = kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case28_PosesDisagree",
     .spoil =
         [](const W& w) {
           Write(w, kOneCamera, Frames(w, {0.01, 0, 0}));
         },
     .outcome = kAccepted,
     .said = {"WARNING: 6 image poses differ from those of rigs and frames, which were used"}},
    {.name = "Case28_RigsWithoutFrames",
     .spoil = [](const W& w) { w.Write("sparse/rigs.txt", kOneCamera); },
     .outcome = kAccepted,
     .said = {"WARNING: ", "frames.txt is missing: continuing with the poses of the images file"}},
    {.name = "Case28_FramesWithoutRigs",
     .spoil =
         [](const W& w) {
           w.Write("sparse/frames.txt", Frames(w, {0, 0, 0}));
         },
     .outcome = kAccepted,
     .said = {"WARNING: ", "rigs.txt is missing: continuing with the poses of the images file"}},
    {.name = "Case28_ImagesInNoFrame",
     .spoil =
         [](const W& w) {
           const std::string frames = Frames(w, {0, 0, 0});
           Write(w, kOneCamera, frames.substr(0, frames.find('\n') + 1));
         },
     .outcome = kAccepted,
     .said = {std::string("WARNING: 5") + kKept}},
    {.name = "Case28_ImageInTwoFrames",
     .spoil =
         [](const W& w) {
           Write(w, kOneCamera, Frames(w, {0, 0, 0}) + "99 1 1 0 0 0 0 0 0 1 CAMERA 1 3\n");
         },
     .outcome = kAccepted,
     .said = {"WARNING: 1 images are in two frames; the first one was used"}},
    {.name = "Case28_UnknownRig",
     .spoil =
         [](const W& w) {
           Write(w, "5 1 CAMERA 1\n", Frames(w, {0, 0, 0}));
         },
     .outcome = kAccepted,
     .said = {std::string("WARNING: 6") + kKept}},
    {.name = "Case28_SensorWithoutPose",
     .spoil =
         [](const W& w) {
           Write(w, "1 2 CAMERA 9 CAMERA 1 0\n", Frames(w, {0, 0, 0}));
         },
     .outcome = kAccepted,
     .said = {std::string("WARNING: 6") + kKept}},
    {.name = "Case28_ImuSensors",
     .spoil =
         [](const W& w) {
           Write(w, "1 3 CAMERA 1 IMU 4 1 1 0 0 0 9 9 9 LIDAR 2 0\n", Frames(w, {0, 0, 0}));
         },
     .outcome = kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case28_ImuIsTheReference",
     .spoil =
         [](const W& w) {
           Write(w, "1 2 IMU 4 CAMERA 1 1 1 0 0 0 0.5 0 0\n", Frames(w, {-0.5, 0, 0}));
         },
     .outcome = kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case28_TruncatedRigs",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Write("sparse/rigs.bin", Bytes<uint64_t>(1) + Bytes<uint32_t>(1) + Bytes<uint32_t>(1) +
                                          Bytes<int32_t>(0));
           w.Write("sparse/frames.bin", Bytes<uint64_t>(0));
         },
     .said = {"rigs.bin: byte 12: number of sensors = 1 does not fit"}},
    {.name = "Case28_HugeNumberOfFrames",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Write("sparse/rigs.bin", Bytes<uint64_t>(0));
           w.Write("sparse/frames.bin", Bytes(uint64_t{1} << 60));
         },
     .said = {"frames.bin: byte 0: number of frames = "}},
    {.name = "Case28_BadNumberInAFrame",
     .spoil = [](const W& w) { Write(w, kOneCamera, "1 1 1 0 0 0 0 0 zero 1 CAMERA 1 1\n"); },
     .said = {"frames.txt: line 1: \"zero\" is not a number (TX TY TZ)"}},
};

class CorpusRigs : public Corpus {};
TEST_P(CorpusRigs, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusRigs, ::testing::ValuesIn(kCases), NameOf);

}  // namespace
}  // namespace limn::testing
