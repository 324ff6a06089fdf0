// SPDX-License-Identifier: BSD-3-Clause
// Bad depth and normal maps that drawing_fuser reads: case 31 of tests/README.md. The scene is a
// plane with two links on it and one that hovers above it (fusion_scene.h).
#include "end_to_end/corpus_case.h"
#include "end_to_end/fusion_scene.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using W = CorpusWorkspace;
constexpr Outcome kAccepted = Outcome::kAccepted;

void WriteMaps(const W& w, double scale = 0.25, const std::string& kind = "geometric") {
  WritePlaneDrawing(w / "drawing.json", w.Model());
  WritePlaneDepthMaps(w / "stereo", w.Model(), scale, kind);
}

constexpr char kMap[] = "stereo/depth_maps/view_02.jpg.geometric.bin";

// Maps of which one is this.
void WithMap(const W& w, const std::string& bytes) {
  WriteMaps(w);
  w.Write(kMap, bytes);
}

// What every run must find.
void ExpectClasses(const W& w) { ExpectPlaneClasses(w / "drawing-fused.json"); }

const std::vector<CorpusCase> kCases = {
    {.name = "Case31_NoHeader",
     .spoil = [](const W& w) { WithMap(w, "80 60 1 and no more"); },
     .said = {"view_02.jpg.geometric.bin: byte 3: the header is not \"width&height&channels&\""}},
    {.name = "Case31_EmptyMap",
     .spoil = [](const W& w) { WithMap(w, ""); },
     .said = {"view_02.jpg.geometric.bin: byte 0: truncated"}},
    {.name = "Case31_ThreeChannels",
     .spoil = [](const W& w) { WithMap(w, "2&1&3&" + std::string(24, '\0')); },
     .said = {"view_02.jpg.geometric.bin: not a depth map: 3 channels instead of 1"}},
    {.name = "Case31_DataShort",
     .spoil =
         [](const W& w) {
           WriteMaps(w);
           w.Cut(kMap, 1);
         },
     .said = {"view_02.jpg.geometric.bin: byte 10: truncated: 19200 values expected, 19199 found"}},
    {.name = "Case31_DataLong",
     .spoil =
         [](const W& w) {
           WriteMaps(w);
           w.Append(kMap, "more");
         },
     .said = {"view_02.jpg.geometric.bin: byte 76810: 4 bytes after the last record"}},
    {.name = "Case31_SmallerByAFactor",
     .spoil = [](const W& w) { WriteMaps(w, 0.125); },
     .outcome = kAccepted,
     .said = {"6 depth maps for 6 images"},
     .check = ExpectClasses},
    {.name = "Case31_LargerThanTheImagesAsUsed",
     .spoil = [](const W& w) { WriteMaps(w, 1); },
     .outcome = kAccepted,
     .said = {"6 depth maps for 6 images"},
     .check = ExpectClasses},
    {.name = "Case31_OtherAspect",
     .spoil = [](const W& w) { WithMap(w, "160&160&1&" + std::string(160 * 160 * 4, '\0')); },
     .said = {"view_02.jpg.geometric.bin: 160 x 160 pixels, which is not the shape of its image"}},
    {.name = "Case31_OnlyPhotometricMaps",
     .spoil = [](const W& w) { WriteMaps(w, 0.25, "photometric"); },
     .outcome = kAccepted,
     .said = {"6 depth maps for 6 images"},
     .check = ExpectClasses},
    {.name = "Case31_MapsForSomeImages",
     .spoil =
         [](const W& w) {
           WriteMaps(w);
           for (const char* number : {"00", "02", "03"}) {
             w.Remove(std::string("stereo/depth_maps/view_") + number + ".jpg.geometric.bin");
           }
         },
     .outcome = kAccepted,
     .said = {"3 depth maps for 6 images"},
     .check = ExpectClasses},
    {.name = "Case31_MapsOfOtherImages",
     .spoil =
         [](const W& w) {
           WriteMaps(w);
           fs::remove_all(w / "stereo");
           w.Write("stereo/depth_maps/other.jpg.geometric.bin", "1&1&1&1234");
         },
     .said = {"stereo: no depth map of any image"}},
    {.name = "Case31_NamesWithFolders",
     .spoil =
         [](const W& w) {
           for (const char* name : {"view_01.jpg", "view_04.jpg"}) {
             w.Replace("sparse/images.txt", name, std::string("left/x y/") + name);
             fs::create_directories(w / "images/left/x y");
             fs::rename(w / "images" / name, w / "images/left/x y" / name);
           }
           WriteMaps(w);
         },
     .outcome = kAccepted,
     .said = {"6 depth maps for 6 images"},
     .check = ExpectClasses},
    {.name = "Case31_NormalsOfAnotherSize",
     .spoil =
         [](const W& w) {
           WriteMaps(w);
           w.Write("stereo/normal_maps/view_02.jpg.geometric.bin",
                   "1&1&3&" + std::string(12, '\0'));
         },
     .said = {"normal_maps/view_02.jpg.geometric.bin: not the size of its depth map"}},
    {.name = "Case31_NormalsWithOneChannel",
     .spoil =
         [](const W& w) {
           WriteMaps(w);
           w.Write("stereo/normal_maps/view_02.jpg.geometric.bin", w.Read(kMap));
         },
     .said = {"normal_maps/view_02.jpg.geometric.bin: not a normal map: 1 channels instead of 3"}},
};

class CorpusDepthMaps : public Corpus {};
TEST_P(CorpusDepthMaps, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusDepthMaps,
                         ::testing::ValuesIn(OfCommand("drawing_fuser", kCases)), NameOf);

}  // namespace
}  // namespace limn::testing
