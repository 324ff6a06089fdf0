// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/geometry/pinhole_camera.h"
#include "limn/model/link_selection.h"
#include "limn/model/view.h"
#include "limn/viewer/viewer_scene.h"

namespace limn {

// A photograph in a page.
struct PagePhoto {
  std::string name;
  PinholeCamera camera;
  // Its box alone.
  ImageRegion region;
  ViewerThumbnail thumbnail;
};

// What of a page can go into another one of the same views.
struct StoredPage {
  DrawingStamp drawing;
  Detail detail = Detail::kNormal;
  // As in ViewerScene; empty if there are none.
  std::string report_json;
  std::string settings_json;
  // Those with a picture.
  std::vector<PagePhoto> photos;
  // In the coordinates of drawing.json.
  std::vector<ViewerPoint> cloud;
};

// Reads a page that WriteViewerPage wrote, also an earlier version of it. Needs memory for the file
// and what it unpacks to, less than 1 GB. Throws IoError for other, larger or damaged files.
StoredPage ReadViewerPage(const std::string& path);

}  // namespace limn
