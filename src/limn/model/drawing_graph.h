// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/curve_shape.h"
#include "limn/model/curve3d.h"
#include "limn/model/dimension.h"
#include "limn/model/faces.h"
#include "limn/model/regularities.h"
#include "limn/model/round_body.h"

namespace limn {

using NodeId = int;
using LinkId = int;

enum class NodeKind {
  kEnd,         // degree 1, or degree 2 where two links meet at a corner
  kJunction,    // degree 3 or more
  kLoopAnchor,  // where a closed link begins and ends; both its ends are here, and no others
};

const char* NodeKindName(NodeKind kind);

// One end of a link: end 0 is its first point, end 1 its last.
struct LinkEnd {
  LinkId link = -1;
  int end = 0;

  auto operator<=>(const LinkEnd&) const = default;
};

struct DrawingNode {
  Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
  NodeKind kind = NodeKind::kEnd;
  // Of its position, world units squared (MeasureNodes). Zero: unknown.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  // Its number in the drawing that this is a part of (Selected); -1: that of its place.
  NodeId number = -1;
  // All link ends at this node, ascending. Degree = size.
  std::vector<LinkEnd> incident;
  // Pairs of incident link ends that continue each other smoothly.
  std::vector<std::pair<LinkEnd, LinkEnd>> continuations;

  int Degree() const { return static_cast<int>(incident.size()); }
};

// A run of samples of one sketch curve that a link stands for.
struct LinkMember {
  int curve = -1;
  int begin = 0;  // samples [begin, end)
  int end = 0;

  int size() const { return end - begin; }
};

// Where a curve lies relative to a dense surface (depth maps, cloud or mesh).
enum class DenseClass {
  kUnknown,
  kSurface,   // the surface continues on both sides: paint or a fold
  kBoundary,  // on one side only: an occluding contour or a rim
  kFree,      // in front of the surface, or where there is none
};

const char* DenseClassName(DenseClass dense_class);

// What kind of edge a link is (limn/kinds/).
enum class LinkKind : uint8_t {
  kUnknown,
  kEdge,     // of an object: a crease, or the border of a surface
  kPaint,    // where the reflectance of a surface changes
  kShadow,   // border of a shadow, or shading
  kContour,  // outline of a smooth body, which lies elsewhere in other views
  kRod,      // center line of a wire, cable, bar or rod (limn/rods/)
  kTexture,  // one of many short curves: grain, leaves, cloth, small print
};
constexpr int kNumLinkKinds = 7;

// "edge", "paint", "shadow", "contour", "rod", "texture", "unknown".
const char* LinkKindName(LinkKind kind);
// Nothing if there is no such kind.
std::optional<LinkKind> LinkKindNamed(const std::string& name);

// Why a link is tentative (limn/belief/).
enum class LinkDoubt : uint8_t {
  kNone,
  kFewViews,     // too few views to be fitted
  kChance,       // no more views than by chance
  kSeenThrough,  // other links are seen through it
  kExplained,    // better links explain its edgels
  kRodOutline,   // a rod stands for it; by itself it would be believed
  kDepth,        // its views are too near to each other to measure its depth
  kStill,        // its edgels stand at the same pixels in images from different places
  kShort,        // part of a short curve, and unlikely
};
constexpr int kNumLinkDoubts = 9;

// "", "few views", "chance", "seen through", "explained by others", "outline of a rod", "depth not
// measured", "still in the images", "short and unlikely".
const char* LinkDoubtName(LinkDoubt doubt);
// Nothing if there is no such doubt.
std::optional<LinkDoubt> LinkDoubtNamed(const std::string& name);

// How a link lies relative to a dense surface (limn/dense/).
struct LinkDense {
  DenseClass dense_class = DenseClass::kUnknown;  // of most of its length
  double added_share = 0;                         // of its length, without a dense point nearby
  // Share of its supporting views, over its samples, in which it is behind the surface.
  double occluded_share = 0;
  bool behind_surface = false;
  // Mean angle between the surface's normals on its two sides, where both are known; -1: nowhere.
  double fold_deg = -1;
};

// The simplest parametric curve that explains a link (limn/primitives/). It begins and ends at
// those nodes of the link that have other links, too.
struct LinkPrimitive {
  CurveShape shape;
  // Distances of the link's points from the shape in the supporting views, px.
  double rms_px = 0;
  double max_px = 0;
};

// A sample of a curve of the sketch.
struct SketchSample {
  int curve = -1;
  int sample = -1;

