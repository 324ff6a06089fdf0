// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/jpeg_check.h"

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/image_reader.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kEnd = "\xFF\xD9";

class JpegCheck : public ::testing::Test {
 protected:
  JpegCheck() {
    cv::Mat noise(200, 300, CV_8UC3);
    cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 255);
    EXPECT_TRUE(cv::imwrite((dir_ / "whole.jpg").string(), noise));
    std::ifstream in(dir_ / "whole.jpg", std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    whole_ = content.str();
  }

  std::optional<JpegComplaint> Check(const std::string& content) const {
    return CheckJpeg(dir_.WriteFile("a.jpg", content));
  }

  TempDir dir_;
  std::string whole_;
};

TEST_F(JpegCheck, WholeFilesAreFine) {
  EXPECT_FALSE(Check(whole_));
  EXPECT_FALSE(Check(whole_ + "a maker's note"));
  EXPECT_FALSE(Check("no JPEG"));
  EXPECT_FALSE(Check(""));
}

TEST_F(JpegCheck, PaddingIsFine) {
  const std::string start = whole_.substr(0, whole_.size() - 2);
  EXPECT_FALSE(Check(start + std::string(100, '\0') + kEnd));
}

// Some programs leave it out.
TEST_F(JpegCheck, OnlyTheEndMarkerMayBeMissing) {
  cv::Mat noise(60, 80, CV_8UC3);
  cv::RNG(2).fill(noise, cv::RNG::UNIFORM, 0, 255);
  const std::map<std::string, std::vector<int>> kinds = {
      {"plain", {}},
      {"progressive", {cv::IMWRITE_JPEG_PROGRESSIVE, 1}},
      {"restarts", {cv::IMWRITE_JPEG_RST_INTERVAL, 3}}};
  for (const auto& [name, parameters] : kinds) {
    const std::string path = (dir_ / "b.jpg").string();
    ASSERT_TRUE(cv::imwrite(path, noise, parameters));
    std::ifstream in(path, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    for (const size_t missing : {1, 2}) {
      const auto complaint = Check(whole.substr(0, whole.size() - missing));
      ASSERT_TRUE(complaint) << name;
      EXPECT_THAT(complaint->text, HasSubstr("lacks the end marker")) << name;
      EXPECT_FALSE(complaint->is_damage) << name;
      EXPECT_FALSE(complaint->is_truncated) << name;
    }
    for (const size_t size : {whole.size() - 12, whole.size() / 2}) {
      const auto complaint = Check(whole.substr(0, size));
      ASSERT_TRUE(complaint) << name;
      EXPECT_TRUE(complaint->is_truncated) << name << " " << size;
    }
  }
  const std::string path = dir_.WriteFile("c.jpg", whole_.substr(0, whole_.size() - 2));
  EXPECT_EQ(CheckImage(path, -1).size, (ImageSize{300, 200}));
  EXPECT_EQ(ReadImage(path).width, 300);
  EXPECT_THAT(Check(whole_.substr(0, whole_.size() - 2) + std::string(50, '\0'))->text,
              HasSubstr("lacks the end marker"));
}

TEST_F(JpegCheck, DamageIsFound) {
  const size_t middle = whole_.size() / 2;
  std::string zeroed = whole_;
  zeroed.replace(middle, 4000, std::string(4000, '\0'));
  std::string garbage = whole_;
  for (size_t i = 0; i < 4000; ++i) garbage[middle + i] = static_cast<char>(i * i * 7 + i / 3);
  std::string false_marker = whole_;
  false_marker.replace(middle, 2, "\xFF\x33");
  const std::string cut = whole_.substr(0, middle) + kEnd;
  std::string missing = whole_;
  missing.erase(middle, 1000);
  const std::map<std::string, std::string> damaged = {{"zeroed", zeroed},
                                                      {"garbage", garbage},
                                                      {"false marker", false_marker},
                                                      {"cut", cut},
                                                      {"missing", missing}};
  for (const auto& [name, content] : damaged) {
    const auto complaint = Check(content);
    ASSERT_TRUE(complaint) << name;
    EXPECT_TRUE(complaint->is_damage) << name;
  }
  EXPECT_THAT(Check(cut)->text, HasSubstr("Corrupt JPEG data"));
}

// Wherever it begins and however long it is: the decoder may take zeros for codes and meet neither
// an impossible one nor the end too early.
TEST_F(JpegCheck, ZeroedCodesAreFound) {
  for (size_t begin = 2000; begin < whole_.size() - 6000; begin += 997) {
    for (const size_t size : {512, 513, 1500, 4096}) {
      std::string zeroed = whole_;
      zeroed.replace(begin, size, std::string(size, '\0'));
      const auto complaint = Check(zeroed);
      ASSERT_TRUE(complaint) << begin << " " << size;
      EXPECT_TRUE(complaint->is_damage) << begin << " " << size;
    }
  }
  std::string to_the_end = whole_;
  to_the_end.replace(10'000, whole_.size() - 10'002, std::string(whole_.size() - 10'002, '\0'));
  const auto complaint = Check(to_the_end);
  ASSERT_TRUE(complaint);
  EXPECT_TRUE(complaint->is_damage);
}

// In one color, whose codes may be zeros.
TEST_F(JpegCheck, FlatPicturesAreFine) {
  for (const int optimize : {0, 1}) {
    const std::string path = (dir_ / "flat.jpg").string();
    for (const cv::Scalar& color :
         {cv::Scalar(0, 0, 0), cv::Scalar(255, 255, 255), cv::Scalar(9, 99, 199)}) {
      ASSERT_TRUE(cv::imwrite(path, cv::Mat(800, 800, CV_8UC3, color),
                              {cv::IMWRITE_JPEG_OPTIMIZE, optimize}));
      EXPECT_FALSE(CheckJpeg(path));
    }
  }
}

// libjpeg looks up tables by numbers that it checks only later.
TEST_F(JpegCheck, TablesThatDoNotExistAreDamage) {
  const size_t scan = whole_.find("\xFF\xDA");
  ASSERT_NE(scan, std::string::npos);
  for (int table = 0; table < 16; ++table) {
    std::string other_table = whole_;
    other_table[scan + 6] = static_cast<char>(table);
    const auto complaint = Check(other_table);
    EXPECT_TRUE(table == 0 || (complaint && complaint->is_damage)) << table;
  }
}

// libjpeg then reads an end marker of its own, which is not in the file.
TEST_F(JpegCheck, ACutScanIsDamage) {
  const std::string start = whole_.substr(0, whole_.size() - 2);
  for (const std::string& cut :
       {whole_.substr(0, whole_.size() / 2), start + std::string(100'000, 'x')}) {
    const auto complaint = Check(cut);
    ASSERT_TRUE(complaint);
    EXPECT_TRUE(complaint->is_damage);
    EXPECT_THAT(complaint->text, Not(HasSubstr("zero bytes")));
  }
}

TEST_F(JpegCheck, OtherWarningsAreNoDamage) {
  std::string unknown_version = whole_;
  ASSERT_EQ(whole_.substr(6, 4), "JFIF");
  unknown_version[11] = 7;
  const auto complaint = Check(unknown_version);
  ASSERT_TRUE(complaint);
  EXPECT_FALSE(complaint->is_damage);
  EXPECT_THAT(complaint->text, HasSubstr("JFIF"));
}

TEST_F(JpegCheck, AMissingHeaderIsAnError) {
  EXPECT_THAT(ErrorText<IoError>([&] { Check("\xFF\xD8 nothing"); }),
              HasSubstr("a.jpg: cannot be decoded: "));
}

// OpenCV's pixels to the byte, of color and of gray, whole and reduced.
TEST_F(JpegCheck, PixelsAreThoseOfOpenCv) {
  const std::string path = dir_.WriteFile("a.jpg", whole_);
  const std::string gray = (dir_ / "gray.jpg").string();
  ASSERT_TRUE(cv::imwrite(gray, cv::imread(path, cv::IMREAD_GRAYSCALE)));
  for (const std::string& file : {path, gray}) {
    for (const int reduction : {1, 2, 4, 8}) {
      const cv::Mat expected =
          cv::imread(file, cv::IMREAD_ANYCOLOR | (reduction == 1 ? 0 : 8 * reduction));
      const auto pixels = DecodeJpeg(file, reduction);
      ASSERT_TRUE(pixels) << file;
      cv::Mat image(pixels->height, pixels->width, CV_8UC(pixels->channels),
                    const_cast<unsigned char*>(pixels->data.data()));
      if (pixels->channels == 3) cv::cvtColor(image, image, cv::COLOR_RGB2BGR);
      EXPECT_EQ(cv::norm(image, expected, cv::NORM_INF), 0) << file << " " << reduction;
    }
  }
  EXPECT_FALSE(DecodeJpeg(dir_.WriteFile("a.txt", "no JPEG"), 1));
}

TEST_F(JpegCheck, DecodingPrintsNothing) {
  std::string unknown_version = whole_;
  unknown_version[11] = 7;
  const std::string path = dir_.WriteFile("a.jpg", unknown_version);
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(ReadImage(path).width, 300);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace limn::colmap_ext
