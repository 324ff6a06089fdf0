// SPDX-License-Identifier: BSD-3-Clause
// Bad clouds that drawing_evaluator reads, and PMVS folders as models: cases 32 and 33 of
// tests/README.md. What drawing_fuser reads is in corpus_depth_maps_test and corpus_clouds_test.
// COLMAP's PMVS folders that are good are in colmap_oracle_test.
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "end_to_end/corpus_case.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using W = CorpusWorkspace;
constexpr Outcome kAccepted = Outcome::kAccepted;

// What drawing_evaluator needs beside the workspace.
std::vector<std::string> Judge(const std::string& file) {
  return {"--input_path", "{W}/" + file, "--truth_path", "{W}/truth.txt", "--taus", "0.1"};
}

void WriteTruth(const W& w) { w.Write("truth.txt", "0 0 0\n1 0 0\n"); }

constexpr char kPlyHeader[] =
    "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty float quality\nend_header\n";

std::string PlyVertex(float x) {
  std::string bytes = Bytes(x);
  for (int i = 0; i < 5; ++i) bytes += Bytes(0.0f);
  return bytes + "rgb" + Bytes(1.0f);
}

// The PMVS folder of six cameras in the workspace itself, instead of sparse/ and images/.
void MakePmvs(const W& w) {
  const colmap_ext::SparseModel model = w.Model();
  fs::remove_all(w / "sparse");
  fs::rename(w / "images", w / "visualize");
  std::string list;
  for (size_t i = 0; i < model.images.size(); ++i) {
    const colmap_ext::ModelImage& image = model.images[i];
    const std::vector<double>& k = model.cameras[0].params;
    Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();
    intrinsics << k[0], 0, k[2], 0, k[1], k[3], 0, 0, 1;
    Eigen::Matrix<double, 3, 4> p;
    p << image.cam_from_world.rotation.toRotationMatrix(), image.cam_from_world.translation;
    const std::string number = "0000000" + std::to_string(i);
    std::ostringstream text;
    text << "CONTOUR\n" << intrinsics * p << '\n';
    w.Write("txt/" + number + ".txt", text.str());
    fs::rename(w / "visualize" / image.name, w / ("visualize/" + number + ".jpg"));
    list += image.name + '\n';
  }
  w.Write("bundle.rd.out.list.txt", list);
}

const CorpusCase kCases[] = {
    {.name = "Case32_AsciiWithExtraProperties",
     .spoil =
         [](const W& w) {
           WriteTruth(w);
           w.Write("fused.ply", std::string("ply\nformat ascii 1.0\n") + kPlyHeader +
                                    "0 0 0 0 0 1 1 2 3 0.5\n1 0 0 0 0 1 1 2 3 0.5\n");
         },
     .outcome = kAccepted,
     .said = {"100.0"},
     .command = "drawing_evaluator",
     .arguments = Judge("fused.ply")},
    {.name = "Case32_NoVertices",
     .spoil =
         [](const W& w) {
           WriteTruth(w);
           w.Write("fused.ply",
                   "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\n"
                   "property float y\nproperty float z\nend_header\n");
         },
     .said = {": no curves and no points (truth_path)"},
     .command = "drawing_evaluator",
     .arguments = {"--input_path", "{W}/truth.txt", "--truth_path", "{W}/fused.ply", "--taus",
                   "0.1"}},
    {.name = "Case32_FewerVerticesThanItSays",
     .spoil =
         [](const W& w) {
           WriteTruth(w);
           w.Write("fused.ply", std::string("ply\nformat binary_little_endian 1.0\n") + kPlyHeader +
                                    PlyVertex(0));
         },
     .said = {"fused.ply: byte ", "the file is too short for 2 of element vertex"},
     .command = "drawing_evaluator",
     .arguments = Judge("fused.ply")},
    {.name = "Case32_HugeNumberOfVertices",
     .spoil =
         [](const W& w) {
           WriteTruth(w);
           std::string header = kPlyHeader;
           header.replace(header.find(" 2\n"), 3, " 18446744073709551615\n");
           w.Write("fused.ply", "ply\nformat ascii 1.0\n" + header + "0 0 0\n");
         },
     .said = {"fused.ply: line ", "the file is too short"},
     .command = "drawing_evaluator",
     .arguments = Judge("fused.ply")},
    {.name = "Case33_PmvsFolder",
     .spoil = MakePmvs,
     .outcome = kAccepted,
     .said = {"(6 registered images)", "project/visualize", "6 images, 0 3D points"}},
    {.name = "Case33_NameListMissing",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           w.Remove("bundle.rd.out.list.txt");
         },
     .outcome = kAccepted,
     .said = {"WARNING: ", "list.txt is missing: images have the names of visualize/"}},
    {.name = "Case33_NameListOfAnotherFolder",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           w.Append("bundle.rd.out.list.txt", "one more.jpg\n");
         },
     .said = {"bundle.rd.out.list.txt: holds the names of 7 images, txt/ has 6"}},
    {.name = "Case33_ClusterOptionsBesideIt",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           w.Write("option-0000", "timages 3 0 2 4\n");
           w.Write("option-0001", "timages 3 1 3 5\n");
           w.Write("vis.dat", "VISDATA\n6\n0 1 6\n");
         },
     .outcome = kAccepted,
     .said = {"6 images, 0 3D points"}},
    {.name = "Case33_NegativeScale",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           std::istringstream old(w.Read("txt/00000002.txt"));
           std::string text;
           old >> text;
           std::ostringstream negative;
           negative << text << '\n';
           for (double value; old >> value;) negative << -3 * value << ' ';
           std::string flat = negative.str();
           // Four numbers a line.
           int spaces = 0;
           for (char& c : flat) {
             if (c == ' ' && ++spaces % 4 == 0) c = '\n';
           }
           w.Write("txt/00000002.txt", flat);
         },
     .outcome = kAccepted,
     .said = {"6 images, 0 3D points"}},
    {.name = "Case33_Skew",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           w.Write("txt/00000002.txt", "CONTOUR\n640 30 316 1\n0 640 244 1\n0 0 1 5\n");
         },
     .said = {"00000002.txt: the camera has skew (30.0"}},
    {.name = "Case33_SingularMatrix",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           w.Write("txt/00000002.txt", "CONTOUR\n640 0 316 1\n640 0 316 1\n0 0 1 5\n");
         },
     .said = {"00000002.txt: the projection matrix is singular"}},
    {.name = "Case33_NoContour",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           w.Write("txt/00000002.txt", "");
         },
     .said = {"00000002.txt: line 0: \"CONTOUR\" expected"}},
    {.name = "Case33_ShrunkImages",
     .spoil =
         [](const W& w) {
           MakePmvs(w);
           const std::string photo = (w / "visualize/00000003.jpg").string();
           const cv::Mat small = cv::imread(photo, cv::IMREAD_REDUCED_COLOR_2);
           fs::remove(photo);
           ASSERT_TRUE(cv::imwrite(photo, small));
         },
     .said = {"00000003.txt: the principal point", "shrunk without their matrices"}},
};

class CorpusDense : public Corpus {};
TEST_P(CorpusDense, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusDense, ::testing::ValuesIn(kCases), NameOf);

}  // namespace
}  // namespace limn::testing
