// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/support/view_edgels.h"
#include "limn/topology/link_geometry.h"
#include "limn/topology/meetings.h"
#include "limn/topology/tidy.h"

namespace limn::testing {

// Hand-made links and the questions that tests of the stages ask of them, in terms of geometry
// alone. All lengths are pixels.

// Points about one px apart along straight legs between these corners, which are points too.
Polyline3d Path(const std::vector<Eigen::Vector3d>& corners);
// An arc in the xy plane, counterclockwise if to_deg > from_deg. Of a whole turn the last point
// repeats the first.
Polyline3d Arc(const Eigen::Vector3d& center, double radius, double from_deg, double to_deg);
// A circle in the xy plane that does not repeat its first point.
Polyline3d Ring(const Eigen::Vector3d& center, double radius);
// The point at this distance and direction from the origin, in the xy plane.
Eigen::Vector3d Polar(double radius, double angle_deg);
Polyline3d Moved(Polyline3d points, const Eigen::Vector3d& offset);

struct PictureLink {
  Polyline3d points;
  bool closed = false;  // the last point is followed by the first, which is not repeated
  bool free[2] = {false, false};
  int num_samples = 0;  // of the sketch
};

// Two or more link ends at one node.
struct Meeting {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  int degree = 0;
};

// What a drawing looks like.
class Picture {
 public:
  std::vector<PictureLink> links;
  std::vector<Meeting> meetings;

  int NumLinks() const { return static_cast<int>(links.size()); }
  int NumClosed() const;
  int NumMeetings() const { return static_cast<int>(meetings.size()); }
  // The ends of open links that meet no other.
  std::vector<Eigen::Vector3d> FreeEnds() const;
  bool HasFreeEndAt(const Eigen::Vector3d& point, double within = 1e-6) const;
  // Degree of the node whose position is nearest, if within reach; 0 where none is.
  int DegreeAt(const Eigen::Vector3d& point, double within = 1e-6) const;

  // The link that passes nearest to a point, and its arc length.
  const PictureLink& LinkAt(const Eigen::Vector3d& point) const;
  double LengthPxAt(const Eigen::Vector3d& point) const;
  // Number of links that pass a point.
  int NumLinksAt(const Eigen::Vector3d& point, double within = 0.1) const;
  // One link passes all these points.
  bool Covers(const Polyline3d& points, double within) const;
  // No link has two points at one place, or turns by more than a right angle from one step to the
  // next.
  bool LinksAdvance() const;
  int NumSamples() const;
};

// What a link is made of beside its points.
struct LinkTraits {
  bool closed = false;
  bool grown = false;  // without samples of the sketch
  // Views with edgels of the link; all if empty.
  std::vector<ViewId> views = {};
  // Whether the edgels of a view support a point; all do by default.
  std::function<bool(int point, ViewId view)> supported = nullptr;
  // Whether a point has a sample; all have by default.
  std::function<bool(int point)> sampled = nullptr;
  // Of DrawingScene::AddImageCurve: where the edgels are. By default right at the link.
  std::optional<int> image_curve = std::nullopt;
  // Inverse covariance of every point, px^-2; by default 100 in all directions across the link.
  std::optional<Eigen::Matrix3d> information = std::nullopt;
  // Sample of the sketch that the first point is.
  int first_sketch_sample = 0;
};

// The same scene, larger or smaller, its links stored in one direction or the other, must give the
// same drawing.
struct SceneVariant {
  double footprint = 1;         // world units per px
  bool even_backwards = false;  // links 0, 2, ... are stored from their last point to the first
  bool odd_backwards = false;
};

std::ostream& operator<<(std::ostream& out, const SceneVariant& variant);
std::vector<SceneVariant> AllVariants();

// A scene of links on its way through the stages. Links are added first; the first stage or
// question makes them.
class DrawingScene {
 public:
  explicit DrawingScene(const SceneVariant& variant = {});

  static constexpr int kNumViews = 8;
  // Views from all sides, 75 degrees above the xy plane: there a px is .96 to 1 px in all images.
  const std::vector<View>& views() const { return views_; }

  // An edge in these images, all if empty. Returns its id.
  int AddImageCurve(const Polyline3d& points, const std::vector<ViewId>& views = {});
  // Each link is one curve of the sketch, every point a sample. Returns its id.
  int AddLink(const Polyline3d& points, const LinkTraits& traits = {});
  // All ends at this point share a node.
  void ShareNode(const Eigen::Vector3d& point) { shared_.push_back(point); }

  // The stages. After each the links must make a valid graph.

  using MeetingStage = void (*)(const MeetingTask&);
  // Within the reach of links as they were drawn.
  MeetingCounts Meet(MeetingStage stage, const TopologyOptions& options = {});
  TidyCounts Tidy(const TopologyOptions& options = {});
  // Of a copy; the scene goes on without.
  DrawingGraph Finished(const TopologyOptions& options = {});

  // The straight line on which the end nearest to a point leaves, px.
  LinkTip TipAt(const Eigen::Vector3d& point);
  // Arc length from the link's end 0 to the point nearest to this one, and all of it.
  double ArcPxTo(const Eigen::Vector3d& point);

  Picture Look();
  // World units.
  DrawingGraph Graph() {
    Make();
    return graph_;
  }
  int NumSketchSamples() const;
  Eigen::Vector3d Px(const Eigen::Vector3d& world) const { return world / variant_.footprint; }
  Eigen::Vector3d World(const Eigen::Vector3d& px) const { return px * variant_.footprint; }

 protected:
  struct LinkSpec {
    Polyline3d points;
    LinkTraits traits;
    bool backwards = false;
  };

  // A point of a link, in the order in which it is stored.
  struct Sample {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    std::vector<EdgelRef> support;
    bool sampled = true;
  };

  void Make();
  // Needs the images.
  std::vector<Sample> SamplesOf(int link) const;
  const std::vector<LinkSpec>& specs() const { return specs_; }
  double footprint() const { return variant_.footprint; }
  // Expects it to be valid.
  void SetGraph(DrawingGraph graph);

 private:
  struct ImageCurve {
    Polyline3d points;
    std::vector<ViewId> views;
    bool closed = false;
  };

  TopologyInput Input() const;
  void MakeImages();
  DrawingLink MakeLink(int link) const;
  std::vector<EdgelRef> SupportOf(const LinkSpec& spec, int point) const;
  std::pair<LinkId, int> NearestPoint(const Eigen::Vector3d& point) const;

  SceneVariant variant_;
  std::vector<View> views_;
  std::vector<ImageCurve> image_curves_;
  std::vector<LinkSpec> specs_;
  std::vector<Eigen::Vector3d> shared_;

  bool made_ = false;
  std::vector<ImageCurves> curves_;            // per view
  std::vector<std::vector<int>> fragment_of_;  // per view and image curve, -1 = not seen
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
  DrawingGraph graph_;
};

// A test that is run on all variants of its scene.
class DrawingSceneTest : public ::testing::TestWithParam<SceneVariant> {
 protected:
  DrawingScene scene_{GetParam()};
};

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): GoogleTest knows no other way.
#define LIMN_ALL_VARIANTS(suite) \
  INSTANTIATE_TEST_SUITE_P(Variants, suite, ::testing::ValuesIn(::limn::testing::AllVariants()))

}  // namespace limn::testing
