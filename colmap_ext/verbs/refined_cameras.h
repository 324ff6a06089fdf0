// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "colmap_ext/host/job.h"
#include "colmap_ext/host/project.h"
#include "limn/cameras/row_motion.h"
#include "limn/pipeline/pipeline_input.h"
#include "limn/pipeline/pipeline_options.h"

namespace limn::colmap_ext {

// Why the cameras of a job cannot be refined; empty if they can.
std::string WhyCamerasStay(const Job& job);

// Whether they are; says why not if they could be off. Throws OptionError if it is on and not
// possible.
CameraRefinement CameraRefinementOf(const Job& job);

// Says what has become of the cameras of the set, none = left as they are.
void SayCameras(const std::optional<RefinedCameras>& cameras, const ViewSet& set,
                CameraRefinement how, Console* console);

// From pixels of the views to those of the images.
void ToImagePixels(const ViewSet& set, RefinedCameras* cameras);
void ToImagePixels(const ViewSet& set, RowMotion* rows);
void ToImagePixels(const ViewSet& set, FitToGiven* fit);

// Says that rows of the images were exposed one after the other, if they were.
void SayRows(const RowMotion& rows, Console* console);

// How well a drawing fits the given cameras although they were refined.
void SayFitToGiven(const FitToGiven& fit, Console* console);

// Warns if there are dense results, which were made with other cameras than these. Call it before
// WriteRefinedModel.
void WarnOfDense(const Project& project, const RefinedCameras& cameras, Console* console);

// Whether the model that is read is the one that refined cameras are written to.
bool ReadsRefinedFolder(const WorkspaceLayout& layout);

// Call it before the work: throws IoError if curves/cameras.csv must not be replaced, nor, if
// cameras are refined in any case, the files in refined/, beside the drawing.
void CheckRefinedFolder(const Project& project, const RunOptions& options);

// Writes refined/, in the flavor of the input model: that model with refined poses, parameters of
// cameras and points (see ApplyRefinement), and, if it has some, rigs and frames with poses that go
// with these; and curves/cameras.csv. Call it before the drawing is written, so that no drawing
// lacks its cameras. Returns DrawingMetadata::refined_cameras: also without refined cameras, if
// refined/ is the model that is read.
std::string WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                              Console* console);

// Writes the model as it is to refined/, whose cameras need no refinement.
void WriteGivenModel(const Project& project, Console* console);

// The name of the refined cameras that drawing.json fits; empty if there is no such drawing.
std::string CamerasOfDrawing(const Project& project);

// The same of drawing.json, or else of the sketch of this name (SketchFileName): a drawing may fit
// the given cameras although they were refined.
std::string CamerasOfResults(const Project& project, const std::string& sketch);

// Call it when the drawing is written, with the names of the refined cameras that the results it
// replaced fitted and that it was made with: unless there are such now, removes those. Warns of
// files in refined/ that are not limn's.
void RemoveOtherCameras(const Project& project, const std::string& replaced,
                        const std::string& present, Console* console);

}  // namespace limn::colmap_ext
