// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/paper_options.h"

#include "limn/util/errors.h"

namespace limn {

void PaperOptions::Check() const {
  CheckFields(*this);
  LIMN_CHECK_OPTION(strong_link_views, >= dense_link_views);
}

}  // namespace limn
