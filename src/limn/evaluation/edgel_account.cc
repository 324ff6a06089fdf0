// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/edgel_account.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "limn/support/edgel_index.h"
#include "limn/support/edgel_residual.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr double kReachPx = 1.5;
const double kAlongCosine = std::cos(20 * kDeg);
constexpr double kStepPx = 1;

// Mark the edgels of one view that a piece of a link projects onto.
void ExplainAlong(const View& view, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  const EdgeMap& edge_map, const EdgelIndex& index, std::vector<EdgelFate>* fates) {
  const auto direction = ProjectedDirection(view, from, to - from);
  const auto a = view.Project(from);
  const auto b = view.Project(to);
  if (!direction || !a || !b) return;
  const int count = static_cast<int>(std::ceil((*b - *a).norm() / kStepPx));
  for (int i = 0; i <= count; ++i) {
    const Eigen::Vector2d pixel = *a + (*b - *a) * (count > 0 ? i / double(count) : 0);
    index.ForEachWithin(pixel, kReachPx, [&](EdgelId id) {
      EdgelFate& fate = (*fates)[id];
      if (fate == EdgelFate::kDrawn) return;
      if (std::abs(direction->dot(edge_map.edgels[id].Tangent())) < kAlongCosine) return;
      fate = EdgelFate::kExplained;
    });
  }
}

using FateCounts = std::array<int64_t, kNumEdgelFates>;

// Quoted for CSV.
std::string CsvText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void WriteRow(const std::string& name, const FateCounts& counts, std::ostream& out) {
  out << name;
  for (const int64_t count : counts) out << ',' << count;
  out << '\n';
}

}  // namespace

EdgelFates AccountEdgels(const AccountInput& input, const RunContext& context) {
  EdgelFates fates = input.sketch_fates;
  for (size_t c = 0; c < input.sketch.curves.size(); ++c) {
    const CurveAnchor& anchor = input.sketch.curves[c].anchor;
    const auto& ids = input.scene.curves[anchor.view].fragments[anchor.fragment].edgel_ids;
    const std::vector<EdgelFate>& of_samples = input.sample_fates[c];
    // A sample stands for the edgels up to the next one. Behind the last the sketch goes on as far
    // as its fates say.
    for (size_t s = 0; s < of_samples.size(); ++s) {
      for (int k = 0; k < anchor.step; ++k) {
        const size_t vertex = (anchor.VertexOf(s, ids.size()) + k) % ids.size();
        EdgelFate& fate = fates[anchor.view][ids[vertex]];
        if (k > 0 && fate != EdgelFate::kSketched) break;
        fate = of_samples[s];
      }
    }
  }
  ParallelFor(context, "account", input.scene.views.size(), [&](size_t v) {
    const EdgeMap& edge_map = input.scene.curves[v].edge_map;
    const EdgelIndex index(edge_map, LinkedEdgels(input.scene.curves[v]));
    for (const DrawingLink& link : input.graph.links) {
      if (!std::binary_search(link.supporting_views.begin(), link.supporting_views.end(),
                              static_cast<ViewId>(v))) {
        continue;
      }
      for (size_t i = 0; i + 1 < link.points_in_world.size(); ++i) {
        ExplainAlong(input.scene.views[v], link.points_in_world[i], link.points_in_world[i + 1],
                     edge_map, index, &fates[v]);
      }
    }
  });
  return fates;
}

void WriteAccountCsv(const std::vector<View>& views, const EdgelFates& fates, std::ostream& out) {
  out << "view";
  for (int i = 0; i < kNumEdgelFates; ++i) {
    out << ',' << EdgelFateName(static_cast<EdgelFate>(i));
  }
  out << '\n';
  FateCounts all{};
  for (size_t v = 0; v < views.size(); ++v) {
    FateCounts of_view{};
    for (const EdgelFate fate : fates[v]) ++of_view[static_cast<int>(fate)];
    for (int i = 0; i < kNumEdgelFates; ++i) all[i] += of_view[i];
    WriteRow(CsvText(views[v].name), of_view, out);
  }
  WriteRow("all", all, out);
}

}  // namespace limn
