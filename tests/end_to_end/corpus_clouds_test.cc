// SPDX-License-Identifier: BSD-3-Clause
// Bad clouds and meshes that drawing_fuser reads: cases 32 and 33 of tests/README.md. The scene is
// a plane with two links on it and one that hovers above it (fusion_scene.h).
#include "colmap_ext/dense_files/patch_file.h"
#include "end_to_end/corpus_case.h"
#include "end_to_end/fusion_scene.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using W = CorpusWorkspace;
constexpr Outcome kAccepted = Outcome::kAccepted;

void WriteDrawingOf(const W& w) { WritePlaneDrawing(w / "drawing.json", w.Model()); }

// What every run must find.
void ExpectClasses(const W& w) { ExpectPlaneClasses(w / "drawing-fused.json"); }

void ExpectClassesAndNothingForMeshers(const W& w) {
  ExpectClasses(w);
  EXPECT_FALSE(fs::exists(w / "with-curves"));
}

void WriteCloud(const W& w, const PlyForm& form = {}) {
  WriteDrawingOf(w);
  w.Write("fused.ply", PlanePly(form));
}

// fused.ply, whose every point the same images see.
void WriteCloudAndVisibility(const W& w, const std::vector<uint32_t>& images,
                             uint64_t num_more = 0) {
  WriteCloud(w);
  const size_t count = PlanePoints().size();
  std::string bytes = Bytes<uint64_t>(count + num_more);
  for (size_t k = 0; k < count + num_more; ++k) {
    bytes += Bytes(static_cast<uint32_t>(images.size()));
    for (const uint32_t image : images) bytes += Bytes(image);
  }
  w.Write("fused.ply.vis", bytes);
}

constexpr char kPatches[] = "pmvs/models/option-0000.patch";

// The plane in patches that the images with these numbers see.
void WritePatches(const W& w, const std::vector<int>& images) {
  WriteDrawingOf(w);
  w.Write(kPatches, PlanePatches(images));
}

// The list of a PMVS folder, whose order is not the model's.
void WriteList(const W& w) {
  std::string list;
  const colmap_ext::SparseModel model = w.Model();
  for (auto image = model.images.rbegin(); image != model.images.rend(); ++image) {
    list += image->name + '\n';
  }
  w.Write("pmvs/bundle.rd.out.list.txt", list);
}

void ExpectClassesAndPatches(const W& w) {
  ExpectClasses(w);
  size_t count = 0;
  colmap_ext::ReadPatchFile((w / "pmvs-with-curves.patch").string(),
                            [&](const colmap_ext::Patch&) { ++count; });
  EXPECT_GT(count, PlanePoints().size());
}

