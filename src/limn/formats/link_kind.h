// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"

namespace limn {

// Names of link kinds in files.

// "line", "arc", "circle", "spline", or "polyline" where the link has no primitive.
inline const char* PrimitiveName(const DrawingLink& link) {
  return link.primitive ? ShapeName(link.primitive->shape) : "polyline";
}

inline DenseClass ClassOf(const DrawingLink& link) {
  return link.dense ? link.dense->dense_class : DenseClass::kUnknown;
}

// Whether the kind of edge is known for any link.
inline bool HasKinds(const DrawingGraph& graph) {
  for (const DrawingLink& link : graph.links) {
    if (link.kind != LinkKind::kUnknown || link.tentative) return true;
  }
  return false;
}

inline bool HasRods(const DrawingGraph& graph) {
  for (const DrawingLink& link : graph.links) {
    if (link.kind == LinkKind::kRod) return true;
  }
  return false;
}

}  // namespace limn
