// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/path.h"

#include <algorithm>
#include <cmath>

#include "limn/util/number_text.h"

namespace limn {

std::string SvgNumber(double value, int decimals) {
  std::string text = RoundedText(value, decimals);
  if (text.starts_with("0.")) text.erase(0, 1);
  if (text.starts_with("-0.")) text.erase(1, 1);
  return text;
}

int DecimalsFor(double largest_error) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(2 * largest_error))), 0, 15);
}

std::string XmlEscaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        // XML has no other control characters.
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n') result += c;
    }
  }
  return result;
}

SvgPath::SvgPath(int decimals) : decimals_(decimals), steps_(std::pow(10.0, decimals)) {}

void SvgPath::MoveTo(const Eigen::Vector2d& point) {
  // A path begins at the origin, so that its first move is one from there.
  PutCommand('m');
  PutOffset(point);
  at_ = Rounded(point);
}

void SvgPath::LineTo(const Eigen::Vector2d& point) {
  PutCommand('l');
  PutOffset(point);
  at_ = Rounded(point);
}

void SvgPath::CubicTo(const Eigen::Vector2d& first, const Eigen::Vector2d& second,
                      const Eigen::Vector2d& point) {
  PutCommand('c');
  PutOffset(first);
  PutOffset(second);
  PutOffset(point);
  at_ = Rounded(point);
}

void SvgPath::ArcTo(const Eigen::Vector2d& radii, double rotation_deg, bool positive_turn,
                    const Eigen::Vector2d& point) {
  // A thousandth of a degree is less than the rounding of places up to radii of 5000 px.
  constexpr int kAngleDecimals = 3;
  PutCommand('a');
  PutText(SvgNumber(radii.x(), decimals_ + 1));
  PutText(SvgNumber(radii.y(), decimals_ + 1));
  PutText(SvgNumber(rotation_deg, kAngleDecimals));
  PutText("0");
  PutText(positive_turn ? "1" : "0");
  PutOffset(point);
  at_ = Rounded(point);
}

Eigen::Matrix<long long, 2, 1> SvgPath::Rounded(const Eigen::Vector2d& point) const {
  return {std::llround(point.x() * steps_), std::llround(point.y() * steps_)};
}

// A letter that repeats the one before may be left out; not that of a move, which would be a line.
void SvgPath::PutCommand(char command) {
  if (command != last_command_ || command == 'm') text_ += command;
  last_command_ = command;
}

void SvgPath::PutText(const std::string& number) {
  const bool after_letter = std::isalpha(static_cast<unsigned char>(text_.back())) != 0;
  if (!after_letter && number.front() != '-') text_ += ' ';
  text_ += number;
}

void SvgPath::PutOffset(const Eigen::Vector2d& point) {
  const Eigen::Matrix<long long, 2, 1> offset = Rounded(point) - at_;
  PutText(SvgNumber(static_cast<double>(offset.x()) / steps_, decimals_));
  PutText(SvgNumber(static_cast<double>(offset.y()) / steps_, decimals_));
}

}  // namespace limn
