// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/image_reader.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/exif_of_jpeg.h"
#include "colmap_ext/workspace/image_header.h"
#include "colmap_ext/workspace/image_traits.h"
#include "limn/files/error_line.h"
#include "limn/files/quiet_decoders.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

constexpr const char* kNames[] = {"a.png",  "a.jpg", "a.tiff", "a.bmp",
                                  "a.webp", "a.jp2", "a.pgm",  "a.ras"};

class ImageReader : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const cv::Mat& image) {
    const std::string path = (dir_ / name).string();
    EXPECT_TRUE(cv::imwrite(path, image));
    return path;
  }

  TempDir dir_;
};

std::string Content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  return content.str();
}

TEST_F(ImageReader, ColorIsRgb) {
  const Image image = ReadImage(Write("a.png", cv::Mat(2, 3, CV_8UC3, cv::Scalar(10, 20, 30))));
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.channels, 3);
  ASSERT_EQ(image.data.size(), 18u);
  EXPECT_EQ(image.data[0], 30);
  EXPECT_EQ(image.data[1], 20);
  EXPECT_EQ(image.data[2], 10);
  EXPECT_TRUE(image.mask.empty());
}

TEST_F(ImageReader, RowsComeInOrder) {
  cv::Mat gray(2, 3, CV_8UC1);
  for (int i = 0; i < 6; ++i) gray.at<uchar>(i / 3, i % 3) = static_cast<uchar>(i);
  const Image image = ReadImage(Write("gray.png", gray));
  EXPECT_EQ(image.channels, 1);
  EXPECT_THAT(image.data, ::testing::ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST_F(ImageReader, SixteenBitsBecomeGrayLevels) {
  const Image image = ReadImage(Write("deep.png", cv::Mat(2, 2, CV_16UC1, cv::Scalar(65535))));
  EXPECT_EQ(image.data.at(0), 255);
  const Image color =
      ReadImage(Write("deep3.png", cv::Mat(2, 2, CV_16UC3, cv::Scalar(0, 257, 514))));
  EXPECT_EQ(color.data.at(0), 2);
}

TEST_F(ImageReader, AlphaIsDropped) {
  const Image image = ReadImage(Write("alpha.png", cv::Mat(2, 2, CV_8UC4, cv::Scalar(1, 2, 3, 0))));
  EXPECT_EQ(image.channels, 3);
  EXPECT_EQ(image.data.at(0), 3);
}

TEST_F(ImageReader, ExifRotationIsIgnored) {
  const std::string plain = Write("plain.jpg", cv::Mat(4, 6, CV_8UC3, cv::Scalar(9, 9, 9)));
  const std::string path = dir_.WriteFile("rotated.jpg", WithOrientation(Content(plain), 6));
  // The file does ask for a rotation.
  ASSERT_EQ(cv::imread(path).cols, 4);
  EXPECT_EQ(ReadImage(path).width, 6);
  EXPECT_EQ(ReadImageSize(path), (ImageSize{6, 4}));
}

TEST_F(ImageReader, FloatImagesAreRefused) {
  const std::string path = Write("float.tiff", cv::Mat(2, 2, CV_32FC1, cv::Scalar(0.5)));
  EXPECT_THAT(ErrorText<IoError>([&] { ReadImage(path); }), HasSubstr("8 or 16 bits"));
}

TEST_F(ImageReader, MissingAndDamagedFilesAreNamed) {
  EXPECT_THAT(ErrorText<IoError>([&] { ReadImage(dir_ / "no.png"); }),
              HasSubstr("no.png: no such image file"));
  const std::string empty = dir_.WriteFile("empty.jpg", "");
  const std::string html = dir_.WriteFile("page.jpg", "<html></html>");
  for (const std::string& path : {empty, html}) {
    EXPECT_THAT(ErrorText<IoError>([&] { ReadImage(path); }), HasSubstr("cannot be decoded"));
    EXPECT_THAT(ErrorText<IoError>([&] { ReadImageSize(path); }), HasSubstr("cannot be decoded"));
  }
}

// The lines of libjpeg and libpng name no file: our own do.
TEST_F(ImageReader, DecodersPrintNothing) {
  cv::Mat gray(64, 64, CV_8UC1);
  cv::randu(gray, 0, 255);
  std::string jpeg = Content(Write("a.jpg", gray));
  jpeg.replace(jpeg.size() / 2, 200, std::string(200, '\x5A'));
  const std::string damaged = (dir_ / "damaged.jpg").string();
  std::ofstream(damaged, std::ios::binary) << jpeg;
  std::string png = Content(Write("a.png", gray));
  png[20] = '\x40';  // a size of gigapixels, and the checksum is wrong
  const std::string huge = (dir_ / "huge.png").string();
  std::ofstream(huge, std::ios::binary) << png;

  ::testing::internal::CaptureStderr();
  EXPECT_NO_THROW(ReadImage(damaged));
  EXPECT_THROW(ReadMask(huge, {64, 64}), IoError);
  EXPECT_THROW(ReadImage(huge), IoError);
  std::fputs("ours\n", stderr);
  PrintErrorLine("and ours");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "ours\nand ours\n");
}

TEST_F(ImageReader, SizeComesFromTheHeader) {
  const cv::Mat image(50, 70, CV_8UC1, cv::Scalar(0));
  for (const char* name : kNames) {
    EXPECT_EQ(ReadSizeFromHeader(Write(name, image)), (ImageSize{70, 50})) << name;
    EXPECT_EQ(ReadImage(dir_ / name).width, 70) << name;
  }
}

// Headers that OpenCV does not write.
TEST_F(ImageReader, SizeComesFromOtherHeaders) {
  using namespace std::string_literals;
  const std::string lossy = "RIFF\x2E\0\0\0WEBPVP8 \x22\0\0\0"s;
  const std::string headers[] = {
      "MM\0\x2A\0\0\0\x08\0\x02\x01\0\0\x03\0\0\0\x01\0\x07\0\0"
      "\x01\x01\0\x04\0\0\0\x01\0\0\0\x05"s,
      "II\x2B\0\x08\0\0\0\x10\0\0\0\0\0\0\0\x02\0\0\0\0\0\0\0"
      "\0\x01\x03\0\x01\0\0\0\0\0\0\0\x07\0\0\0\0\0\0\0"
      "\x01\x01\x03\0\x01\0\0\0\0\0\0\0\x05\0\0\0\0\0\0\0"s,
      "BM" + std::string(12, '\0') + "\x0C\0\0\0\x07\0\x05\0"s,
      "BM" + std::string(12, '\0') + "\x28\0\0\0\x07\0\0\0\xFB\xFF\xFF\xFF"s,
      lossy + "\x10\0\0\x9D\x01\x2A\x07\0\x05\0"s,
      "RIFF\x2E\0\0\0WEBPVP8X\x0A\0\0\0\0\0\0\0\x06\0\0\x04\0\0"s,
      "\xFF\x4F\xFF\x51\0\x2F\0\0\0\0\0\x08\0\0\0\x06\0\0\0\x01\0\0\0\x01"s,
      "P2 # a comment 8 8\n# another\n 7\n5 255\n"s,
      // Bytes between segments, which decoders skip.
      "\xFF\xD8\xFF\xE0\0\x02xyz\xFF\xFF\xC0\0\x0B\x08\0\x05\0\x07"s,
      // Markers without a length.
      "\xFF\xD8\xFF\x01\xFF\xD7\xFF\xC0\0\x0B\x08\0\x05\0\x07"s};
  for (const std::string& header : headers) {
    std::istringstream in(header);
    EXPECT_EQ(ReadSizeFromHeader(in), (ImageSize{7, 5})) << header;
  }
}

// Lengths of boxes may have 64 bits.
TEST_F(ImageReader, Jpeg2000BoxesMayBeLong) {
  using namespace std::string_literals;
  std::string content = Content(Write("a.jp2", cv::Mat(50, 70, CV_8UC1, cv::Scalar(7))));
  const size_t codes = content.find("jp2c");
  ASSERT_NE(codes, std::string::npos);
  std::string length(8, '\0');
  length[6] = static_cast<char>((content.size() - codes + 12) >> 8);
  length[7] = static_cast<char>(content.size() - codes + 12);
  content.replace(codes - 4, 8, "\0\0\0\1jp2c"s + length);
  content.insert(codes - 4, "\0\0\0\1free\0\0\0\0\0\0\0\x12xy"s);
  const Image image = ReadImage(dir_.WriteFile("long.jp2", content));
  EXPECT_EQ(image.width, 70);
  EXPECT_EQ(image.data.at(0), 7);
}

TEST_F(ImageReader, DamagedHeadersHaveNoSize) {
  const cv::Mat image(50, 70, CV_8UC1, cv::Scalar(0));
  for (const char* name : kNames) {
    const std::string content = Content(Write(name, image));
    for (size_t size = 0; size < 5; ++size) {
      std::istringstream in(content.substr(0, size));
      EXPECT_FALSE(ReadSizeFromHeader(in)) << name << " " << size;
    }
  }
  for (const char* other :
       {"text", "P5 7 x", "P7\nWIDTH 7\n", "II*", "RIFF", "BMBMBMBMBMBMBMBMBMBM"}) {
    std::istringstream in(other);
    EXPECT_FALSE(ReadSizeFromHeader(in)) << other;
  }
}

TEST_F(ImageReader, LongerSideIsLimited) {
  EXPECT_EQ(ShrunkSize({640, 480}, -1), (ImageSize{640, 480}));
  EXPECT_EQ(ShrunkSize({640, 480}, 640), (ImageSize{640, 480}));
  EXPECT_EQ(ShrunkSize({640, 480}, 320), (ImageSize{320, 240}));
  EXPECT_EQ(ShrunkSize({480, 641}, 100), (ImageSize{75, 100}));
  EXPECT_EQ(ShrunkSize({1, 1000}, 100), (ImageSize{1, 100}));
}

TEST_F(ImageReader, ShrinkingAverages) {
  cv::Mat gray(2, 4, CV_8UC1, cv::Scalar(0));
  gray.at<uchar>(0, 0) = 100;
  gray.at<uchar>(1, 3) = 40;
  const Image image = ReadImage(Write("gray.png", gray), 2);
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 1);
  EXPECT_THAT(image.data, ::testing::ElementsAre(25, 10));
}

