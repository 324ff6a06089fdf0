// SPDX-License-Identifier: BSD-3-Clause
// The plug-in limn_step: STEP files, by OpenCASCADE.
#include <boost/dll/alias.hpp>

#include "limn/formats/step/step_drawing_writer.h"

BOOST_DLL_ALIAS(limn::WriteDrawingStep, limn_write_step)
