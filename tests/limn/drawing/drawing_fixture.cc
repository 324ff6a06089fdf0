#include "limn/drawing/drawing_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "limn/drawing/sample_curves.h"
#include "support/synthetic_scene.h"

namespace limn::testing {
namespace {

using Eigen::Vector3d;

constexpr double kDeg = M_PI / 180;
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

// The nodes of a picture from the node ids of its links; ids < 0 are free ends.
void AddMeetings(const std::vector<std::array<int, 2>>& nodes, Picture* picture) {
  std::map<int, std::vector<LinkEnd>> ends;
  for (int i = 0; i < picture->NumLinks(); ++i) {
    for (const int end : {0, 1}) {
      if (nodes[i][end] >= 0 && !picture->links[i].closed) ends[nodes[i][end]].push_back({i, end});
    }
  }
  for (const auto& [node, incident] : ends) {
    if (incident.size() < 2) continue;
    Meeting meeting;
    meeting.degree = static_cast<int>(incident.size());
    for (const LinkEnd& end : incident) {
      meeting.position += Tip(picture->links[end.link], end.end) / meeting.degree;
      picture->links[end.link].meeting[end.end] = picture->NumMeetings();
    }
    for (const LinkEnd& end : incident) {
      meeting.spread = std::max(meeting.spread,
                                (Tip(picture->links[end.link], end.end) - meeting.position).norm());
    }
    picture->meetings.push_back(meeting);
  }
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
      if (!link.closed && link.meeting[end] < 0) ends.push_back(Tip(link, end));
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

bool Picture::EndsCoincide() const {
  return std::all_of(meetings.begin(), meetings.end(),
                     [](const Meeting& meeting) { return meeting.spread < 1e-6; });
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

void DrawingScene::ShareNode(const Vector3d& point, double within) {
  shared_.push_back({point, within});
}

void DrawingScene::RunAlong(int curve, int other) { along_.push_back({curve, other}); }

void DrawingScene::Make() {
  if (made_) return;
  made_ = true;
  MakeImages();
  sample_curve_.resize(specs_.size());
  for (const bool grown : {false, true}) {
    for (size_t i = 0; i < specs_.size(); ++i) {
      if (specs_[i].traits.grown == grown) MakeSamples(static_cast<int>(i));
    }
    if (!grown) draft_.num_sketch_samples = samples_.NumSamples();
  }
  evidence_ = BuildEvidence(curves_, {});
  for (size_t i = 0; i < specs_.size(); ++i) MakeLink(static_cast<int>(i));
  MakeNodes();
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

void DrawingScene::MakeSamples(int link) {
  const LinkSpec& spec = specs_[link];
  const LinkTraits& traits = spec.traits;
  const int size = static_cast<int>(spec.points.size());
  const int curve = samples_.NumCurves();
  sample_curve_[link] = curve;
  samples_.origins.push_back(
      {traits.grown ? -1 : link, traits.first_sketch_sample, traits.views.front(), traits.closed});
  for (int k = 0; k < size; ++k) {
    const int point = spec.backwards ? size - 1 - k : k;
    const Vector3d position = World(spec.points[point]);
    samples_.position.push_back(position);
    samples_.curve_of.push_back(curve);
    samples_.footprint.push_back(variant_.footprint);
    std::vector<EdgelRef> support;
    for (const ViewId v : traits.views) {
      const int fragment = fragment_of_[v][*traits.image_curve];
      if (fragment < 0 || (traits.supported && !traits.supported(point, v))) continue;
      const Eigen::Vector2d pixel = *views_[v].Project(position);
      const auto distance = [&](EdgelId id) {
        return (curves_[v].edge_map.edgels[id].position_px - pixel).squaredNorm();
      };
      const auto& ids = curves_[v].fragments[fragment].edgel_ids;
      support.push_back({v, *std::min_element(ids.begin(), ids.end(), [&](EdgelId a, EdgelId b) {
                           return distance(a) < distance(b);
                         })});
    }
    samples_.support.Append(support);
  }
  samples_.curve_begin.push_back(samples_.NumSamples());
  samples_.tangent.resize(samples_.position.size());
  RecomputeTangents(samples_, curve, &samples_.tangent);
  for (int s = samples_.curve_begin[curve]; s < samples_.NumSamples(); ++s) {
    const Vector3d& tangent = samples_.tangent[s];
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - tangent * tangent.transpose();
    const Eigen::Matrix3d per_px =
        traits.information ? Eigen::Matrix3d(across * *traits.information * across) : 100 * across;
    samples_.information.push_back(per_px / std::pow(variant_.footprint, 2));
  }
}

void DrawingScene::MakeLink(int link) {
  const LinkSpec& spec = specs_[link];
  const int begin = samples_.curve_begin[sample_curve_[link]];
  const int size = static_cast<int>(spec.points.size());
  DraftLink made;
  made.closed = spec.traits.closed;
  made.grown = spec.traits.grown;
  for (int k = 0; k < size; ++k) {
    const int point = spec.backwards ? size - 1 - k : k;
    made.position.push_back(samples_.position[begin + k]);
    made.information.push_back(samples_.information[begin + k]);
    made.footprint.push_back(samples_.footprint[begin + k]);
    const bool sampled = !spec.traits.sampled || spec.traits.sampled(point);
    made.samples.push_back(sampled ? std::vector<int>{begin + k} : std::vector<int>());
  }
  draft_.links.push_back(std::move(made));
}

void DrawingScene::MakeNodes() {
  for (const auto& [point, within] : shared_) {
    const int node = draft_.num_nodes++;
    for (DraftLink& link : draft_.links) {
      if (link.closed) continue;
      for (const int end : {0, 1}) {
        const Vector3d& tip = end == 0 ? link.position.front() : link.position.back();
        if ((Px(tip) - point).norm() <= within) link.node[end] = node;
      }
    }
  }
}

MergingCounts DrawingScene::Merge(const DrawingOptions& options) {
  Make();
  CurveConsistency network;
  network.overlaps.resize(samples_.NumCurves());
  for (const auto& [curve, other] : along_) {
    CurveOverlap overlap{sample_curve_[other], {}};
    const int begin = samples_.curve_begin[sample_curve_[curve]];
    const int other_begin = samples_.curve_begin[overlap.other];
    for (int k = 0; k < samples_.Size(sample_curve_[curve]); ++k) {
      const auto first = samples_.position.begin() + other_begin;
      const auto distance = [&](const Vector3d& position) {
        return (position - samples_.position[begin + k]).squaredNorm();
      };
      const auto nearest = std::min_element(
          first, first + samples_.Size(overlap.other),
          [&](const Vector3d& a, const Vector3d& b) { return distance(a) < distance(b); });
      overlap.partner.push_back(static_cast<int>(nearest - samples_.position.begin()));
    }
    network.overlaps[sample_curve_[curve]].push_back(std::move(overlap));
  }
  const MergedCurves merged = MergeCurves(samples_, network, views_, options, {});
  draft_ = FitLinks(samples_, merged, options);
  Assemble();
  return merged.counts;
}

JunctionCounts DrawingScene::Join(JoinStage stage, const DrawingOptions& options) {
  Make();
  LinkEnds ends(samples_, views_, evidence_, options, &draft_);
  JunctionCounts counts;
  stage(options, ends, &draft_, &counts);
  Assemble();
  return counts;
}

CleanupCounts DrawingScene::CleanUp(const DrawingOptions& options) {
  Make();
  const CleanupCounts counts = limn::CleanUp(options, &draft_);
  Assemble();
  return counts;
}

DrawingGraph DrawingScene::Assemble(const DrawingOptions& options) {
  Make();
  DrawingGraph graph = AssembleGraph(samples_, views_, curves_, options, draft_);
  EXPECT_EQ(Validate(graph), std::vector<std::string>());
  return graph;
}

int DrawingScene::NearestLink(const Vector3d& point, int* vertex) const {
  int nearest = -1;
  double distance = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < draft_.links.size(); ++i) {
    for (int k = 0; k < draft_.links[i].size(); ++k) {
      const double d = (Px(draft_.links[i].position[k]) - point).norm();
      if (d >= distance) continue;
      distance = d;
      nearest = static_cast<int>(i);
      *vertex = k;
    }
  }
  return nearest;
}

EndLine DrawingScene::LineAt(const Vector3d& point) {
  Make();
  int vertex = 0;
  const int link = NearestLink(point, &vertex);
  EndLine line = LineAtEnd(draft_.links[link], vertex == 0 ? 0 : 1);
  line.point = Px(line.point);
  return line;
}

void DrawingScene::Split(const Vector3d& point) {
  Make();
  int vertex = 0;
  const int link = NearestLink(point, &vertex);
  const int node = draft_.num_nodes++;
  SplitLink(&draft_, link, vertex, node);
}

void DrawingScene::Remove(const Vector3d& point) {
  Make();
  int vertex = 0;
  std::vector<uint8_t> keep(draft_.links.size(), 1);
  keep[NearestLink(point, &vertex)] = 0;
  KeepLinks(keep, &draft_);
}

double DrawingScene::ArcPxTo(const Vector3d& point) {
  Make();
  int vertex = 0;
  const int link = NearestLink(point, &vertex);
  return limn::ArcPx(draft_.links[link], 0, vertex);
}

Picture DrawingScene::Look() {
  Make();
  Picture picture;
  std::vector<std::array<int, 2>> nodes;
  for (const DraftLink& link : draft_.links) {
    PictureLink seen;
    for (const Vector3d& position : link.position) seen.points.push_back(Px(position));
    seen.closed = link.closed;
    seen.grown = link.grown;
    seen.num_samples = static_cast<int>(draft_.NumSketchSamples(link));
    picture.links.push_back(std::move(seen));
    nodes.push_back({link.node[0], link.node[1]});
  }
  AddMeetings(nodes, &picture);
  return picture;
}

int DrawingScene::NumSketchSamples() const { return draft_.num_sketch_samples; }

}  // namespace limn::testing