TEST_F(ImageReader, MaskCountsOnlyPixelsThatAreWholeInside) {
  cv::Mat gray(2, 4, CV_8UC1, cv::Scalar(1));
  gray.at<uchar>(1, 3) = 0;
  const std::string path = Write("mask.png", gray);
  EXPECT_THAT(ReadMask(path, {4, 2}), ::testing::ElementsAre(1, 1, 1, 1, 1, 1, 1, 0));
  EXPECT_THAT(ReadMask(path, {4, 2}, 2), ::testing::ElementsAre(1, 0));
  EXPECT_THAT(ErrorText<IoError>([&] {
                ReadMask(path, {4, 4});
              }),
              HasSubstr("the mask is 4 x 2 pixels, its image 4 x 4: the aspect must be the same"));
}

TEST_F(ImageReader, MasksOfOtherSizesAreScaled) {
  cv::Mat gray(2, 4, CV_8UC1, cv::Scalar(255));
  gray.at<uchar>(0, 0) = 0;
  const std::string path = Write("mask.png", gray);
  EXPECT_THAT(ReadMask(path, {8, 4}),
              ::testing::ElementsAre(0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 1, 1,  //
                                     1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1));
  EXPECT_THAT(ReadMask(path, {8, 4}, 2), ::testing::ElementsAre(0, 1));
  EXPECT_THAT(ReadMask(path, {2, 1}), ::testing::ElementsAre(0, 1));
  // Of the file as it is stored, though the photograph is turned by 90 degrees clockwise.
  EXPECT_THAT(ReadMask(path, {2, 4}, -1, 6), ::testing::ElementsAre(1, 0, 1, 1, 1, 1, 1, 1));
}

