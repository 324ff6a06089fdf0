// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/edgel_fate.h"

#include <array>

namespace limn {

const char* EdgelFateName(EdgelFate fate) {
  static constexpr std::array<const char*, kNumEdgelFates> kNames = {
      "not linked",
      "in dense texture",
      "view only confirms",
      "fragment too short",
      "no partner in another view",
      "too few supporting views",
      "depth inconsistent along the curve",
      "piece too short",
      "sketched",
      "support lost after re-triangulation",
      "on no traced curve",
      "in a doubtful link",
      "in a link too short or covered",
      "drawn",
      "explained by the drawing"};
  return kNames[static_cast<int>(fate)];
}

}  // namespace limn
