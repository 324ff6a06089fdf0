// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/kind_on_surface.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

LinkKind KindOn(DenseClass dense_class, double fold_deg, LinkKind before, bool behind = false) {
  DrawingLink link;
  link.kind = before;
  link.kind_confidence = before == LinkKind::kUnknown ? 0 : 0.8;
  link.dense.emplace();
  link.dense->dense_class = dense_class;
  link.dense->fold_deg = fold_deg;
  link.dense->behind_surface = behind;
  UseSurfaceForKind(&link);
  EXPECT_EQ(link.kind_confidence > 0, link.kind != LinkKind::kUnknown);
  return link.kind;
}

TEST(KindOnSurfaceTest, EdgesAreWhereTheSurfaceEndsOrFolds) {
  for (const LinkKind before : {LinkKind::kUnknown, LinkKind::kEdge, LinkKind::kShadow}) {
    EXPECT_EQ(KindOn(DenseClass::kBoundary, -1, before), LinkKind::kEdge);
  }
  EXPECT_EQ(KindOn(DenseClass::kSurface, 90, LinkKind::kEdge), LinkKind::kEdge);
  EXPECT_EQ(KindOn(DenseClass::kSurface, 90, LinkKind::kUnknown), LinkKind::kEdge);
}

TEST(KindOnSurfaceTest, OnAFlatSurfaceThereIsNoEdge) {
  EXPECT_EQ(KindOn(DenseClass::kSurface, 3, LinkKind::kEdge), LinkKind::kShadow);
  EXPECT_EQ(KindOn(DenseClass::kSurface, 3, LinkKind::kPaint), LinkKind::kPaint);
  EXPECT_EQ(KindOn(DenseClass::kSurface, -1, LinkKind::kEdge), LinkKind::kEdge);
}

TEST(KindOnSurfaceTest, WhatTheSurfaceDoesNotTellStays) {
  EXPECT_EQ(KindOn(DenseClass::kFree, 3, LinkKind::kEdge), LinkKind::kEdge);
  EXPECT_EQ(KindOn(DenseClass::kBoundary, -1, LinkKind::kContour), LinkKind::kContour);
  EXPECT_EQ(KindOn(DenseClass::kSurface, 3, LinkKind::kEdge, true), LinkKind::kEdge);
  EXPECT_EQ(KindOn(DenseClass::kUnknown, -1, LinkKind::kUnknown), LinkKind::kUnknown);
}

TEST(KindOnSurfaceTest, WithoutASurfaceNothingIsDone) {
  DrawingLink link;
  link.kind = LinkKind::kPaint;
  link.kind_confidence = 0.75;
  UseSurfaceForKind(&link);
  EXPECT_EQ(link.kind, LinkKind::kPaint);
  EXPECT_EQ(link.kind_confidence, 0.75);
}

}  // namespace
}  // namespace limn
