// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

struct BeliefOptions {
  // Otherwise all links are believed.
  bool judge = true;
  double min_evidence = 6;
  double min_tri_angle_deg = 2;

  // A link with a free end is doubted if less than this share of its edgels is explained by no
  // better link. Set by tests only.
  double min_own_share = 0.2;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("judge", self.judge, OnOrOff(), "mark links that the images do not support as tentative");
    visit("min_evidence", self.min_evidence, Between(0, 1e6),
          "evidence against chance that a link without neighbors needs, natural logarithm");
    visit("min_tri_angle_deg", self.min_tri_angle_deg, Between(0, 90),
          "angle that the views of a link must span to measure its depth, deg");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
