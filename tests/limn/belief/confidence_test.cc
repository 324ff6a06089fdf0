#include "limn/belief/confidence.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Confidence, OfASureDrawingAndOfOneByAccident) {
  const LinkFacts usual = {15, 10, 0};
  EXPECT_GT(ConfidenceOf(usual, 0.7), 0.9);
  EXPECT_LT(ConfidenceOf(usual, 0), 0.3);
  const LinkFacts weak = {3, 3, 2};
  EXPECT_LT(ConfidenceOf(weak, 0.7), 0.5);
  EXPECT_LT(ConfidenceOf(weak, 0), 0.05);
}

TEST(Confidence, EveryFactCounts) {
  const LinkFacts facts = {10, 6, 1};
  const double confidence = ConfidenceOf(facts, 0.5);
  EXPECT_GT(ConfidenceOf({12, 6, 1}, 0.5), confidence);
  EXPECT_GT(ConfidenceOf({10, 7, 1}, 0.5), confidence);
  EXPECT_GT(ConfidenceOf({10, 6, 0}, 0.5), confidence);
  EXPECT_GT(ConfidenceOf(facts, 0.6), confidence);
}

TEST(Confidence, StaysAProbability) {
  EXPECT_EQ(ConfidenceOf({1e6, 10, 0}, 0.5), ConfidenceOf({20, 10, 0}, 0.5));
  EXPECT_LE(ConfidenceOf({1e6, 1e3, 0}, 1), 1);
  EXPECT_GE(ConfidenceOf({-1e3, 0, 2}, 0), 0);
}

}  // namespace
}  // namespace limn