  auto operator<=>(const SketchSample&) const = default;
};

// Data of a link's point while the drawing is built.
struct LinkVertex {
  // Inverse covariance of the position across the curve, world units.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double footprint = 0;  // world units per px
  // Primary views whose curves agree here; 0 where the sketch has no curve.
  int agreeing_views = 0;
  // Edgels that support the point, ascending, and the samples that it stands for. Both are
  // empty at a point that was added to reach a node.
  std::vector<EdgelRef> support;
  std::vector<SketchSample> samples;
};

// Grain, cloth, small print and accidents are parts of shorter curves
// (algorithm/kinds.md#texture), px.
constexpr double kShortCurvePx = 75;

struct DrawingLink {
  // First and last point are the positions of node0 and node1.
  std::vector<Eigen::Vector3d> points_in_world;
  // Isotropic standard deviation across the curve per point, world units: that of the fit, and,
  // where cameras were refined, of these (AddShareOfCameras).
  std::vector<double> sigma;
  // One per point while the drawing is built, otherwise empty.
  std::vector<LinkVertex> vertices;
  NodeId node0 = -1;
  NodeId node1 = -1;
  // node0 == node1 is a loop anchor: the polyline returns to its first point.
  bool closed = false;
  // Views with edgels along this link, ascending.
  std::vector<ViewId> supporting_views;
  std::vector<LinkMember> members;
  // Median distance of the reprojected link to its supporting edgels, pixels.
  double residual_px = 0;
  // The angle by which its views measure its depth (TriAngleDeg); -1: unknown.
  double tri_angle_deg = -1;
  // Standard deviation in the direction that its views measure least, which is that of their depth
  // (DepthSigma), world units; -1: unknown.
  double depth_sigma = -1;
  // Of the images, against chance, natural logarithm (JudgeLinks). Of links that were judged.
  std::optional<double> evidence;
  // Probability that its curve exists, 0 to 1, believed or not (TellConfidences); -1: unknown.
  double confidence = -1;
  // Length of the curve that it is a part of (MeasureCurves), pixels; 0: unknown.
  double curve_px = 0;
  // Of most of its length.
  LinkKind kind = LinkKind::kUnknown;
  double kind_confidence = 0;  // 0 to 1; 0 if unknown
  // Of a rod, half its thickness, world units; 0 for other kinds.
  double rod_radius = 0;
  // Of some contours, the body whose outline they are. Those of one fit are equal.
  std::optional<RoundBody> body = std::nullopt;
  // Too little evidence (limn/belief/): left out of exports unless requested.
  bool tentative = false;
  // kNone unless tentative.
  LinkDoubt doubt = LinkDoubt::kNone;
  // Set by drawing_fuser only.
  std::optional<LinkDense> dense = std::nullopt;
  // The same curve as the points; absent in drawings of earlier versions.
  std::optional<LinkPrimitive> primitive = std::nullopt;
  // What its primitive has in common with others (limn/regularity/).
  std::optional<LinkRegularity> regularity = std::nullopt;
  // As of nodes. The parts of a link in a flat drawing have the same.
  LinkId number = -1;

  int size() const { return static_cast<int>(points_in_world.size()); }
  NodeId NodeAt(int end) const { return end == 0 ? node0 : node1; }
  // An outline is elsewhere in each view, and a center line between the edgels.
  bool IsAlongEdgels() const { return kind != LinkKind::kContour && kind != LinkKind::kRod; }
  bool IsOfShortCurve() const { return curve_px > 0 && curve_px < kShortCurvePx; }
};

// The 3D drawing: curves (links) that meet at nodes.
struct DrawingGraph {
  std::vector<DrawingNode> nodes;
  std::vector<DrawingLink> links;
  Regularities regularities = {};
  // Surfaces between the links. Code that changes links must drop the faces they bound
  // (DropFacesOf).
  std::vector<DrawingFace> faces = {};
  std::vector<DrawingDimension> dimensions = {};
};

// Descriptions of violated invariants, empty if there are none: ids in range, incidence symmetric,
// link ends at their nodes' positions, all numbers finite, links of two points or more, none of
// zero length, one sigma (and one vertex, if there are any) per point, radii of rods and of nothing
// else, bodies of contours only, primitives that ValidateShape and IsAlongLink accept, regularities
// and faces in order, finite dimensions, confidences from 0 to 1, lengths of curves not below 0,
// doubts of tentative links only, symmetric covariances without negative
// variances, junction <=> degree >= 3, loop anchors with exactly the two ends
// of one closed link. Time n log n, mostly linear.
std::vector<std::string> Validate(const DrawingGraph& graph);

// The kind of a node, by the link ends at it and by whether their link is closed.
NodeKind KindOf(const DrawingGraph& graph, const DrawingNode& node);

// The number that users know a node or link of a drawing or of a part of one by.
NodeId NumberOfNode(const DrawingGraph& graph, size_t node);
LinkId NumberOfLink(const DrawingGraph& graph, size_t link);

// Recomputes `incident` and `kind` of every node from the links' node0, node1 and closed.
void RebuildIncidence(DrawingGraph* graph);

// Removes links marked 0, nodes without links and faces that these links bound; the others keep
// their order. Rebuilds the incidence.
void RemoveLinks(const std::vector<uint8_t>& keep, DrawingGraph* graph);

// Drops the faces bounded by links marked 1, whose shapes have changed.
void DropFacesOf(const std::vector<uint8_t>& changed, DrawingGraph* graph);

}  // namespace limn
