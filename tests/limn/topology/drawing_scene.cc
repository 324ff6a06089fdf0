// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/drawing_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "limn/topology/finish_links.h"
#include "limn/topology/graph_fixture.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn::testing {
namespace {

using Eigen::Vector3d;

constexpr double kFocalPx = 600;  // of LookAt

std::vector<ViewId> AllViews() {
  std::vector<ViewId> views(DrawingScene::kNumViews);
  std::iota(views.begin(), views.end(), 0);
  return views;
}

double DistanceTo(const PictureLink& link, const Vector3d& point) {
  Polyline3d points = link.points;
  if (link.closed) points.push_back(points.front());
  return std::sqrt(ClosestPoint(points, point).squared_distance);
}

// The steps from point to point, of a closed link around.
std::vector<Vector3d> Steps(const PictureLink& link) {
  std::vector<Vector3d> steps;
  for (size_t i = 1; i < link.points.size(); ++i) {
    steps.push_back(link.points[i] - link.points[i - 1]);
  }
  if (link.closed) steps.push_back(link.points.front() - link.points.back());
  return steps;
}

Vector3d Tip(const PictureLink& link, int end) {
  return end == 0 ? link.points.front() : link.points.back();
}

}  // namespace

Polyline3d Path(const std::vector<Vector3d>& corners) {
  Polyline3d points = {corners.front()};
  for (size_t i = 1; i < corners.size(); ++i) {
    const Vector3d leg = corners[i] - corners[i - 1];
    const int count = std::max(1, static_cast<int>(std::lround(leg.norm())));
    for (int k = 1; k <= count; ++k) points.push_back(corners[i - 1] + leg * k / count);
  }
  return points;
}

Vector3d Polar(double radius, double angle_deg) {
  return radius * Vector3d(std::cos(angle_deg * kDeg), std::sin(angle_deg * kDeg), 0);
}

Polyline3d Arc(const Vector3d& center, double radius, double from_deg, double to_deg) {
  const double length = std::abs(to_deg - from_deg) * kDeg * radius;
  const int count = std::max(1, static_cast<int>(std::lround(length)));
  Polyline3d points;
  for (int k = 0; k <= count; ++k) {
    points.push_back(center + Polar(radius, from_deg + (to_deg - from_deg) * k / count));
  }
  return points;
}

Polyline3d Ring(const Vector3d& center, double radius) {
  Polyline3d points = Arc(center, radius, 0, 360);
  points.pop_back();
  return points;
}

Polyline3d Moved(Polyline3d points, const Vector3d& offset) {
  for (Vector3d& point : points) point += offset;
  return points;
}

int Picture::NumClosed() const {
  return static_cast<int>(
      std::count_if(links.begin(), links.end(), [](const PictureLink& l) { return l.closed; }));
}

std::vector<Vector3d> Picture::FreeEnds() const {
  std::vector<Vector3d> ends;
  for (const PictureLink& link : links) {
    for (const int end : {0, 1}) {
      if (link.free[end]) ends.push_back(Tip(link, end));
    }
  }
  return ends;
}

bool Picture::HasFreeEndAt(const Vector3d& point, double within) const {
  const auto ends = FreeEnds();
  return std::any_of(ends.begin(), ends.end(),
                     [&](const Vector3d& end) { return (end - point).norm() <= within; });
}

int Picture::DegreeAt(const Vector3d& point, double within) const {
  int degree = 0;
  double nearest = within;
  for (const Meeting& meeting : meetings) {
    const double distance = (meeting.position - point).norm();
    if (distance > nearest) continue;
    nearest = distance;
    degree = meeting.degree;
  }
  return degree;
}

const PictureLink& Picture::LinkAt(const Vector3d& point) const {
  return *std::min_element(links.begin(), links.end(),
                           [&](const PictureLink& a, const PictureLink& b) {
                             return DistanceTo(a, point) < DistanceTo(b, point);
                           });
}

double Picture::LengthPxAt(const Vector3d& point) const {
  double length = 0;
  for (const Vector3d& step : Steps(LinkAt(point))) length += step.norm();
  return length;
}

int Picture::NumLinksAt(const Vector3d& point, double within) const {
  return static_cast<int>(std::count_if(links.begin(), links.end(), [&](const PictureLink& link) {
    return DistanceTo(link, point) <= within;
  }));
}

bool Picture::Covers(const Polyline3d& points, double within) const {
  return std::any_of(links.begin(), links.end(), [&](const PictureLink& link) {
    return std::all_of(points.begin(), points.end(),
                       [&](const Vector3d& point) { return DistanceTo(link, point) <= within; });
  });
}

bool Picture::LinksAdvance() const {
  for (const PictureLink& link : links) {
    const std::vector<Vector3d> steps = Steps(link);
    for (size_t i = 0; i < steps.size(); ++i) {
      if (steps[i].norm() < 1e-6) return false;
      if (i + 1 == steps.size() && !link.closed) break;
      if (steps[i].dot(steps[(i + 1) % steps.size()]) < -1e-6) return false;
    }
  }
  return true;
}

