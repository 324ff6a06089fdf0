// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/views_of_drawing.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "limn/util/errors.h"

namespace limn::colmap_ext {

DrawingGraph WithViewsOf(const SparseModel& model, const std::vector<View>& views,
                         DrawingFile drawing) {
  std::map<std::string, ViewId> view_of_name;
  for (size_t v = 0; v < views.size(); ++v) {
    view_of_name.emplace(views[v].name, static_cast<ViewId>(v));
  }
  std::set<std::string> names_in_model;
  for (const ModelImage& image : model.images) names_in_model.insert(image.name);

  std::vector<std::optional<ViewId>> found;
  for (const std::string& name : drawing.metadata.view_names) {
    const auto view = view_of_name.find(name);
    if (view != view_of_name.end()) {
      found.push_back(view->second);
    } else if (names_in_model.contains(name)) {
      found.push_back(std::nullopt);
    } else {
      throw IoError(model.folder.string(),
                    "the model has no image " + name + ", which the drawing has");
    }
  }
  for (DrawingLink& link : drawing.graph.links) {
    std::vector<ViewId> supporting;
    for (const ViewId id : link.supporting_views) {
      if (found.at(id)) supporting.push_back(*found[id]);
    }
    std::sort(supporting.begin(), supporting.end());
    link.supporting_views = std::move(supporting);
  }
  return std::move(drawing.graph);
}

}  // namespace limn::colmap_ext