TEST_F(ImageReader, MasksOfAllKinds) {
  const auto use_of = [&](const std::string& name, const cv::Mat& mask) {
    return ReadMask(Write(name, mask), {2, 1});
  };
  const auto pair = [](int type, const cv::Scalar& left, const cv::Scalar& right) {
    cv::Mat mask(1, 2, type, left);
    mask.col(1).setTo(right);
    return mask;
  };
  using ::testing::ElementsAre;
  EXPECT_THAT(use_of("a.png", pair(CV_8UC1, 0, 1)), ElementsAre(0, 1));
  EXPECT_THAT(use_of("a.png", pair(CV_16UC1, 0, 1)), ElementsAre(0, 1));
  EXPECT_THAT(use_of("a.png", pair(CV_8UC3, {0, 0, 0}, {1, 0, 0})), ElementsAre(0, 1));
  // Alpha: alone, beside colors, and opaque everywhere.
  EXPECT_THAT(use_of("a.png", pair(CV_8UC4, {0, 0, 0, 255}, {0, 0, 0, 0})), ElementsAre(1, 0));
  EXPECT_THAT(use_of("a.png", pair(CV_8UC4, {9, 9, 9, 255}, {9, 9, 9, 0})), ElementsAre(1, 0));
  EXPECT_THAT(use_of("a.png", pair(CV_8UC4, {9, 9, 9, 255}, {0, 0, 0, 255})), ElementsAre(1, 0));
  // JPEG files are not exact.
  cv::Mat large(16, 32, CV_8UC1, cv::Scalar(3));
  large.colRange(16, 32).setTo(250);
  const auto mask = ReadMask(Write("a.jpg", large), {32, 16});
  EXPECT_EQ(mask[0], 0);
  EXPECT_EQ(mask[31], 1);
}

