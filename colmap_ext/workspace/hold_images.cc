// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/hold_images.h"

#include <set>
#include <vector>

#include "colmap_ext/workspace/listed_images.h"
#include "limn/util/errors.h"
#include "limn/util/name_list.h"

namespace limn::colmap_ext {
namespace {

void CheckRegistered(const ListedImages& listed, const SparseModel& model,
                     const std::string& list_path) {
  const std::string option = "hold_images = " + list_path + ": ";
  if (!listed.unknown.empty()) {
    const std::string folder = model.folder.empty() ? "the model" : model.folder.string();
    throw OptionError(option + "image \"" + listed.unknown + "\" is not registered in " + folder +
                      ": correct its name, or remove it from the list");
  }
  if (listed.names.empty()) {
    throw OptionError(option + "names no image: name some, or leave it out");
  }
}

}  // namespace

void HoldImages(const SparseModel& model, const std::string& list_path, ViewSet* set) {
  const ListedImages listed = ReadListedImages(list_path, model);
  CheckRegistered(listed, model, list_path);
  const std::set<std::string>& names = listed.names;
  std::set<std::string> unused = names;
  for (size_t v = 0; v < set->views.size(); ++v) {
    if (!names.contains(set->files[v].image_name)) continue;
    set->mounts.held[set->mounts.of_view[v].body] = 1;
    unused.erase(set->files[v].image_name);
  }
  if (unused.empty()) return;
  set->warnings.push_back("hold_images: " + std::to_string(unused.size()) +
                          " images of the list are not in use and hold nothing: " +
                          ListNames({unused.begin(), unused.end()}));
}

}  // namespace limn::colmap_ext
