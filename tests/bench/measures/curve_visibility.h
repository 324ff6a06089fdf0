// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "bench/measures/supported_curve.h"
#include "limn/evaluation/curve_samples.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/edge_map.h"
#include "limn/model/view.h"
#include "limn/support/view_edgels.h"
#include "limn/util/parallel.h"

namespace limn {

struct VisibilityOptions {
  // Whether a view sees a sample is inferred from known views whose viewing angle differs by less
  // than this. Raising it judges more of the curves, also where a surface may hide them.
  double max_viewing_angle_deg = 30;
  // One of a curve's supporting views shows a sample if a linked edgel is within this distance
  // across the edge, px, and within this angle.
  double shown_distance_px = 2;
  double shown_angle_deg = 20;

  // Throws OptionError.
  void Check() const;
};

// The predicted edgels of curves in a view, one per sample.
struct ForetoldView {
  std::vector<Edgel> sure;  // surely visible
  EdgeMap possible;         // may be visible, or is surely so
};

// Predicts what a new view sees of curves that were made from other views. No surface is known, so
// it is inferred from the neighboring known views. Surely visible: of all views that have the
// sample in their image, the two with the most similar viewing direction both show it. May be
// visible: any view within max_viewing_angle_deg shows it.
class CurveVisibility {
 public:
  // Samples are a pixel footprint apart: their spacing in a view is about this, px.
  static constexpr double kSpacingPx = 1;

  // The curves' supporting views are those of `views`, and `image_curves` belong to them. All must
  // outlive the object.
  CurveVisibility(const std::vector<SupportedCurve>& curves, const std::vector<View>& views,
                  const std::vector<ImageCurves>& image_curves, const VisibilityOptions& options,
                  const RunContext& context);

  // Time: samples times known views.
  ForetoldView Foretell(const View& view, const RunContext& context) const;

 private:
  enum class Visibility { kNot, kPossible, kSure };

  bool Shows(ViewId view, int sample) const;
  std::vector<ViewId> Beside(const View& view, int sample) const;
  Visibility VisibilityIn(const View& view, int sample) const;

  const std::vector<SupportedCurve>& curves_;
  const std::vector<View>& views_;
  SupportGate gate_;
  double min_cosine_;
  CurveSamples samples_;
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
};

}  // namespace limn
