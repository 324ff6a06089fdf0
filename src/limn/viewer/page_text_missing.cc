// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/page_text.h"

namespace limn {

const std::string_view kPageHead;
const std::string_view kPageTail;

}  // namespace limn
