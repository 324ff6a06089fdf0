// SPDX-License-Identifier: BSD-3-Clause
// Bad images: cases 18 to 27 of tests/README.md.
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "end_to_end/corpus_case.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using W = CorpusWorkspace;
using colmap_ext::ModelImage;
using colmap_ext::SparseModel;

// Another place for what is now called view_02.jpg, in the model and on disk.
void RenameImage(const W& w, const std::string& name) {
  SparseModel model = w.Model();
  for (ModelImage& image : model.images) {
    if (image.name == "view_02.jpg") image.name = name;
  }
  fs::create_directories((w / "images" / name).parent_path());
  fs::rename(w / "images/view_02.jpg", w / "images" / name);
  w.WriteText(model);
}

// Only in the model.
void CallImage(const W& w, const std::string& name) {
  w.Replace("sparse/images.txt", "view_02.jpg", name);
}

void ChangeImages(const W& w, const std::function<void(ModelImage*)>& change) {
  SparseModel model = w.Model();
  for (ModelImage& image : model.images) change(&image);
  w.WriteText(model);
}

void KeepImages(const W& w, size_t count) {
  SparseModel model = w.Model();
  model.images.resize(count);
  w.WriteBinary(model);
}

// Poses alone, as tools that know the poses write them.
void WithoutPoints(const W& w, uint64_t point3D_id, bool keep_observations) {
  SparseModel model = w.Model();
  model.points.clear();
  for (ModelImage& image : model.images) {
    if (!keep_observations) image.observations.clear();
    for (colmap_ext::Observation& point : image.observations) point.point3D_id = point3D_id;
  }
  w.WriteText(model);
}

// images.txt after an editor took the lines that are empty or hold points.
void StripPointLines(const W& w) {
  std::istringstream lines(w.Read("sparse/images.txt"));
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(".jpg")) kept += line + "\n";
  }
  w.Write("sparse/images.txt", kept);
}

cv::Mat Photo() { return cv::imread(LIMN_SAMPLE_DIR "/day/images/view_02.jpg"); }

// view_02 in another form.
void StoreAs(const W& w, const std::string& name, const cv::Mat& pixels) {
  w.Remove("images/view_02.jpg");
  CallImage(w, name);
  ASSERT_TRUE(cv::imwrite((w / "images" / name).string(), pixels));
}

cv::Mat With(const cv::Mat& photo, int color_conversion) {
  cv::Mat converted;
  cv::cvtColor(photo, converted, color_conversion);
  return converted;
}

cv::Mat With16Bits(const cv::Mat& photo) {
  cv::Mat converted;
  photo.convertTo(converted, CV_16U, 257);
  return converted;
}

cv::Mat Resized(int width, int height) {
  cv::Mat resized;
  cv::resize(Photo(), resized, {width, height}, 0, 0, cv::INTER_AREA);
  return resized;
}

cv::Mat Turned() {
  cv::Mat turned;
  cv::rotate(Photo(), turned, cv::ROTATE_90_CLOCKWISE);
  return turned;
}

// An EXIF block that asks for a quarter turn, put behind the start of a JPEG file. COLMAP and limn
// take the pixels as they are stored.
std::string WithExifRotation(const std::string& jpeg) {
  std::string exif = "Exif";
  exif += std::string(2, '\0') + "II*" + std::string(1, '\0') + Bytes<uint32_t>(8);
  exif += Bytes<uint16_t>(1) + Bytes<uint16_t>(0x0112) + Bytes<uint16_t>(3) + Bytes<uint32_t>(1);
  exif += Bytes<uint32_t>(6) + Bytes<uint32_t>(0);
  const uint16_t length = static_cast<uint16_t>(exif.size() + 2);
  std::string segment = "\xFF\xE1";
  segment += static_cast<char>(length >> 8);
  segment += static_cast<char>(length & 0xFF);
  return jpeg.substr(0, 2) + segment + exif + jpeg.substr(2);
}

