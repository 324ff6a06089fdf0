// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/plan_options.h"

#include <cmath>

#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn::colmap_ext {

namespace {
constexpr double kLargest = 1e9;
}  // namespace

void PlanOptions::AddOptions(OptionParser* parser) {
  parser->AddOption("depth_before", &depth_before,
                    "SVG and DXF along a face: depth shown in front of it, -1 = unlimited");
  parser->AddOption("depth_behind", &depth_behind,
                    "SVG and DXF along a face: depth shown behind it, -1 = unlimited");
  parser->AddOption("section", &section,
                    BasicOption("SVG and DXF: a plan, with faces cut at this height in the aligned "
                                "world"));
  parser->AddOption("section_below", &section_below, "SVG and DXF: in plans also what is below");
  parser->AddOption("section_gap", &section_gap,
                    "SVG and DXF: in plans the largest gap between faces that is closed, -1 = "
                    "about 4 px of the photographs");
}

void PlanOptions::Check() const {
  LIMN_CHECK_RANGE_OR(depth_before, -1, >= 0, <= 1e9);
  LIMN_CHECK_RANGE_OR(depth_behind, -1, >= 0, <= 1e9);
  LIMN_CHECK_RANGE_OR(section_gap, -1, >= 0, <= 1e9);
  SectionHeight();  // throws
}

std::optional<double> PlanOptions::SectionHeight() const {
  if (section.empty()) return std::nullopt;
  const auto height = ParseNumber<double>(section);
  if (!height || !(std::abs(*height) <= kLargest)) {
    throw OptionError("section = " + section + ": must be a number from -1e9 to 1e9");
  }
  return height;
}

}  // namespace limn::colmap_ext
