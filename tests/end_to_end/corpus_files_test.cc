// SPDX-License-Identifier: BSD-3-Clause
// Bad files and folders: cases 1 to 11 of tests/README.md.
#include <bit>

#include "end_to_end/corpus_case.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using W = CorpusWorkspace;

constexpr size_t kFirstNameOffset = 8 + 64;  // in images.bin

// sparse/0 with all images, sparse/1 with three.
void MakeSubModels(const W& w) {
  colmap_ext::SparseModel model = w.Model();
  fs::remove_all(w / "sparse");
  for (const char* folder : {"sparse/0", "sparse/1"}) {
    w.WriteText(model, folder);
    model.images.resize(3);
  }
}

std::string BigEndian64(uint64_t value) {
  std::string bytes = Bytes(value);
  return {bytes.rbegin(), bytes.rend()};
}

const CorpusCase kCases[] = {
    {.name = "Case01_MissingFolder", .said = {"nowhere: no such folder"}, .folder = "nowhere"},
    {.name = "Case01_WorkspaceIsAFile",
     .said = {"cameras.txt: no such folder"},
     .folder = "sparse/cameras.txt"},
    {.name = "Case01_EmptyFolder",
     .spoil = [](const W& w) { fs::create_directories(w / "empty"); },
     .said = {"empty: no COLMAP model with its images", "found nothing"},
     .folder = "empty"},
    {.name = "Case01_ListsWhatWasFound",
     .spoil =
         [](const W& w) {
           fs::remove_all(w / "sparse");
           w.Write("database.db", "");
         },
     .said = {"found database.db, images/"}},
    {.name = "Case01_FolderOfSubModels",
     .spoil = MakeSubModels,
     .outcome = Outcome::kAccepted,
     .said = {"sparse/0 (6 registered images, most of 2 models)"},
     .folder = "sparse"},
    {.name = "Case01_SubModelByIndex",
     .spoil = MakeSubModels,
     .outcome = Outcome::kAccepted,
     .said = {"sparse/1 (3 registered images)"},
     .arguments = {"--model_index", "1"}},
    {.name = "Case01_NoSuchIndex",
     .spoil = MakeSubModels,
     .said = {"with model_index 7", "in sparse: 0/, 1/"},
     .arguments = {"--model_index", "7"}},
    {.name = "Case01_NoImageFolder",
     .spoil = [](const W& w) { fs::remove_all(w / "images"); },
     .said = {"no COLMAP model with its images", "found sparse/"}},
    {.name = "Case02_ImagesMissing",
     .spoil = [](const W& w) { w.Remove("sparse/images.txt"); },
     .said = {"sparse: not a COLMAP model: images.txt is missing beside cameras.txt"}},
    {.name = "Case02_CamerasMissing",
     .spoil = [](const W& w) { w.Remove("sparse/cameras.txt"); },
     .said = {"sparse: not a COLMAP model: cameras.txt is missing beside images.txt"}},
    {.name = "Case02_BinaryAndTextMixed",
     .spoil =
         [](const W& w) {
           const std::string images = w.Read("sparse/images.txt");
           w.MakeBinary();
           w.Remove("sparse/images.bin");
           w.Write("sparse/images.txt", images);
         },
     .said = {"cameras.txt is missing beside images.txt"}},
    {.name = "Case02_PointsMissing",
     .spoil = [](const W& w) { w.Remove("sparse/points3D.txt"); },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: ", "points3D.txt is missing: continuing with the poses alone"}},
    {.name = "Case02_CompleteTextBesideBinaryWithoutPoints",
     .spoil =
         [](const W& w) {
           w.Write("sparse/cameras.bin", "");
           w.Write("sparse/images.bin", "");
         },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case03_BothFlavorsTextNewer",
     .spoil =
         [](const W& w) {
           const std::string images = w.Read("sparse/images.txt");
           w.MakeBinary();
           w.Write("sparse/cameras.txt", "");
           w.Write("sparse/images.txt", images);
           w.Write("sparse/points3D.txt", "");
           fs::last_write_time(w / "sparse/images.bin",
                               fs::file_time_type::clock::now() - std::chrono::hours(1));
         },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: ", "images.txt is newer than images.bin; the binary files were read"}},
    {.name = "Case04_EmptyCameras",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Write("sparse/cameras.bin", "");
         },
     .said = {"cameras.bin: byte 0: truncated"}},
    {.name = "Case04_EmptyImages",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Write("sparse/images.bin", "");
         },
     .said = {"images.bin: byte 0: truncated"}},
    {.name = "Case04_EmptyPoints",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Write("sparse/points3D.bin", "");
         },
     .said = {"points3D.bin: byte 0: truncated"}},
    {.name = "Case04_EmptyText",
     .spoil = [](const W& w) { w.Write("sparse/images.txt", ""); },
     .said = {"no registered image"}},
    {.name = "Case05_TruncatedImages",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Cut("sparse/images.bin", 7);
         },
     .said = {"images.bin: byte ", "does not fit the remaining"}},
    {.name = "Case05_TruncatedInAName",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           // One image; its name has no end.
           w.Poke("sparse/images.bin", 0, Bytes<uint64_t>(1));
           const size_t size = w.Read("sparse/images.bin").size();
           w.Cut("sparse/images.bin", size - kFirstNameOffset);
           w.Append("sparse/images.bin", std::string(20, 'x'));
         },
     .said = {"images.bin: byte ", "truncated", "image name"}},
    {.name = "Case06_TruncatedPoints",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Cut("sparse/points3D.bin", 5);
         },
     .said = {"points3D.bin: byte ", "does not fit the remaining"}},
    {.name = "Case07_BytesAfterTheCameras",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Append("sparse/cameras.bin", "rest");
         },
     .said = {"cameras.bin: byte ", "4 bytes after the last record"}},
    {.name = "Case07_BytesAfterTheImages",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Append("sparse/images.bin", "rest");
         },
     .said = {"images.bin: byte ", "4 bytes after the last record"}},
    {.name = "Case08_HugeNumberOfImages",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/images.bin", 0, Bytes<uint64_t>(0x7FFFFFFFFFFFFFFF));
         },
     .said = {"images.bin: byte 0: number of images = 9223372036854775807 does not fit"}},
    {.name = "Case08_HugeNumberOfCameras",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/cameras.bin", 0, Bytes(uint64_t{1} << 40));
         },
     .said = {"cameras.bin: byte 0: number of cameras = "}},
    {.name = "Case08_HugeTrack",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/points3D.bin", 8 + 43, Bytes<uint64_t>(0x1000000000000000));
         },
     .said = {"points3D.bin: byte 51: track length = "}},
    {.name = "Case09_BigEndian",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/cameras.bin", 0, BigEndian64(1));
         },
     .said = {"cameras.bin: byte 0: ", "not a COLMAP file"}},
    {.name = "Case09_CountsOf32Bits",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Write("sparse/cameras.bin", w.Read("sparse/cameras.bin").substr(4));
         },
     .said = {"cameras.bin: byte 0: ", "not a COLMAP file"}},
    {.name = "Case09_LengthPrefixedName",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           std::string bytes = w.Read("sparse/images.bin");
           w.Write("sparse/images.bin", bytes.insert(kFirstNameOffset, Bytes<uint64_t>(11)));
         },
     .said = {"images.bin: byte "}},
    {.name = "Case10_LfsPointer", .said = {"images.bin: byte 0: text, not a binary COLMAP file"}},
    {.name = "Case10_Html", .said = {"images.bin: byte 0: text, not a binary COLMAP file"}},
    {.name = "Case10_Zip", .said = {"images.bin: byte 0: ", "not a COLMAP file"}},
    {.name = "Case11_UnreadableModel",
     .spoil = [](const W& w) { fs::permissions(w / "sparse/images.txt", fs::perms::none); },
     .said = {"images.txt: cannot be opened for reading"},
     .arguments = {"--output_path", "/tmp"},
     .as_nobody = true},
    {.name = "Case11_SymbolicLinkLoop",
     .spoil =
         [](const W& w) {
           w.Remove("images/view_02.jpg");
           fs::create_symlink("view_02.jpg", w / "images/view_02.jpg");
         },
     .said = {"view_02.jpg: the image is a symbolic link that leads nowhere"}},
    {.name = "Case11_MovedOriginals",
     .spoil =
         [](const W& w) {
           w.Remove("images/view_02.jpg");
           fs::create_symlink("/moved/view_02.jpg", w / "images/view_02.jpg");
         },
     .said = {"view_02.jpg: the image is a symbolic link that leads nowhere"}},
    {.name = "Case11_ReadOnlyWorkspace",
     .spoil =
         [](const W& w) {
           fs::permissions(w.path(), fs::perms::owner_write, fs::perm_options::remove);
         },
     .said = {"results cannot be written here", "choose another --output_path"},
     .as_nobody = true},
    {.name = "Case11_OutputIsAFile",
     .spoil = [](const W& w) { w.Write("results", "mine"); },
     .said = {"results", "is not a folder", "choose another --output_path"},
     .arguments = {"--output_path", "{W}/results"}},
};

class CorpusFiles : public Corpus {};
TEST_P(CorpusFiles, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusFiles, ::testing::ValuesIn(kCases), NameOf);

}  // namespace
}  // namespace limn::testing
