// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

struct TileOptions {
  // Tiles are drawn one after the other, so that memory does not grow with the scene.
  int max_views = 150;
  // Curves near the border of a tile's core then have their surroundings.
  double reach_px = 200;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("max_views", self.max_views, ZeroOr(Between(4, 1e6)),
          "larger scenes are drawn in tiles of at most this many views, 0 = never");
    visit("reach_px", self.reach_px, Between(20, 1e5), "margin by which tiles overlap, px");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
