#pragma once

#include "limn/primitives/primitive_options.h"
#include "limn/primitives/shape_fit.h"

namespace limn {

// A shape with how well it does.
struct FittedShape {
  CurveShape shape;
  double rms_px = 0;
  double max_px = 0;
  // Bayes' information criterion; smaller is better.
  double criterion = 0;
};

// The simplest shape that explains a link, by the rules of FitPrimitives; if none does within the
// tolerance, the spline that comes nearest.
FittedShape ChooseShape(const LinkSamples& link, const EndConditions& ends, bool closed,
                        const PrimitiveOptions& options);

// Judges a shape with so many free numbers.
FittedShape Judge(const CurveShape& shape, int num_parameters, const LinkSamples& link,
                  const PrimitiveOptions& options);

// Of a spline with these ends.
int NumParameters(const CubicBSpline& spline, const EndConditions& ends, bool closed);

}  // namespace limn
