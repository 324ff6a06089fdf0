#include "limn/topology/topology_options.h"

#include "limn/util/errors.h"

namespace limn {

void TopologyOptions::Check() const {
  LIMN_CHECK_OPTION(min_traced_views, >= 1);
  LIMN_CHECK_OPTION(min_seed_views, >= min_traced_views);
  LIMN_CHECK_OPTION(max_tracing_gap_px, >= 1);
  LIMN_CHECK_OPTION(max_continuation_gap_px, >= 0);
  LIMN_CHECK_OPTION(primary_views_share, >= 0);
  LIMN_CHECK_OPTION(primary_views_share, <= 1);
  LIMN_CHECK_OPTION(min_primary_views, >= 1);
  LIMN_CHECK_OPTION(max_primary_views, >= min_primary_views);
  LIMN_CHECK_OPTION(own_views_share, >= 0);
  LIMN_CHECK_OPTION(own_views_share, <= 1);
  LIMN_CHECK_OPTION(min_own_views, >= 0);
  LIMN_CHECK_OPTION(max_own_views, >= min_own_views);
  LIMN_CHECK_OPTION(min_link_length_px, >= 0);
  LIMN_CHECK_OPTION(max_junction_gap_px, >= 0);
  LIMN_CHECK_OPTION(max_junction_miss_px, >= 0);
  LIMN_CHECK_OPTION(min_junction_views, >= 1);
  LIMN_CHECK_OPTION(min_junction_angle_deg, >= 0);
  LIMN_CHECK_OPTION(max_continuation_angle_deg, >= 0);
  LIMN_CHECK_OPTION(covered_share, > 0);
  LIMN_CHECK_OPTION(covered_share, <= 1);
  LIMN_CHECK_OPTION(max_short_edge_px, >= 0);
}

}  // namespace limn
