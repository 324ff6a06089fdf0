#include "limn/tiles/tile_options.h"

#include "limn/util/errors.h"

namespace limn {

void TileOptions::Check() const {
  LIMN_CHECK_RANGE_OR(max_views, 0, >= 4, <= 1e6);
  LIMN_CHECK_RANGE(reach_px, >= 20, <= 1e5);
}

}  // namespace limn
