#pragma once

namespace limn {

struct BeliefOptions {
  // Whether to judge links; otherwise all are kept firm.
  bool judge = true;
  // Evidence against chance that a link without a neighbor needs, as a natural logarithm: 6 means
  // that fewer than one accident in 400 would pass. Each end that meets another link lowers the
  // threshold by joined_end_evidence.
  double min_evidence = 6;
  double joined_end_evidence = 5;
  // Views that must see other links through a link before it is doubted.
  int min_contradicting_views = 2;
  // A link with a free end is doubted if less than this share of its edgels is explained by no
  // better link.
  double min_own_share = 0.2;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
