// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/primitives/primitive_options.h"
#include "limn/primitives/shape_fit.h"

namespace limn {

// A shape and the quality of its fit.
struct FittedShape {
  CurveShape shape;
  double rms_px = 0;
  double max_px = 0;
  // Bayes' information criterion; smaller is better.
  double criterion = 0;
};

// The simplest shape that explains a link (algorithm/primitives.md#choice); if none is within the
// tolerance, the nearest spline.
FittedShape ChooseShape(const LinkSamples& link, const EndConditions& ends, bool closed,
                        const PrimitiveOptions& options);

// Evaluates a shape with this many free parameters.
FittedShape Judge(const CurveShape& shape, int num_parameters, const LinkSamples& link,
                  const PrimitiveOptions& options);

// Number of free parameters of a spline with so many control points and these ends.
int NumParameters(int num_points, const EndConditions& ends, bool closed);

}  // namespace limn
