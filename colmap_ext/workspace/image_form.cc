// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/image_form.h"

namespace limn::colmap_ext {

std::string KeyOf(const ImageForm& form) {
  std::string key;
  if (form.orientation != 1) key += "\nturned " + std::to_string(form.orientation);
  if (form.range) {
    key += "\nlevels " + std::to_string(form.range->low) + " " + std::to_string(form.range->high);
  }
  if (form.has_mask) key += "\nalpha";
  return key;
}

}  // namespace limn::colmap_ext