const std::vector<CorpusCase> kCases = {
    {.name = "Case32_FuserReadsACloud",
     .spoil =
         [](const W& w) {
           WriteCloudAndVisibility(w, {0, 1, 2, 3, 4, 5});
         },
     .outcome = kAccepted,
     .said = {"6561 dense points with the images that see them", "with-curves"},
     .check = ExpectClasses},
    {.name = "Case32_FuserWhereTheUsersCloudIs",
     .spoil =
         [](const W& w) {
           WriteCloud(w);
           w.Write("with-curves/fused.ply", "mine");
         },
     .said = {"with-curves/fused.ply: exists, and there is no drawing-fused.json",
              "--overwrite 1 replaces it"}},
    {.name = "Case32_FuserWhereTheUsersModelIs",
     .spoil =
         [](const W& w) {
           WriteCloud(w);
           w.Write("with-curves/sparse/notes.txt", "mine");
         },
     .said = {"with-curves/sparse: is a folder, not the link that is to be made"}},
    {.name = "Case32_FuserAsciiExtraPropertyNoNormals",
     .spoil =
         [](const W& w) { WriteCloud(w, {.ascii = true, .normals = false, .more = "quality"}); },
     .outcome = kAccepted,
     .said = {"6561 dense points", "WARNING: ", "fused.ply has no normals: nothing is written"},
     .check = ExpectClassesAndNothingForMeshers},
    {.name = "Case32_FuserNoVertices",
     .spoil =
         [](const W& w) {
           WriteDrawingOf(w);
           w.Write("fused.ply",
                   "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\n"
                   "property float y\nproperty float z\nend_header\n");
         },
     .said = {"fused.ply: no points"}},
    {.name = "Case32_FuserTruncated",
     .spoil =
         [](const W& w) {
           WriteCloud(w);
           w.Cut("fused.ply", 1);
         },
     .said = {"fused.ply: vertex 6560: the file ends too early"}},
    {.name = "Case32_FuserTruncatedAscii",
     .spoil = [](const W& w) { WriteCloud(w, {.ascii = true, .num_said = 6562}); },
     .said = {"fused.ply: line 6575: the file ends too early"}},
    {.name = "Case32_FuserHugeNumberOfVertices",
     .spoil = [](const W& w) { WriteCloud(w, {.num_said = 18446744073709551615u}); },
     .said = {"fused.ply: vertex 6561: the file ends too early"}},
    {.name = "Case32_FuserFacesOnly",
     .spoil =
         [](const W& w) {
           WriteDrawingOf(w);
           w.Write("fused.ply", "ply\nformat ascii 1.0\nelement face 0\nend_header\n");
         },
     .said = {"fused.ply: the first element is not vertex"}},
    {.name = "Case32_FuserCountUnlikeThatOfVis",
     .spoil =
         [](const W& w) {
           WriteCloudAndVisibility(w, {0, 1}, 1);
         },
     .said = {"fused.ply.vis: byte 0: 6562 points, but the cloud has 6561"}},
    {.name = "Case32_FuserVisOfImageThatIsNone",
     .spoil =
         [](const W& w) {
           WriteCloudAndVisibility(w, {0, 6});
         },
     .said = {"fused.ply.vis: byte 16: image 6, but the model has 6"}},
    {.name = "Case32_FuserVisTruncated",
     .spoil =
         [](const W& w) {
           WriteCloudAndVisibility(w, {0, 1});
           w.Cut("fused.ply.vis", 2);
         },
     .said = {"fused.ply.vis: byte ", "truncated: 4 bytes expected for image number, 2 left"}},
    {.name = "Case32_FuserVisTooLong",
     .spoil =
         [](const W& w) {
           WriteCloudAndVisibility(w, {0, 1});
           w.Append("fused.ply.vis", Bytes<uint32_t>(0));
         },
     .said = {"fused.ply.vis: byte 78740: 4 bytes after the last record"}},

    {.name = "Case33_FuserReadsPatches",
     .spoil =
         [](const W& w) {
           WritePatches(w, {0, 3, 5});
           WriteList(w);
         },
     .outcome = kAccepted,
     .said = {"6561 dense points with the images that see them"},
     .check = ExpectClassesAndPatches},
    {.name = "Case33_FuserPatchTruncated",
     .spoil =
         [](const W& w) {
           WritePatches(w, {0, 3, 5});
           WriteList(w);
           w.Cut(kPatches, 12);
         },
     .said = {"option-0000.patch: line ", "the file ends before"}},
    {.name = "Case33_FuserNoPatchFile",
     .spoil =
         [](const W& w) {
           WritePatches(w, {0});
           WriteList(w);
           w.Write(kPatches, PlanePly({}));
         },
     .said = {"option-0000.patch: line 1: not a .patch file"}},
    {.name = "Case33_FuserPatchOfImageBeyondTheList",
     .spoil =
         [](const W& w) {
           WritePatches(w, {0, 6});
           WriteList(w);
         },
     .said = {"option-0000.patch: patch 0: image 6, but there are only 6"}},
    {.name = "Case33_FuserPatchOfNegativeImage",
     .spoil =
         [](const W& w) {
           WritePatches(w, {0, -1});
           WriteList(w);
         },
     .said = {"option-0000.patch: line 8: negative image number"}},
    {.name = "Case33_FuserListOfOtherImages",
     .spoil =
         [](const W& w) {
           WritePatches(w, {0});
           w.Write("pmvs/bundle.rd.out.list.txt", "a.jpg\nb.jpg\n");
         },
     .said = {"option-0000.patch: bundle.rd.out.list.txt beside it names none of the images"}},
    {.name = "Case33_FuserNameListMissing",
     .spoil =
         [](const W& w) {
           WritePatches(w, {0, 3, 5});
         },
     .outcome = kAccepted,
     .said = {"WARNING: ", "pmvs/bundle.rd.out.list.txt is missing: image numbers are taken"},
     .check = ExpectClassesAndPatches},
    {.name = "Case33_FuserPlyOnly",
     .spoil =
         [](const W& w) {
           WriteDrawingOf(w);
           WriteList(w);
           w.Write("pmvs/models/option-0000.ply", PlanePly({.ascii = true}));
         },
     .outcome = kAccepted,
     .said = {"option-0000.ply", "6561 dense points\n"},
     .check = ExpectClasses},

    {.name = "Case33_FuserMeshIndexOutOfRange",
     .spoil =
         [](const W& w) {
           WriteDrawingOf(w);
           w.Write("meshed-poisson.ply", PlaneMesh());
           w.Replace("meshed-poisson.ply", "4 0 1 2 3", "4 0 1 2 4");
         },
     .said = {"meshed-poisson.ply: line 14: face to vertex 4", " of 4"}},
    {.name = "Case33_FuserReadsAMesh",
     .spoil =
         [](const W& w) {
           WriteDrawingOf(w);
           w.Write("meshed-poisson.ply", PlaneMesh());
         },
     .outcome = kAccepted,
     .said = {"dense results: mesh"},
     .check = ExpectClasses},
};

class CorpusClouds : public Corpus {};
TEST_P(CorpusClouds, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusClouds,
                         ::testing::ValuesIn(OfCommand("drawing_fuser", kCases)), NameOf);

}  // namespace
}  // namespace limn::testing
