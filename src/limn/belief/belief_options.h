#pragma once

namespace limn {

struct BeliefOptions {
  // Whether links are judged; otherwise all are believed.
  bool judge = true;
  // Evidence against chance, a natural logarithm, that a link without a neighbor needs, and what
  // each end that meets another link counts instead.
  double min_evidence = 6;
  double joined_end_evidence = 5;
  // Views that must see other links through a link before it is doubted.
  int min_contradicting_views = 2;
  // Share of its edgels that no better link explains, below which a link with a free end is
  // doubted.
  double min_own_share = 0.2;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
