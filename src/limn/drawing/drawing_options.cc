// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/drawing_options.h"

#include "limn/util/errors.h"

namespace limn {

void DrawingOptions::Check() const {
  CheckFields(*this);
  LIMN_CHECK_OPTION(max_supporting_views, >= min_supporting_views);
}

}  // namespace limn