int Picture::NumSamples() const {
  int count = 0;
  for (const PictureLink& link : links) count += link.num_samples;
  return count;
}

std::ostream& operator<<(std::ostream& out, const SceneVariant& variant) {
  return out << "footprint " << variant.footprint << (variant.even_backwards ? ", even" : "")
             << (variant.odd_backwards ? ", odd" : "") << " links backwards";
}

std::vector<SceneVariant> AllVariants() {
  std::vector<SceneVariant> variants;
  for (const double footprint : {1.0, 0.02}) {
    for (const bool even : {false, true}) {
      for (const bool odd : {false, true}) variants.push_back({footprint, even, odd});
    }
  }
  return variants;
}

DrawingScene::DrawingScene(const SceneVariant& variant) : variant_(variant) {
  const double elevation = 75 * kDeg;
  for (int v = 0; v < kNumViews; ++v) {
    const Vector3d direction =
        Polar(std::cos(elevation), v * 360.0 / kNumViews) + std::sin(elevation) * Vector3d::UnitZ();
    views_.push_back(LookAt(World(kFocalPx * direction), Vector3d::Zero()));
    views_.back().name = "view" + std::to_string(v);
    views_.back().model_index = v;
  }
}

int DrawingScene::AddImageCurve(const Polyline3d& points, const std::vector<ViewId>& views) {
  image_curves_.push_back({points, views.empty() ? AllViews() : views});
  return static_cast<int>(image_curves_.size()) - 1;
}

int DrawingScene::AddLink(const Polyline3d& points, const LinkTraits& traits) {
  LinkSpec spec{points, traits};
  const int id = static_cast<int>(specs_.size());
  if (spec.traits.views.empty()) spec.traits.views = AllViews();
  if (!traits.image_curve) {
    spec.traits.image_curve = AddImageCurve(points, traits.views);
    image_curves_.back().closed = traits.closed;
  }
  spec.backwards = id % 2 == 0 ? variant_.even_backwards : variant_.odd_backwards;
  specs_.push_back(std::move(spec));
  return id;
}

void DrawingScene::Make() {
  if (made_) return;
  made_ = true;
  MakeImages();
  edgels_ = BuildViewEdgels(curves_, {});
  DrawingGraph graph;
  GraphEditor editor(&graph);
  std::vector<NodeId> nodes;
  for (const Vector3d& point : shared_) nodes.push_back(editor.AddNode(World(point)));
  for (size_t i = 0; i < specs_.size(); ++i) {
    DrawingLink link = MakeLink(static_cast<int>(i));
    for (size_t n = 0; n < nodes.size() && !link.closed; ++n) {
      const auto is_here = [&](const Vector3d& tip) {
        return (Px(tip) - shared_[n]).norm() < 1e-6;
      };
      if (is_here(link.points_in_world.front())) link.node0 = nodes[n];
      if (is_here(link.points_in_world.back())) link.node1 = nodes[n];
    }
    editor.Add(std::move(link));
  }
  editor.Compact();
  SetGraph(std::move(graph));
}

void DrawingScene::MakeImages() {
  for (ViewId v = 0; v < kNumViews; ++v) {
    std::vector<SceneCurve> seen;
    std::vector<int> fragment_of;
    for (const ImageCurve& curve : image_curves_) {
      const bool sees = std::count(curve.views.begin(), curve.views.end(), v) > 0;
      fragment_of.push_back(sees ? static_cast<int>(seen.size()) : -1);
      if (!sees) continue;
      SceneCurve in_world{{}, curve.closed};
      for (const Vector3d& point : curve.points) in_world.points.push_back(World(point));
      seen.push_back(in_world);
    }
    curves_.push_back(ProjectCurves(views_[v], seen));
    fragment_of_.push_back(std::move(fragment_of));
  }
}

std::vector<EdgelRef> DrawingScene::SupportOf(const LinkSpec& spec, int point) const {
  std::vector<EdgelRef> support;
  for (const ViewId v : spec.traits.views) {
    const int fragment = fragment_of_[v][*spec.traits.image_curve];
    if (fragment < 0 || (spec.traits.supported && !spec.traits.supported(point, v))) continue;
    const Eigen::Vector2d pixel = *views_[v].Project(World(spec.points[point]));
    const auto distance = [&](EdgelId id) {
      return (curves_[v].edge_map.edgels[id].position_px - pixel).squaredNorm();
    };
    const auto& ids = curves_[v].fragments[fragment].edgel_ids;
    support.push_back({v, *std::min_element(ids.begin(), ids.end(), [&](EdgelId a, EdgelId b) {
                         return distance(a) < distance(b);
                       })});
  }
  return support;
}