const CorpusCase kCases[] = {
    {.name = "Case18_UnknownCamera",
     .spoil = [](const W& w) { w.Replace("sparse/images.txt", " 1 view_02", " 5 view_02"); },
     .said = {"images.txt: line 6: image 3 (view_02.jpg) refers to camera 5, which is not among "
              "the cameras"}},
    {.name = "Case19_DuplicateImageId",
     .spoil = [](const W& w) { w.Replace("sparse/images.txt", "\n3 ", "\n2 "); },
     .said = {"images.txt: line 6: image 2 is defined twice"}},
    {.name = "Case19_DuplicateName",
     .spoil = [](const W& w) { CallImage(w, "view_01.jpg"); },
     .said = {"images.txt: line 6: image 3: image name \"view_01.jpg\" occurs twice"}},
    {.name = "Case20_ZeroQuaternion",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/images.bin", 8 + 4, std::string(32, '\0'));
         },
     .said = {"images.bin: byte 8: image 1 (view_00.jpg): the rotation is a zero quaternion"}},
    {.name = "Case20_NanQuaternion",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/images.bin", 8 + 4, Bytes(std::nan("")));
         },
     .said = {"images.bin: byte 8: image 1 (view_00.jpg): the pose is not finite"}},
    {.name = "Case20_InfiniteTranslation",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Poke("sparse/images.bin", 8 + 4 + 32, Bytes(-HUGE_VAL));
         },
     .said = {"images.bin: byte 8: image 1 (view_00.jpg): the pose is not finite"}},
    {.name = "Case20_QuaternionNotOfUnitLength",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           std::string doubled;
           for (int i = 0; i < 4; ++i) doubled += Bytes(i == 0 ? 2.0 : 0.0);
           w.Poke("sparse/images.bin", 8 + 4, doubled);
         },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: 1 image rotations were not unit quaternions; normalized"}},
    {.name = "Case21_SpacesAndSubFolders",
     .spoil = [](const W& w) { RenameImage(w, "left camera/day 1/view 02.jpg"); },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case21_NotAscii",
     .spoil = [](const W& w) { RenameImage(w, "Fläche_№2.jpg"); },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case21_NotUtf8",
     .spoil =
         [](const W& w) {
           RenameImage(w, "Fläche.jpg");
           w.Replace("sparse/images.txt", "Fläche.jpg",
                     "Fl\xE4"
                     "che.jpg");
         },
     .outcome = Outcome::kAccepted,
     .said = {"NOTE: ", "1 names are in windows-1252, those of the files in UTF-8"}},
    {.name = "Case21_ClimbingName",
     .spoil = [](const W& w) { CallImage(w, "../images/view_02.jpg"); },
     .said = {"image 3: image name \"../images/view_02.jpg\" leads out of the image folder"}},
    {.name = "Case21_AbsoluteName",
     .spoil = [](const W& w) { CallImage(w, "/etc/passwd"); },
     .said = {"image 3: image name \"/etc/passwd\" leads out of the image folder"}},
    {.name = "Case21_BackSlashes",
     .spoil =
         [](const W& w) {
           RenameImage(w, "left/view_02.jpg");
           w.Replace("sparse/images.txt", "left/view_02.jpg", "left\\view_02.jpg");
         },
     .outcome = Outcome::kAccepted,
     .said = {"NOTE: ", "back slashes (\"left\\view_02.jpg\" is left/view_02.jpg)"}},
    {.name = "Case21_CaseMismatch",
     .spoil = [](const W& w) { CallImage(w, "View_02.JPG"); },
     .said = {"View_02.JPG: the image is registered in the model but missing on disk; ",
              "view_02.jpg is there"}},
    {.name = "Case21_ExtensionChanged",
     .spoil = [](const W& w) { CallImage(w, "view_02.tif"); },
     .said = {"view_02.tif: the image is registered in the model but missing on disk; ",
              "view_02.jpg is there"}},
    {.name = "Case21_NoName",
     .spoil = [](const W& w) { w.Replace("sparse/images.txt", " view_02.jpg", ""); },
     .said = {"images.txt: line 6: image 3: the image has no name"}},
    {.name = "Case21_VeryLongName",
     .spoil = [](const W& w) { CallImage(w, std::string(5000, 'x') + ".jpg"); },
     .said = {"image 3: the image name is longer than 4096 bytes"}},
    {.name = "Case21_NameTooLongForTheDisk",
     .spoil = [](const W& w) { CallImage(w, std::string(300, 'x') + ".jpg"); },
     .said = {"xxx.jpg: the image is registered in the model but missing on disk"}},
    {.name = "Case21_LineEndInAName",
     .spoil =
         [](const W& w) {
           w.MakeBinary();
           w.Replace("sparse/images.bin", "view_02.jpg", "view\n02.jpg");
         },
     .said = {"view\\x0a02.jpg: the image is registered in the model but missing on disk"}},
    {.name = "Case21_DuplicatesAfterTruncation",
     .spoil = [](const W& w) { w.Replace("sparse/images.txt", "view_02.jpg", "view_01.jpg "); },
     .said = {"image 3: image name \"view_01.jpg\" occurs twice"}},
    {.name = "Case22_PosesAlone",
     .spoil = [](const W& w) { WithoutPoints(w, 0, /*keep_observations=*/false); },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 0 3D points", "Written: "},
     .command = "automatic_drawer",
     .arguments = {"--quality", "low"}},
    {.name = "Case22_PointsWithout3D",
     .spoil =
         [](const W& w) { WithoutPoints(w, colmap_ext::kNoPoint3D, /*keep_observations=*/true); },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 0 3D points"}},
    {.name = "Case22_PointLinesStripped",
     .spoil = StripPointLines,
     .said = {"images.txt: line 2: ", "is the line of points missing?"}},
    {.name = "Case23_TwoImages",
     .spoil = [](const W& w) { KeepImages(w, 2); },
     .said = {"at least 3 registered images are needed, got 2"},
     .command = "automatic_drawer"},
    {.name = "Case23_TwoImagesAndADuplicate",
     .spoil =
         [](const W& w) {
           KeepImages(w, 3);
           w.ReplaceImage("view_02.jpg", w.Read("images/view_01.jpg"));
         },
     .said = {"at least 3 registered images are needed, got 2; 1 of 3 images are duplicates",
              "left out: view_02.jpg (of view_01.jpg)"},
     .command = "automatic_drawer"},
    {.name = "Case23_NoImages",
     .spoil = [](const W& w) { KeepImages(w, 0); },
     .said = {"no registered image"}},
    {.name = "Case23_Panorama",
     .spoil =
         [](const W& w) {
           ChangeImages(w, [](ModelImage* image) {
             image->cam_from_world.translation =
                 -(image->cam_from_world.rotation * Eigen::Vector3d(1, -2, 3));
           });
         },
     .said = {"the cameras are all at one center: nothing can be triangulated"},
     .command = "automatic_drawer"},
    {.name = "Case23_GeoReferencedPanorama",
     .spoil =
         [](const W& w) {
           ChangeImages(w, [](ModelImage* image) {
             image->cam_from_world.translation =
                 -(image->cam_from_world.rotation * Eigen::Vector3d(5e5, 4e6, 100));
           });
         },
     .said = {"the cameras are all at one center: nothing can be triangulated"},
     .command = "curve_sketcher"},
    {.name = "Case24_PointsOutsideTheImage",
     .spoil =
         [](const W& w) {
           ChangeImages(w, [](ModelImage* image) {
             if (!image->observations.empty()) image->observations[0].position = {-1e6, 1e9};
           });
         },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case24_UnknownPointId",
     .spoil =
         [](const W& w) {
           ChangeImages(w, [](ModelImage* image) {
             image->observations.push_back({{5, 5}, 123456789});
           });
         },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case24_TrackOfAMissingImage",
     .spoil = [](const W& w) { w.Append("sparse/points3D.txt", "99 0 0 0 1 2 3 0 77 0 1 0\n"); },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: 1 elements of point tracks left out: no such image"}},
    {.name = "Case24_TracksDisagree",
     .spoil = [](const W& w) { w.Append("sparse/points3D.txt", "99 0 0 0 1 2 3 0 1 4000 2 0\n"); },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: 2 elements of point tracks do not agree with the 2D points of their"}},
    {.name = "Case24_EmptyTracks",
     .spoil =
         [](const W& w) {
           SparseModel model = w.Model();
           for (colmap_ext::ModelPoint& point : model.points) point.track.clear();
           w.WriteBinary(model);
         },
     .outcome = Outcome::kAccepted,
     .said =
         {"WARNING: 60 3D points are seen by no image or far outside the scene, and were left out",
          "6 images, 0 3D points"}},
    {.name = "Case19_OneFileTwice",
     .spoil =
         [](const W& w) {
           SparseModel model = w.Model();
           model.images.push_back(model.images[2]);
           model.images.back().id = 77;
           model.images.back().name = "./view_02.jpg";
           w.WriteBinary(model);
         },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: 1 of 7 images are duplicates", "view_02.jpg (of ./view_02.jpg)",
              "6 images, 60 3D points"}},
    {.name = "Case25_MissingOnDisk",
     .spoil =
         [](const W& w) {
           w.Remove("images/view_02.jpg");
           w.Remove("images/view_04.jpg");
         },
     .said = {"view_02.jpg: the image is registered in the model but missing on disk (and 1 other "
              "images)"}},
    {.name = "Case25_ZeroBytes",
     .spoil = [](const W& w) { w.ReplaceImage("view_02.jpg", ""); },
     .said = {"view_02.jpg: cannot be decoded as an image"}},
    {.name = "Case25_NoImage",
     .spoil = [](const W& w) { w.ReplaceImage("view_02.jpg", "this is no picture"); },
     .said = {"view_02.jpg: cannot be decoded as an image"}},
    {.name = "Case25_Heic",
     .spoil =
         [](const W& w) {
           const std::string heic = std::string(3, '\0') +
                                    "\x18"
                                    "ftypheic" +
                                    std::string(99, 'x');
           w.ReplaceImage("view_02.jpg", heic);
         },
     .said = {"view_02.jpg: cannot be decoded as an image"}},
    {.name = "Case25_TruncatedJpeg",
     .spoil =
         [](const W& w) {
           const std::string jpeg = w.Read("images/view_02.jpg");
           w.ReplaceImage("view_02.jpg", jpeg.substr(0, jpeg.size() / 2));
         },
     .said = {"view_02.jpg: truncated"}},
    {.name = "Case25_TruncatedPng",
     .spoil =
         [](const W& w) {
           StoreAs(w, "view_02.png", Photo());
           w.Cut("images/view_02.png", w.Read("images/view_02.png").size() / 2);
         },
     .said = {"view_02.png: truncated"}},
    {.name = "Case25_ZeroedJpeg",
     .spoil =
         [](const W& w) {
           std::string jpeg = w.Read("images/view_02.jpg");
           const size_t size = jpeg.size() / 4;
           w.ReplaceImage("view_02.jpg", jpeg.replace(size, size, std::string(size, '\0')));
         },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: ", "view_02.jpg: Corrupt JPEG data: ", "the whole image counts as masked"}},
    {.name = "Case25_CutJpegWithAnEnd",
     .spoil =
         [](const W& w) {
           const std::string jpeg = w.Read("images/view_02.jpg");
           w.ReplaceImage("view_02.jpg", jpeg.substr(0, jpeg.size() / 2) + "\xFF\xD9");
         },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: ", "view_02.jpg: Corrupt JPEG data: ", "the whole image counts as masked"},
     .command = "curve_sketcher"},
    {.name = "Case25_HugePng",
     .spoil =
         [](const W& w) {
           const std::string size = {0, 0, 0x75, 0x30, 0, 0, 0x75, 0x30};  // 30,000 squared
           w.ReplaceImage("view_02.jpg", "\x89PNG\r\n\x1A\n" + std::string(3, '\0') + "\rIHDR" +
                                             size + "\x08" + std::string(12, '\0') + "IEND" +
                                             "1234");
         },
     .said = {"view_02.jpg: too large to decode: 30000 x 30000 pixels may take 5400 MB"}},
    {.name = "Case25_EmptyImageList",
     .spoil = [](const W& w) { w.Write("list.txt", " \n"); },
     .said = {"list.txt: names no image"},
     .arguments = {"--image_list_path", "{W}/list.txt"}},
    {.name = "Case25_EndlessImageList",
     .said = {"/dev/zero: "},
     .arguments = {"--image_list_path", "/dev/zero"}},
    {.name = "Case25_SixteenBits",
     .spoil = [](const W& w) { StoreAs(w, "view_02.png", With16Bits(Photo())); },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case25_Gray",
     .spoil = [](const W& w) { StoreAs(w, "view_02.png", With(Photo(), cv::COLOR_BGR2GRAY)); },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case25_Alpha",
     .spoil = [](const W& w) { StoreAs(w, "view_02.png", With(Photo(), cv::COLOR_BGR2BGRA)); },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case25_ExifRotated",
     .spoil =
         [](const W& w) {
           w.ReplaceImage("view_02.jpg", WithExifRotation(w.Read("images/view_02.jpg")));
         },
     .outcome = Outcome::kAccepted,
     .said = {"6 images, 60 3D points"}},
    {.name = "Case26_ResizedImage",
     .spoil = [](const W& w) { StoreAs(w, "view_02.png", Resized(320, 240)); },
     .outcome = Outcome::kAccepted,
     .said = {"WARNING: 1 images differ in size from their camera; intrinsics were rescaled"}},
    {.name = "Case26_TurnedImage",
     .spoil = [](const W& w) { StoreAs(w, "view_02.png", Turned()); },
     .said = {"view_02.png: the image is 480 x 640 pixels, but its camera 1 is 640 x 480"}},
    {.name = "Case26_CroppedImage",
     .spoil =
         [](const W& w) {
           StoreAs(w, "view_02.png", Photo()({0, 0, 600, 480}));
         },
     .said = {"view_02.png: the image is 600 x 480 pixels, but its camera 1 is 640 x 480"}},
    {.name = "Case27_ImagesOfAnotherModel",
     .spoil = [](const W& w) { w.Replace("sparse/cameras.txt", "640 480", "660 487"); },
     .said = {"view_00.jpg: the image is 640 x 480 pixels, but its camera 1 is 660 x 487",
              "raw and undistorted ones differ"}},
};

class CorpusImages : public Corpus {};
TEST_P(CorpusImages, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusImages, ::testing::ValuesIn(kCases), NameOf);

}  // namespace
}  // namespace limn::testing
