// SPDX-License-Identifier: BSD-3-Clause
// Bad points: cases 29 and 30 of tests/README.md. geo_referenced_test shows that such a model
// gives the same drawing.
#include "colmap_ext/model/scene_origin.h"
#include "end_to_end/corpus_case.h"

namespace limn::testing {
namespace {

using W = CorpusWorkspace;
constexpr Outcome kAccepted = Outcome::kAccepted;

const CorpusCase kCases[] = {
    {.name = "Case29_NoPoints", .outcome = kAccepted, .said = {"6 images, 0 3D points"}},
    {.name = "Case29_OnePoint",
     .outcome = kAccepted,
     .said = {"6 images, 1 3D points", "Written: "},
     .command = "automatic_drawer",
     .arguments = {"--quality", "low"}},
    {.name = "Case29_NotFinite",
     .outcome = kAccepted,
     .said = {"WARNING: 2 3D points left out: not finite or defined twice",
              "6 images, 1 3D points"}},
    {.name = "Case29_ExtremeOutliers",
     .spoil =
         [](const W& w) {
           w.Append("sparse/points3D.txt", "97 1e30 0 0 1 2 3 0\n98 0 -1e300 0 1 2 3 0\n");
           w.Replace("sparse/points3D.txt", "\n1 ", "\n96 1e30 1e30 1e30 9 9 9 0 1 0 2 0\n1 ");
         },
     .outcome = kAccepted,
     .said =
         {"WARNING: 3 3D points are seen by no image or far outside the scene, and were left out",
          "6 images, 60 3D points", "Written: "},
     .command = "automatic_drawer",
     .arguments = {"--quality", "low"}},
    {.name = "Case29_DuplicateIds",
     .spoil = [](const W& w) { w.Append("sparse/points3D.txt", "7 1 2 3 1 2 3 0 1 0\n"); },
     .outcome = kAccepted,
     .said = {"WARNING: 1 3D points left out: not finite or defined twice",
              "6 images, 60 3D points"}},
    {.name = "Case29_BlackPoints", .outcome = kAccepted, .said = {"6 images, 2 3D points"}},
    {.name = "Case29_ColorOutOfRange",
     .spoil = [](const W& w) { w.Append("sparse/points3D.txt", "97 0 0 0 256 2 3 0\n"); },
     .said = {"points3D.txt: line 62: \"256\" is not a number (R G B)"}},
    {.name = "Case30_GeoReferenced",
     .spoil =
         [](const W& w) {
           colmap_ext::SparseModel model = w.Model();
           colmap_ext::MoveModel({5e5, 4e6, 100}, &model);
           w.WriteText(model);
         },
     .outcome = kAccepted,
     .said = {"Coordinates are large: working around (50000", "Written: "},
     .command = "automatic_drawer",
     .arguments = {"--quality", "low"}},
};

class CorpusPoints : public Corpus {};
TEST_P(CorpusPoints, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusPoints, ::testing::ValuesIn(kCases), NameOf);

}  // namespace
}  // namespace limn::testing
