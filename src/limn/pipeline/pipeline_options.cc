// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/pipeline_options.h"

#include <string_view>

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

// Of high quality and of the paper's method, which may take longer.
constexpr int kManyPrimaryViews = 20;

template <typename Options>
Json FieldsAsJson(const Options& options) {
  Json json = Json::object();
  Options::VisitFields(options, [&](const char* name, const auto& value, const OptionValues& values,
                                    const OptionHelp&) {
    if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>) {
      json[name] = WordOf(value, values);
    } else {
      json[name] = value;
    }
  });
  return json;
}

template <typename Options>
std::string FieldsAsText(const Options& options) {
  const Json fields = FieldsAsJson(options);
  std::string text;
  for (const auto& [name, value] : fields.items()) {
    text += name + "=" + value.dump() + "\n";
  }
  return text;
}

}  // namespace

void PipelineOptions::Check() const {
  VisitGroups(*this, [](const char* group, const auto& options) { CheckGroup(group, options); });
  if (IsPaper() && refine_cameras == CameraRefinement::kOn) {
    throw OptionError("refine_cameras = 1: Drawing.method paper draws with the cameras as given");
  }
  if (output_cameras == OutputCameras::kRefined) return;
  if (refine_cameras == CameraRefinement::kOff) {
    throw OptionError(
        "output_cameras = given: no camera is refined: needs refine_cameras = 1 or auto");
  }
  if (refinement.num_rounds == 0) {
    throw OptionError("output_cameras = given: needs DrawingRefinement.num_rounds of 1 or more");
  }
}

QualityPreset PresetOf(Quality quality) {
  QualityPreset preset;
  ViewSelectionOptions& views = preset.options.sketch.view_selection;
  switch (quality) {
    case Quality::kLow:
      preset.max_image_size = 1000;
      views.max_second_views = 6;
      views.max_confirmation_views = 16;
      break;
    case Quality::kMedium:
      preset.max_scale = 1.5;
      preset.max_image_size = 2048;
      break;
    case Quality::kHigh:
      preset.max_scale = 2;
      views.max_second_views = 20;
      views.max_confirmation_views = 32;
      views.enough_primary_views = kManyPrimaryViews;
      break;
  }
  return preset;
}

void SetMethodDefaults(DrawingMethod method, PipelineOptions* options) {
  options->method = method;
  if (!options->IsPaper()) return;
  options->sketch.averaging = DepthAveraging::kPaper;
  options->sketch.min_supporting_views = 6;
  options->sketch.view_selection.enough_primary_views = kManyPrimaryViews;
}

const char* DrawingMethodName(DrawingMethod method) {
  return method == DrawingMethod::kPaper ? "paper" : "traced";
}

std::string OptionsAsJson(const PipelineOptions& options) {
  Json json = {{"mode", SketchModeName(options.mode)}, {"regularize", options.regularize}};
  VisitGroups(options, [&](const char* group, const auto& fields) {
    const bool is_drawing = std::string_view(group) == "Drawing";
    if (is_drawing) json[group]["method"] = DrawingMethodName(options.method);
    json[group].update(FieldsAsJson(fields));
  });
  if (!options.IsPaper()) json.erase("Paper");
  return json.dump();
}

std::string OptionsAsJson(const DenseOptions& options) { return FieldsAsJson(options).dump(); }

std::string OptionsAsText(const EdgeDetectionOptions& options) { return FieldsAsText(options); }

std::string OptionsAsText(const RidgeOptions& options) { return FieldsAsText(options); }

std::string OptionsAsText(const LinkingOptions& options) { return FieldsAsText(options); }

std::string OptionsAsText(const ViewSelectionOptions& options) { return FieldsAsText(options); }

std::string OptionsAsText(const SketchOptions& options) { return FieldsAsText(options); }

}  // namespace limn
