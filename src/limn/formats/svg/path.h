// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Core>

namespace limn {

// RoundedText without the zero before the point: "-.5".
std::string SvgNumber(double value, int decimals);

// Number of decimals at which rounding errors are at most `largest_error` > 0.
int DecimalsFor(double largest_error);

// Text for an element or an attribute in double quotes.
std::string XmlEscaped(const std::string& text);

// The `d` attribute of a path, in relative commands. Writes differences of rounded positions, so
// that rounding errors do not accumulate.
class SvgPath {
 public:
  explicit SvgPath(int decimals);

  void MoveTo(const Eigen::Vector2d& point);
  void LineTo(const Eigen::Vector2d& point);
  void CubicTo(const Eigen::Vector2d& first, const Eigen::Vector2d& second,
               const Eigen::Vector2d& point);
  // Along an ellipse with these radii whose first axis is rotated by `rotation_deg`; less than half
  // a turn.
  void ArcTo(const Eigen::Vector2d& radii, double rotation_deg, bool positive_turn,
             const Eigen::Vector2d& point);

  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }

 private:
  Eigen::Matrix<long long, 2, 1> Rounded(const Eigen::Vector2d& point) const;
  void PutCommand(char command);
  void PutText(const std::string& number);
  // Writes a rounded position relative to the last one.
  void PutOffset(const Eigen::Vector2d& point);

  int decimals_;
  double steps_;
  std::string text_;
  char last_command_ = 0;
  Eigen::Matrix<long long, 2, 1> at_ = {0, 0};
};

}  // namespace limn
