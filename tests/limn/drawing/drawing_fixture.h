#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "limn/drawing/draft.h"
#include "limn/drawing/graph_assembly.h"
#include "limn/drawing/junctions.h"
#include "limn/drawing/merging.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/support/view_evidence.h"

namespace limn::testing {

// Hand-made links and the questions that tests of the stages ask of them, in terms of geometry
// alone: nothing here tells in which type the stages hold their links. All lengths are pixels.

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
  bool grown = false;
  int meeting[2] = {-1, -1};
  int num_samples = 0;  // of the sketch
};

// Two or more link ends at one node.
struct Meeting {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // mean of the ends
  int degree = 0;
  double spread = 0;  // largest distance of an end from the mean
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
  // The ends at every node are at one place.
  bool EndsCoincide() const;

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
  bool grown = false;
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
  // All ends near this point share a node.
  void ShareNode(const Eigen::Vector3d& point, double within = 1e-6);
  // For merging: the consistency network says that a curve runs along another one, each sample
  // along the nearest of the other.
  void RunAlong(int curve, int other);

  // The stages. After each the links must make a valid graph.

  // The links as curves of a sketch are merged and fitted. What was merged replaces the links.
  MergingCounts Merge(const DrawingOptions& options = {});
  // One of the stages of JoinLinks.
  using JoinStage = void (*)(const DrawingOptions&, LinkEnds&, Draft*, JunctionCounts*);
  JunctionCounts Join(JoinStage stage, const DrawingOptions& options = {});
  CleanupCounts CleanUp(const DrawingOptions& options = {});
  // In world units. Expects it to be valid.
  DrawingGraph Assemble(const DrawingOptions& options = {});

  // The straight line on which the end nearest to a point leaves.
  EndLine LineAt(const Eigen::Vector3d& point);
  // Cut the link that passes a point there.
  void Split(const Eigen::Vector3d& point);
  // Remove the link that passes nearest to a point.
  void Remove(const Eigen::Vector3d& point);
  // Arc length from the link's end 0 to the point nearest to this one, and all of it.
  double ArcPxTo(const Eigen::Vector3d& point);

  Picture Look();
  int NumSketchSamples() const;
  Eigen::Vector3d Px(const Eigen::Vector3d& world) const { return world / variant_.footprint; }
  Eigen::Vector3d World(const Eigen::Vector3d& px) const { return px * variant_.footprint; }

 private:
  struct ImageCurve {
    Polyline3d points;
    std::vector<ViewId> views;
    bool closed = false;
  };
  struct LinkSpec {
    Polyline3d points;
    LinkTraits traits;
    bool backwards = false;
  };

  void Make();
  void MakeImages();
  void MakeSamples(int link);
  void MakeLink(int link);
  void MakeNodes();
  int NearestLink(const Eigen::Vector3d& point, int* vertex) const;

  SceneVariant variant_;
  std::vector<View> views_;
  std::vector<ImageCurve> image_curves_;
  std::vector<LinkSpec> specs_;
  std::vector<std::pair<Eigen::Vector3d, double>> shared_;
  std::vector<std::pair<int, int>> along_;

  bool made_ = false;
  std::vector<ImageCurves> curves_;            // per view
  std::vector<std::vector<int>> fragment_of_;  // per view and image curve, -1 = not seen
  std::vector<int> sample_curve_;              // per link its curve in the sample set
  SampleSet samples_;
  std::vector<std::unique_ptr<ViewEvidence>> evidence_;
  Draft draft_;
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
