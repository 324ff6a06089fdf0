#include "limn/drawing/link_fitting.h"

#include <algorithm>

#include <Eigen/LU>

#include "limn/drawing/curve_smoothing.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

class LinkFitter {
 public:
  LinkFitter(const SampleSet& samples, const std::vector<int>& agreeing_views,
             const DrawingOptions& options)
      : samples_(samples), agreeing_views_(agreeing_views), options_(options) {}

  void Fit(DrawingLink* link) const {
    for (int k = 0; k < link->size(); ++k) {
      MoveToMean(link->vertices[k], &link->points_in_world[k]);
    }
    Smooth(link);
    for (LinkVertex& vertex : link->vertices) Describe(&vertex);
    for (int k = 0; k < link->size(); ++k) {
      link->sigma[k] = SigmaAcross(link->vertices[k].information, link->vertices[k].footprint);
    }
  }

 private:
  int IdOf(const SketchSample& sample) const {
    return samples_.curve_begin[sample.curve] + sample.sample;
  }

  // Weighted mean, across the curve, of the samples merged into a vertex.
  void MoveToMean(const LinkVertex& vertex, Eigen::Vector3d* position) const {
    if (vertex.samples.empty()) return;
    const Eigen::Vector3d& tangent = samples_.tangent[IdOf(vertex.samples.front())];
    const Eigen::Matrix<double, 3, 2> across = TangentFrame(tangent);
    Eigen::Matrix2d sum = WeakInformation(vertex.footprint) * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const SketchSample& sample : vertex.samples) {
      const int s = IdOf(sample);
      const Eigen::Matrix2d weight = across.transpose() * samples_.information[s] * across;
      sum += weight;
      right += weight * (across.transpose() * (samples_.position[s] - *position));
    }
    *position += across * sum.inverse() * right;
  }

  void Smooth(DrawingLink* link) const {
    // Without the repeated first point of a loop.
    const int count = link->size() - (link->closed ? 1 : 0);
    std::vector<Eigen::Vector3d> position(link->points_in_world.begin(),
                                          link->points_in_world.begin() + count);
    std::vector<Eigen::Vector3d> tangent;
    std::vector<Eigen::Matrix3d> information;
    std::vector<double> footprint;
    for (int k = 0; k < count; ++k) {
      const int before = link->closed ? (k + count - 1) % count : std::max(k - 1, 0);
      const int after = link->closed ? (k + 1) % count : std::min(k + 1, count - 1);
      const Eigen::Vector3d chord = position[after] - position[before];
      tangent.push_back(chord.norm() > 0 ? chord.normalized().eval()
                                         : Eigen::Vector3d::UnitX().eval());
      information.push_back(link->vertices[k].information);
      footprint.push_back(link->vertices[k].footprint);
    }
    link->points_in_world = SmoothCurve({position, tangent, information, footprint, link->closed},
                                        options_.bending_sigma_px, false);
    if (link->closed) link->points_in_world.push_back(link->points_in_world.front());
  }

  void Describe(LinkVertex* vertex) const {
    for (SketchSample& sample : vertex->samples) {
      const int s = IdOf(sample);
      vertex->agreeing_views = std::max(vertex->agreeing_views, agreeing_views_[s]);
      const auto support = samples_.support.Of(s);
      vertex->support.insert(vertex->support.end(), support.begin(), support.end());
      const CurveOrigin& origin = samples_.origins[sample.curve];
      sample = {origin.sketch_curve, origin.begin + sample.sample};
    }
    std::vector<EdgelRef>& all = vertex->support;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  const SampleSet& samples_;
  const std::vector<int>& agreeing_views_;
  const DrawingOptions& options_;
};

// Moves nodes to the mean of their link ends after the fit.
void MoveNodes(DrawingGraph* graph) {
  GraphEditor editor(graph);
  for (NodeId id = 0; id < static_cast<NodeId>(graph->nodes.size()); ++id) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const DrawingNode& node = graph->nodes[id];
    for (const LinkEnd& end : node.incident) sum += EndPoint(graph->links[end.link], end.end);
    editor.MoveNode(id, sum / node.Degree());
  }
}

}  // namespace

void FitLinks(const SampleSet& samples, const std::vector<int>& agreeing_views,
              const DrawingOptions& options, DrawingGraph* graph) {
  const LinkFitter fitter(samples, agreeing_views, options);
  for (DrawingLink& link : graph->links) fitter.Fit(&link);
  MoveNodes(graph);
}

}  // namespace limn
