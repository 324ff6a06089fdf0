// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/kind_on_surface.h"

namespace limn {
namespace {

// A surface that bends by more has a crease. Depths are smooth across creases, so that folds are
// measured too small.
constexpr double kCreaseDeg = 25;
// Shares of the length that were right on the sample scene with its depth maps.
constexpr double kBoundaryConfidence = 0.95;
constexpr double kCreaseConfidence = 0.7;
constexpr double kFlatConfidence = 0.6;

void Set(LinkKind kind, double confidence, DrawingLink* link) {
  link->kind = kind;
  link->kind_confidence = confidence;
}

}  // namespace

void UseSurfaceForKind(DrawingLink* link) {
  if (!link->dense || link->dense->behind_surface || !link->IsAlongEdgels()) return;
  const double fold_deg = link->dense->fold_deg;
  if (link->dense->dense_class == DenseClass::kBoundary) {
    Set(LinkKind::kEdge, kBoundaryConfidence, link);
  } else if (link->dense->dense_class == DenseClass::kSurface && fold_deg >= 0) {
    if (fold_deg > kCreaseDeg && link->kind == LinkKind::kUnknown) {
      Set(LinkKind::kEdge, kCreaseConfidence, link);
    } else if (fold_deg <= kCreaseDeg && link->kind == LinkKind::kEdge) {
      Set(LinkKind::kShadow, kFlatConfidence, link);
    }
  }
}

}  // namespace limn