// A picture of 3 x 2 pixels 0 to 5, turned upright by every orientation.
TEST_F(ImageReader, PicturesAreTurnedOnRequest) {
  cv::Mat pixels(2, 3, CV_8UC1);
  for (int i = 0; i < 6; ++i) pixels.at<uchar>(i / 3, i % 3) = static_cast<uchar>(i);
  const std::string path = Write("a.png", pixels);
  const std::map<int, std::vector<float>> expected = {
      {1, {0, 1, 2, 3, 4, 5}}, {2, {2, 1, 0, 5, 4, 3}}, {3, {5, 4, 3, 2, 1, 0}},
      {4, {3, 4, 5, 0, 1, 2}}, {5, {0, 3, 1, 4, 2, 5}}, {6, {3, 0, 4, 1, 5, 2}},
      {7, {5, 2, 4, 1, 3, 0}}, {8, {2, 5, 1, 4, 0, 3}}};
  for (const auto& [orientation, values] : expected) {
    const Image image = ReadImage(path, -1, {.orientation = orientation});
    EXPECT_EQ(image.width, orientation < 5 ? 3 : 2);
    EXPECT_EQ(image.data, values) << orientation;
  }
}

TEST_F(ImageReader, OrientationsOfAllFormatsAreFound) {
  const std::string path = Write("a.jpg", cv::Mat(4, 6, CV_8UC1, cv::Scalar(7)));
  EXPECT_EQ(ReadTraits(std::filesystem::path(path)).orientation, 1);
  EXPECT_EQ(
      ReadTraits(std::filesystem::path(dir_.WriteFile("b.jpg", WithOrientation(Content(path), 6))))
          .orientation,
      6);
}

TEST_F(ImageReader, PartsOfTheRangeAreStretched) {
  const std::string path = Write("a.png", cv::Mat(2, 2, CV_16UC1, cv::Scalar(2048)));
  EXPECT_FLOAT_EQ(ReadImage(path, -1, {.range = LevelRange{0, 4096}}).data[0], 127.5f);
  EXPECT_EQ(RangeToShow({0, 3277}), (LevelRange{0, 3584}));
  EXPECT_EQ(RangeToShow({7300, 8200}), (LevelRange{7296, 8320}));
  EXPECT_FALSE(RangeToShow({0, 40000}));
  EXPECT_FALSE(RangeToShow({100, 110}));
  cv::Mat noise(100, 200, CV_16UC3);
  cv::randu(noise, 100, 4000);
  noise.at<cv::Vec3w>(0, 0) = {65535, 0, 0};  // a hot pixel
  const PixelScan scan = ScanPixels(std::filesystem::path(Write("b.png", noise)));
  EXPECT_NEAR(scan.values->low, 100, 3);
  EXPECT_NEAR(scan.values->high, 4000, 3);
  EXPECT_FALSE(scan.has_mask);
}

