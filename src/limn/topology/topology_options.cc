#include "limn/topology/topology_options.h"

#include "limn/util/errors.h"

namespace limn {

void TopologyOptions::Check() const {
  LIMN_CHECK_RANGE(min_traced_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(min_seed_views, >= 1, <= 1e6);
  LIMN_CHECK_OPTION(min_seed_views, >= min_traced_views);
  LIMN_CHECK_RANGE(max_tracing_gap_px, >= 1, <= 1000);
  LIMN_CHECK_RANGE(max_continuation_gap_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(primary_views_share, >= 0, <= 1);
  LIMN_CHECK_RANGE(min_primary_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(max_primary_views, >= 1, <= 1e6);
  LIMN_CHECK_OPTION(max_primary_views, >= min_primary_views);
  LIMN_CHECK_RANGE(own_views_share, >= 0, <= 1);
  LIMN_CHECK_RANGE(min_own_views, >= 0, <= 1e6);
  LIMN_CHECK_RANGE(max_own_views, >= 0, <= 1e6);
  LIMN_CHECK_OPTION(max_own_views, >= min_own_views);
  LIMN_CHECK_RANGE(min_link_length_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(max_junction_gap_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(max_junction_miss_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(min_junction_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(min_junction_angle_deg, >= 0, <= 180);
  LIMN_CHECK_RANGE(max_continuation_angle_deg, >= 0, <= 180);
  LIMN_CHECK_RANGE(covered_share, > 0, <= 1);
  LIMN_CHECK_RANGE(max_short_edge_px, >= 0, <= 1e4);
}

}  // namespace limn
