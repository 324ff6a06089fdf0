// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/model/link_selection.h"
#include "limn/viewer/page_reader.h"

namespace limn::colmap_ext {

struct PageOptions {
  // "auto" (the first of the others that exists), "dense", "sparse" or "none".
  std::string cloud = "auto";
  int max_points = 200000;
  int thumbnail_size = 1024;
  // Shown at first.
  Detail detail = Detail::kNormal;
  // The coordinates that are shown: by default those of the world, if the drawing is aligned.
  enum class Shown { kAuto, kModel, kWorld };
  Shown shown = Shown::kAuto;

  // Throws OptionError.
  void Check() const;
};

// ViewerScene::settings_json: what the next page of the folder shall have of the options.
// `cloud_source`: where its points are from.
std::string SettingsOf(const PageOptions& options, const std::string& cloud_source);

// The options to make a page anew; what it does not say is as by default. Throws InputError,
// IoError and OptionError.
PageOptions OptionsOf(const StoredPage& page);

// Of its settings; empty if they do not tell. Throws InputError and IoError.
std::string CloudSourceOf(const StoredPage& page);

}  // namespace limn::colmap_ext