TEST_F(ImageReader, AlphaIsAMaskIfItHidesSomething) {
  cv::Mat pixels(1, 4, CV_8UC4, cv::Scalar(1, 2, 3, 255));
  const auto scan_of = [&] { return ScanPixels(std::filesystem::path(Write("a.png", pixels))); };
  EXPECT_FALSE(scan_of().has_mask);
  pixels.at<cv::Vec4b>(0, 1)[3] = 127;
  pixels.at<cv::Vec4b>(0, 2)[3] = 128;
  EXPECT_TRUE(scan_of().has_mask);
  EXPECT_TRUE(ReadTraits(dir_ / "a.png").has_alpha);
  EXPECT_THAT(ReadAlpha(dir_ / "a.png", -1, {}), ::testing::ElementsAre(1, 0, 1, 1));
  EXPECT_THAT(ReadAlpha(dir_ / "a.png", -1, {.orientation = 6}),
              ::testing::ElementsAre(1, 0, 1, 1));
  for (int x = 0; x < 4; ++x) pixels.at<cv::Vec4b>(0, x)[3] = 0;
  EXPECT_FALSE(scan_of().has_mask);  // a program that leaves the channel empty
}

// The same to a level as if it had been decoded whole. A ramp shows where pixels are.
TEST_F(ImageReader, LargeJpegsAreDecodedReduced) {
  cv::Mat ramp(4003, 5001, CV_8UC1);
  for (int y = 0; y < ramp.rows; ++y) {
    for (int x = 0; x < ramp.cols; ++x) {
      ramp.at<uchar>(y, x) = static_cast<uchar>(
          ((x + y) / 4) % 500 < 250 ? (x + y) / 4 % 250 : 249 - (x + y) / 4 % 250);
    }
  }
  const std::string whole = Write("whole.png", ramp);
  const std::string reduced = Write("reduced.jpg", ramp);
  for (const int size : {300, 1001, 2500}) {
    const Image expected = ReadImage(whole, size);
    const Image image = ReadImage(reduced, size);
    ASSERT_EQ(image.width, expected.width);
    ASSERT_EQ(image.height, expected.height);
    for (size_t i = 0; i < image.data.size(); ++i) {
      ASSERT_NEAR(image.data[i], expected.data[i], 1.5) << size << " " << i;
    }
  }
}

// To the bit: rows are shrunk one by one only where memory would be short.
TEST_F(ImageReader, LargeImagesAreShrunkAsOthers) {
  cv::Mat noise(4003, 4001, CV_8UC3);
  cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 255);
  const Image image = ReadImage(Write("noise.bmp", noise), 301);
  cv::Mat levels, expected;
  noise.convertTo(levels, CV_32F);
  cv::resize(levels, expected, {image.width, image.height}, 0, 0, cv::INTER_AREA);
  cv::cvtColor(expected, expected, cv::COLOR_BGR2RGB);
  const cv::Mat shrunk(image.height, image.width, CV_32FC3, const_cast<float*>(image.data.data()));
  EXPECT_EQ(cv::norm(shrunk, expected, cv::NORM_INF), 0);
}

TEST_F(ImageReader, SizesAreBounded) {
  const auto error = [](ImageSize stored, int max_image_size) {
    return ErrorText<IoError>([&] { CheckDecodable("a.png", stored, max_image_size); });
  };
  EXPECT_EQ(error({12000, 9000}, -1), "");
  EXPECT_EQ(error({16000, 16000}, 300), "");
  EXPECT_EQ(error({16000, 16000}, -1),
            "a.png: too large to decode: 16000 x 16000 pixels may take 4608 MB, at most 2000: "
            "lower --max_image_size");
  EXPECT_EQ(error({30000, 30000}, 300),
            "a.png: too large to decode: 30000 x 30000 pixels may take 5401 MB, at most 2000: "
            "make the file smaller");
  EXPECT_EQ(error({INT32_MAX, INT32_MAX}, 300),
            "a.png: too large to decode: 2147483647 x 2147483647 pixels may take 27670116084795 "
            "MB, at most 2000: make the file smaller");
}

