#include "limn/tiles/tile_options.h"

#include "limn/util/errors.h"

namespace limn {

void TileOptions::Check() const {
  CheckOption(max_views == 0 || max_views >= 4, "max_views", max_views, "0 or >= 4");
  LIMN_CHECK_OPTION(reach_px, >= 20);
}

}  // namespace limn
