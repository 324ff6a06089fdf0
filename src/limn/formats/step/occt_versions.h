// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What differs between OpenCASCADE before 7.8 and since: factors of units and the model are
// arguments instead of global state.

#include <STEPConstruct_Part.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <StepBasic_ApplicationContext.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#if __has_include(<StepData_Factors.hxx>)
#include <StepData_Factors.hxx>
#define LIMN_STEP_HAS_FACTORS
#endif

namespace limn {

// A maker of entities (GeomToStep_MakeCurve, ...) of millimeters and radians.
template <typename Maker, typename... Arguments>
Maker MadeBy(const Arguments&... arguments) {
#ifdef LIMN_STEP_HAS_FACTORS
  return Maker(arguments..., StepData_Factors());
#else
  return Maker(arguments...);
#endif
}

// Millimeters and radians. Distances below `uncertainty_mm` mean nothing.
inline STEPConstruct_UnitContext StepUnits(
    double uncertainty_mm, [[maybe_unused]] const opencascade::handle<StepData_StepModel>& model) {
  STEPConstruct_UnitContext units;
#ifdef LIMN_STEP_HAS_FACTORS
  units.Init(uncertainty_mm, model, StepData_Factors());
#else
  units.Init(uncertainty_mm);
#endif
  return units;
}

// A product of the model that is shaped like the representation.
inline STEPConstruct_Part StepPart(
    const opencascade::handle<StepShape_ShapeRepresentation>& representation,
    const opencascade::handle<TCollection_HAsciiString>& name,
    const opencascade::handle<StepBasic_ApplicationContext>& context,
    [[maybe_unused]] opencascade::handle<StepData_StepModel> model) {
  STEPConstruct_Part part;
#ifdef LIMN_STEP_HAS_FACTORS
  part.MakeSDR(representation, name, context, model);
#else
  part.MakeSDR(representation, name, context);
#endif
  return part;
}

}  // namespace limn