TEST_F(ImageReader, DecodersOfSomeFormatsTakeMore) {
  const cv::Mat image(50, 70, CV_8UC1, cv::Scalar(0));
  const std::map<std::string, int> megabytes = {
      {"a.jp2", 4500}, {"a.tiff", 2700}, {"a.webp", 0}, {"a.png", 0}};
  for (const auto& [name, expected] : megabytes) {
    const std::string path = Write(name, image);
    const std::string text = ErrorText<IoError>([&] { CheckDecodable(path, {15000, 10000}, 300); });
    EXPECT_EQ(text.empty(), expected == 0) << text;
    EXPECT_THAT(text, HasSubstr(expected == 0 ? "" : std::to_string(expected) + " MB")) << name;
  }
  const std::string path = Write("large.webp", image);
  EXPECT_THAT(ErrorText<IoError>([&] {
                CheckDecodable(path, {16383, 16383}, 300);
              }),
              HasSubstr("2147 MB"));
}

// Sanitizers need more addresses than a limit leaves.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// In a process of its own: the decoder keeps the frequencies of the whole picture in memory.
TEST_F(ImageReader, LittleMemoryIsNoDamage) {
  const std::string path = (dir_ / "progressive.jpg").string();
  ASSERT_TRUE(cv::imwrite(path, cv::Mat(8000, 8000, CV_8UC1, cv::Scalar(7)),
                          {cv::IMWRITE_JPEG_PROGRESSIVE, 1}));
  const auto check_with_little_memory = [&] {
    size_t num_pages = 0;
    std::ifstream("/proc/self/statm") >> num_pages;
    const rlim_t bytes = num_pages * static_cast<size_t>(getpagesize()) + (rlim_t{48} << 20);
    const rlimit limit = {bytes, bytes};
    setrlimit(RLIMIT_AS, &limit);
    std::fputs(ErrorText<IoError>([&] { CheckImage(path, 300); }).c_str(), stderr);
    std::_Exit(0);
  };
  EXPECT_EXIT(check_with_little_memory(), ::testing::ExitedWithCode(0),
              "progressive.jpg: does not fit in memory");
}
#endif

// A header that promises more pixels than the file can have.
TEST_F(ImageReader, BombsAreNotDecoded) {
  using namespace std::string_literals;
  const std::string header = "BM" + std::string(12, '\0') + "\x28\0\0\0\x30\x75\0\0\x30\x75\0\0"s;
  const std::string path = dir_.WriteFile("a.bmp", header);
  for (const std::string& error :
       {ErrorText<IoError>([&] { ReadImage(path, 300); }), ErrorText<IoError>([&] {
          ReadMask(path, {30000, 30000}, 300);
        })}) {
    EXPECT_THAT(error, HasSubstr("a.bmp: too large to decode: 30000 x 30000"));
  }
}

// Cut anywhere within the pixels; OpenCV would make up the rest.
TEST_F(ImageReader, TruncatedFilesAreRefused) {
  cv::Mat noise(64, 64, CV_8UC3);
  cv::randu(noise, 0, 255);
  for (const char* name : {"a.png", "a.jpg"}) {
    const std::string whole = Content(Write(name, noise));
    const std::string trailing = dir_.WriteFile("trailing", whole + "a maker's note");
    EXPECT_FALSE(IsTruncated(trailing)) << name;
    for (const size_t size : {whole.size() - 13, whole.size() - 20, whole.size() / 2}) {
      const std::string path = dir_.WriteFile("cut", whole.substr(0, size));
      for (const std::string& error :
           {ErrorText<IoError>([&] { ReadImageSize(path); }),
            ErrorText<IoError>([&] { CheckImage(path, -1); }), ErrorText<IoError>([&] {
              ReadMask(path, {64, 64});
            })}) {
        EXPECT_THAT(error, HasSubstr("cut: truncated")) << name << " " << size;
      }
    }
  }
  using namespace std::string_literals;
  // An end in a comment, which seems to be the picture's if 01 is taken for a marker with a length.
  std::istringstream hidden("\xFF\xD8\xFF\x01\xFF\xFE\0\4ab\xFF\xFE\xFF\xFF"s +
                            std::string(65524, 'x') + "\xFF\xDA\0\2\xFF\xD9xyz"s);
  EXPECT_TRUE(IsTruncated(hidden));
  std::istringstream other("BM");
  EXPECT_FALSE(IsTruncated(other));
}

}  // namespace
}  // namespace limn::colmap_ext
