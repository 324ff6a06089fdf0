#pragma once

namespace limn {

// What is known of a link when it has been judged (algorithm/belief.md#confidence).
struct LinkFacts {
  // Of the images and of its sigma, natural logarithm.
  double evidence = 0;
  double showing_views = 0;
  // Ends that meet nothing.
  int num_free = 0;
};

// Of links with this evidence, hardly one is false where the cameras are right. The share of them
// in the length of a drawing tells whether they are.
constexpr double kSureLinkEvidence = 11;

// Probability that a link is right: that the curve it draws exists within 2 px of it. `sure_share`
// is that of the length of all links of the drawing with evidence of kSureLinkEvidence: 0 where the
// cameras are those of other images. Ours: a logistic regression on scenes with truth.
double ConfidenceOf(const LinkFacts& facts, double sure_share);

}  // namespace limn