std::vector<DrawingScene::Sample> DrawingScene::SamplesOf(int link) const {
  const LinkSpec& spec = specs_[link];
  const LinkTraits& traits = spec.traits;
  const int size = static_cast<int>(spec.points.size());
  std::vector<Sample> samples;
  for (int k = 0; k < size; ++k) {
    const int point = spec.backwards ? size - 1 - k : k;
    const auto neighbor = [&](int step) {
      const int at = point + (spec.backwards ? -step : step);
      return spec.points[traits.closed ? (at + size) % size : std::clamp(at, 0, size - 1)];
    };
    Sample sample;
    sample.position = World(spec.points[point]);
    sample.tangent = (neighbor(1) - neighbor(-1)).normalized();
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - sample.tangent * sample.tangent.transpose();
    const Eigen::Matrix3d per_px =
        traits.information ? Eigen::Matrix3d(across * *traits.information * across) : 100 * across;
    sample.information = per_px / std::pow(variant_.footprint, 2);
    sample.support = SupportOf(spec, point);
    sample.sampled = !traits.grown && (!traits.sampled || traits.sampled(point));
    samples.push_back(std::move(sample));
  }
  return samples;
}

DrawingLink DrawingScene::MakeLink(int id) const {
  DrawingLink link;
  int sketch_sample = specs_[id].traits.first_sketch_sample;
  for (Sample& sample : SamplesOf(id)) {
    LinkVertex vertex = {sample.information, variant_.footprint, 0, std::move(sample.support), {}};
    if (sample.sampled) vertex.samples = {{id, sketch_sample}};
    ++sketch_sample;
    link.points_in_world.push_back(sample.position);
    link.vertices.push_back(std::move(vertex));
  }
  if (specs_[id].traits.closed) {
    link.points_in_world.push_back(link.points_in_world.front());
    link.vertices.push_back(link.vertices.front());
    link.vertices.back().support.clear();
    link.vertices.back().samples.clear();
  }
  for (const LinkVertex& vertex : link.vertices) {
    link.sigma.push_back(SigmaAcross(vertex.information, vertex.footprint));
  }
  return link;
}

void DrawingScene::SetGraph(DrawingGraph graph) {
  graph_ = std::move(graph);
  ExpectValid(graph_);
}

TopologyInput DrawingScene::Input() const { return {views_, curves_, edgels_, {}}; }

MeetingCounts DrawingScene::Meet(MeetingStage stage, const TopologyOptions& options) {
  Make();
  GraphEditor editor(&graph_);
  MeetingCounts counts;
  stage({Input(), options, Reach::Drawn(options), &editor, &counts});
  ExpectValid(graph_);
  return counts;
}

TidyCounts DrawingScene::Tidy(const TopologyOptions& options) {
  Make();
  GraphEditor editor(&graph_);
  const TidyCounts counts = limn::Tidy(options, &editor);
  ExpectValid(graph_);
  return counts;
}

DrawingGraph DrawingScene::Finished(const TopologyOptions& options) {
  Make();
  DrawingGraph graph = graph_;
  FinishLinks(Input(), options, &graph);
  ExpectValid(graph);
  return graph;
}

std::pair<LinkId, int> DrawingScene::NearestPoint(const Vector3d& point) const {
  std::pair<LinkId, int> nearest = {-1, -1};
  double distance = std::numeric_limits<double>::infinity();
  for (size_t l = 0; l < graph_.links.size(); ++l) {
    for (int k = 0; k < graph_.links[l].size(); ++k) {
      const double d = (Px(graph_.links[l].points_in_world[k]) - point).norm();
      if (d >= distance) continue;
      distance = d;
      nearest = {static_cast<LinkId>(l), k};
    }
  }
  return nearest;
}

LinkTip DrawingScene::TipAt(const Vector3d& point) {
  Make();
  const auto [link, index] = NearestPoint(point);
  LinkTip tip = TipOf(graph_.links[link], index == 0 ? 0 : 1);
  tip.point = Px(tip.point);
  return tip;
}

double DrawingScene::ArcPxTo(const Vector3d& point) {
  Make();
  const auto [link, index] = NearestPoint(point);
  return limn::ArcPx(graph_.links[link], 0, index);
}

Picture DrawingScene::Look() {
  Make();
  Picture picture;
  for (const DrawingLink& link : graph_.links) {
    PictureLink seen;
    for (const Vector3d& position : link.points_in_world) seen.points.push_back(Px(position));
    seen.closed = link.closed;
    if (link.closed) seen.points.pop_back();
    for (const int end : {0, 1}) seen.free[end] = graph_.nodes[link.NodeAt(end)].Degree() == 1;
    seen.num_samples = static_cast<int>(limn::NumSketchSamples(link));
    picture.links.push_back(std::move(seen));
  }
  for (const DrawingNode& node : graph_.nodes) {
    if (node.Degree() < 2 || node.kind == NodeKind::kLoopAnchor) continue;
    picture.meetings.push_back({Px(node.position_in_world), node.Degree()});
  }
  return picture;
}

int DrawingScene::NumSketchSamples() const {
  int count = 0;
  for (const LinkSpec& spec : specs_) {
    for (int k = 0; k < static_cast<int>(spec.points.size()); ++k) {
      count += !spec.traits.grown && (!spec.traits.sampled || spec.traits.sampled(k));
    }
  }
  return count;
}

}  // namespace limn::testing
