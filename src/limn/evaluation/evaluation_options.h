// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

namespace limn {

struct EvaluationOptions {
  // Distances up to which a curve counts as found, in world units or pixel footprints; one row
  // each.
  std::vector<double> taus;
  // Only samples inside count; distances are to all of the other set. None: everything counts.
  std::optional<Eigen::AlignedBox3d> region;
  // Reconstructed samples and junctions nearer than this many taus to a don't-care curve are
  // ignored. Raising it forgives more.
  double dont_care_taus = 2.0;
  // A junction is found if the other set has one nearer than this many taus.
  double junction_taus = 2.0;
  // True chains of at least this many taus count for links per chain, and links that cover at least
  // cover_taus of one. 20 and 5 footprints at a tau of 2.
  double chain_taus = 10.0;
  double cover_taus = 2.5;
  // Whether to compute the duplicated share, which takes most of the time in sets with many copies.
  bool find_duplicates = true;

  void Check() const;
};

}  // namespace limn
