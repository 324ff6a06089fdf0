// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/viewer_page.h"

#include <ostream>

#include "limn/util/errors.h"
#include "limn/viewer/packing.h"
#include "limn/viewer/page_text.h"
#include "limn/viewer/payload.h"

namespace limn {

bool HasViewerPage() { return !kPageHead.empty(); }

void WriteViewerPage(const ViewerScene& scene, std::ostream& out) {
  if (!HasViewerPage()) {
    throw InputError("this limn was built without the viewer (CMake option LIMN_WITH_VIEWER)");
  }
  out << kPageHead << Base64(Gzip(EncodePayload(scene))) << kPageTail;
}

}  // namespace limn
