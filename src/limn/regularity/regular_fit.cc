// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/regular_fit.h"

#include <cmath>
#include <set>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <ceres/ceres.h>

#include "limn/util/quiet_solver.h"

namespace limn {
namespace {

template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <typename T>
using ConstMap3 = Eigen::Map<const Vector3<T>>;

// Weights of the constraints, 1/px: first weak, so that the shapes find their places, then hard.
constexpr double kWeights[] = {30, 3000};
constexpr int kIterations = 50;
// Distance over which an angle between two directions counts, px.
constexpr double kArmPx = 100;

Matrix6d RootOf(const Matrix6d& information) { return information.llt().matrixU(); }

struct LineCost {
  Matrix6d root;
  Vector6d best;

  template <typename T>
  bool operator()(const T* start, const T* end, T* residuals) const {
    Eigen::Matrix<T, 6, 1> offset;
    offset << ConstMap3<T>(start), ConstMap3<T>(end);
    offset -= best.cast<T>();
    Eigen::Map<Eigen::Matrix<T, 6, 1>>(residuals, 6) = root.cast<T>() * offset;
    return true;
  }
};

struct ArcCost {
  Matrix6d root;
  CircularArc best;

  template <typename T>
  bool operator()(const T* center, const T* normal, const T* radius, T* residuals) const {
    const Vector3<T> turn = ConstMap3<T>(normal) - best.Normal().cast<T>();
    Eigen::Matrix<T, 6, 1> offset;
    offset << ConstMap3<T>(center) - best.center.cast<T>(),
        T(best.radius) * turn.dot(best.x_axis.cast<T>()),
        T(best.radius) * turn.dot(best.y_axis.cast<T>()), radius[0] - T(best.radius);
    Eigen::Map<Eigen::Matrix<T, 6, 1>>(residuals, 6) = root.cast<T>() * offset;
    return true;
  }
};

// Holds a point where it is.
struct HoldCost {
  Eigen::Matrix3d root;
  Eigen::Vector3d place;

  template <typename T>
  bool operator()(const T* point, T* residuals) const {
    Eigen::Map<Vector3<T>>(residuals, 3) = root.cast<T>() * (ConstMap3<T>(point) - place.cast<T>());
    return true;
  }
};

// end - start is along a direction.
struct AlongCost {
  double weight;

  template <typename T>
  bool operator()(const T* direction, const T* start, const T* end, T* residuals) const {
    const Vector3<T> chord = ConstMap3<T>(end) - ConstMap3<T>(start);
    Eigen::Map<Vector3<T>>(residuals, 3) = T(weight) * ConstMap3<T>(direction).cross(chord);
    return true;
  }
};

struct OrthogonalCost {
  double weight;

  template <typename T>
  bool operator()(const T* a, const T* b, T* residual) const {
    *residual = T(weight) * ConstMap3<T>(a).dot(ConstMap3<T>(b));
    return true;
  }
};

// Two unit vectors are along one line.
struct SameDirectionCost {
  double weight;

  template <typename T>
  bool operator()(const T* a, const T* b, T* residuals) const {
    Eigen::Map<Vector3<T>>(residuals, 3) = T(weight) * ConstMap3<T>(a).cross(ConstMap3<T>(b));
    return true;
  }
};

struct InPlaneCost {
  double weight;

  template <typename T>
  bool operator()(const T* normal, const T* offset, const T* point, T* residual) const {
    *residual = T(weight) * (ConstMap3<T>(normal).dot(ConstMap3<T>(point)) - *offset);
    return true;
  }
};

struct OnCircleCost {
  double weight;

  template <typename T>
  bool operator()(const T* center, const T* normal, const T* radius, const T* point,
                  T* residuals) const {
    const Vector3<T> offset = ConstMap3<T>(point) - ConstMap3<T>(center);
    const T above = ConstMap3<T>(normal).dot(offset);
    const Vector3<T> in_plane = offset - above * ConstMap3<T>(normal);
    residuals[0] = T(weight) * (in_plane.norm() - *radius);
    residuals[1] = T(weight) * above;
    return true;
  }
};

using Point = Eigen::Vector3d;

class RegularFit {
 public:
  RegularFit(const DrawingGraph& graph, const DrawingEvidence& evidence, RegularityClasses* classes)
      : graph_(graph), evidence_(evidence), classes_(*classes) {
    for (size_t i = 0; i < evidence.lines.size(); ++i) line_of_[evidence.lines[i].link] = i;
    for (size_t i = 0; i < evidence.arcs.size(); ++i) arc_of_[evidence.arcs[i].link] = i;
    FindMembers();
    MakeBlocks();
  }

  RegularShapes Solve() {
    const QuietSolver quiet;
    for (const double weight : kWeights) {
      ceres::Problem problem;
      AddEvidence(&problem);
      AddCircleEnds(weight, &problem);
      AddDirections(weight, &problem);
      AddPlanes(weight, &problem);
      AddAxes(weight, &problem);
      SetManifolds(&problem);
      ceres::Solver::Options options;
      options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
      options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
      options.max_num_iterations = kIterations;
      options.function_tolerance = 1e-12;
      options.parameter_tolerance = 1e-12;
      options.num_threads = 1;
      options.logging_type = ceres::SILENT;
      ceres::Solver::Summary summary;
      ceres::Solve(options, &problem, &summary);
    }
    StoreClasses();
    return Shapes();
  }

 private:
  struct ArcBlocks {
    Point center, normal;
    double radius = 1;
    double* shared_radius = nullptr;  // that of a class
    double* Radius() { return shared_radius != nullptr ? shared_radius : &radius; }
  };

  // Links that follow a regularity, and the nodes where they meet others.
  void FindMembers() {
    const auto add_lines = [&](const std::vector<int>& lines) {
      for (const int i : lines) members_.insert(evidence_.lines[i].link);
    };
    const auto add_arcs = [&](const std::vector<int>& arcs) {
      for (const int i : arcs) members_.insert(evidence_.arcs[i].link);
    };
    for (const DirectionClass& direction : classes_.directions) add_lines(direction.lines);
    for (const PlaneClass& plane : classes_.planes) {
      add_lines(plane.lines);
      add_arcs(plane.arcs);
    }
    for (const RadiusClass& radius : classes_.radii) add_arcs(radius.arcs);
    for (const AxisClass& axis : classes_.axes) add_arcs(axis.arcs);
    for (const LinkId l : members_) {
      for (const NodeId node : {graph_.links[l].node0, graph_.links[l].node1}) {
        if (graph_.nodes[node].Degree() >= 2) free_nodes_.insert(node);
      }
    }
    active_ = members_;
    for (const NodeId node : free_nodes_) {
      for (const LinkEnd& at : graph_.nodes[node].incident) active_.insert(at.link);
    }
  }

  // The point that an end of a link has: that of its node, if others have it, too.
  Point* PointOf(const LinkEnd& at) {
    const NodeId node = graph_.links[at.link].NodeAt(at.end);
    if (graph_.nodes[node].Degree() >= 2) return &node_points_.at(node);
    return &end_points_.at(at);
  }

  Point PlaceOf(const LinkEnd& at) const {
    const DrawingNode& node = graph_.nodes[graph_.links[at.link].NodeAt(at.end)];
    const auto line = line_of_.find(at.link);
    if (node.Degree() >= 2 || line == line_of_.end()) {
      return evidence_.unit.FromWorld(node.position_in_world);
    }
    return at.end == 0 ? evidence_.lines[line->second].start : evidence_.lines[line->second].end;
  }

  void MakeBlocks() {
    for (const LinkId l : active_) {
      for (const int end : {0, 1}) {
        const NodeId node = graph_.links[l].NodeAt(end);
        if (graph_.nodes[node].Degree() >= 2) {
          node_points_[node] = PlaceOf({l, end});
        } else {
          end_points_[{l, end}] = PlaceOf({l, end});
        }
      }
      const auto arc = arc_of_.find(l);
      if (arc == arc_of_.end()) continue;
      const CircularArc& best = evidence_.arcs[arc->second].arc;
      arcs_[static_cast<int>(arc->second)] = {best.center, best.Normal(), best.radius};
    }
    for (RadiusClass& radius : classes_.radii) {
      for (const int i : radius.arcs) arcs_.at(i).shared_radius = &radius.radius;
    }
  }

  void AddEvidence(ceres::Problem* problem) {
    for (const LinkId l : active_) {
      if (const auto line = line_of_.find(l); line != line_of_.end()) {
        const LineEvidence& of = evidence_.lines[line->second];
        Vector6d best;
        best << of.start, of.end;
        problem->AddResidualBlock(new ceres::AutoDiffCostFunction<LineCost, 6, 3, 3>(
                                      new LineCost{RootOf(of.information), best}),
                                  nullptr, PointOf({l, 0})->data(), PointOf({l, 1})->data());
      } else if (const auto arc = arc_of_.find(l); arc != arc_of_.end()) {
        const ArcEvidence& of = evidence_.arcs[arc->second];
        ArcBlocks& blocks = arcs_.at(static_cast<int>(arc->second));
        problem->AddResidualBlock(new ceres::AutoDiffCostFunction<ArcCost, 6, 3, 3, 1>(
                                      new ArcCost{RootOf(of.information), of.arc}),
                                  nullptr, blocks.center.data(), blocks.normal.data(),
                                  blocks.Radius());
      } else {
        HoldEnds(l, problem);
      }
    }
    for (auto& [node, point] : node_points_) {
      if (!free_nodes_.contains(node) && problem->HasParameterBlock(point.data())) {
        problem->SetParameterBlockConstant(point.data());
      }
    }
  }

  // A curve of another shape is drawn to the places of its ends, as the images see them.
  void HoldEnds(LinkId l, ceres::Problem* problem) {
    constexpr double kHoldPerPx = 2 / 0.3;
    const LinkSamples& samples = evidence_.samples[l];
    for (const int end : {0, 1}) {
      if (!free_nodes_.contains(graph_.links[l].NodeAt(end))) continue;
      Eigen::Matrix3d root = kHoldPerPx * Eigen::Matrix3d::Identity();
      if (!samples.samples.empty()) {
        const LinkSample3d& at = end == 0 ? samples.samples.front() : samples.samples.back();
        root = kHoldPerPx * evidence_.unit.length * at.across;
      }
      problem->AddResidualBlock(
          new ceres::AutoDiffCostFunction<HoldCost, 3, 3>(new HoldCost{root, PlaceOf({l, end})}),
          nullptr, PointOf({l, end})->data());
    }
  }

  void AddCircleEnds(double weight, ceres::Problem* problem) {
    for (auto& [i, blocks] : arcs_) {
      const LinkId l = evidence_.arcs[i].link;
      for (const int end : {0, 1}) {
        const NodeId node = graph_.links[l].NodeAt(end);
        if (graph_.nodes[node].Degree() < 2 || graph_.links[l].closed) continue;
        problem->AddResidualBlock(
            new ceres::AutoDiffCostFunction<OnCircleCost, 2, 3, 3, 1, 3>(new OnCircleCost{weight}),
            nullptr, blocks.center.data(), blocks.normal.data(), blocks.Radius(),
            PointOf({l, end})->data());
        if (!free_nodes_.contains(node)) {
          problem->SetParameterBlockConstant(PointOf({l, end})->data());
        }
      }
    }
  }

  void AddDirections(double weight, ceres::Problem* problem) {
    for (size_t c = 0; c < classes_.directions.size(); ++c) {
      DirectionClass& direction = classes_.directions[c];
      for (const int i : direction.lines) {
        const LinkId l = evidence_.lines[i].link;
        problem->AddResidualBlock(
            new ceres::AutoDiffCostFunction<AlongCost, 3, 3, 3, 3>(new AlongCost{weight}), nullptr,
            direction.direction.data(), PointOf({l, 0})->data(), PointOf({l, 1})->data());
      }
      for (const int other : direction.orthogonal_to) {
        if (other < static_cast<int>(c)) continue;
        problem->AddResidualBlock(new ceres::AutoDiffCostFunction<OrthogonalCost, 1, 3, 3>(
                                      new OrthogonalCost{weight * kArmPx}),
                                  nullptr, direction.direction.data(),
                                  classes_.directions[other].direction.data());
      }
    }
  }

  double* NormalOf(PlaneClass* plane) {
    if (plane->normal_class < 0) return plane->normal.data();
    return classes_.directions[plane->normal_class].direction.data();
  }

  void AddPlanes(double weight, ceres::Problem* problem) {
    for (PlaneClass& plane : classes_.planes) {
      if (plane.normal_class >= 0) {
        const Point& normal = classes_.directions[plane.normal_class].direction;
        if (normal.dot(plane.normal) < 0) plane.offset = -plane.offset;
        plane.normal = normal;
      }
      double* normal = NormalOf(&plane);
      const auto put_in = [&](double* point) {
        problem->AddResidualBlock(
            new ceres::AutoDiffCostFunction<InPlaneCost, 1, 3, 1, 3>(new InPlaneCost{weight}),
            nullptr, normal, &plane.offset, point);
      };
      for (const int i : plane.lines) {
        for (const int end : {0, 1}) put_in(PointOf({evidence_.lines[i].link, end})->data());
      }
      for (const int i : plane.arcs) {
        ArcBlocks& arc = arcs_.at(i);
        put_in(arc.center.data());
        AddSameDirection(weight * *arc.Radius(), normal, arc.normal.data(), problem);
      }
    }
  }

  void AddSameDirection(double weight, double* a, double* b, ceres::Problem* problem) {
    problem->AddResidualBlock(
        new ceres::AutoDiffCostFunction<SameDirectionCost, 3, 3, 3>(new SameDirectionCost{weight}),
        nullptr, a, b);
  }

  void AddAxes(double weight, ceres::Problem* problem) {
    for (AxisClass& axis : classes_.axes) {
      for (const int i : axis.arcs) {
        ArcBlocks& arc = arcs_.at(i);
        AddSameDirection(weight * *arc.Radius(), axis.direction.data(), arc.normal.data(), problem);
        problem->AddResidualBlock(
            new ceres::AutoDiffCostFunction<AlongCost, 3, 3, 3, 3>(new AlongCost{weight}), nullptr,
            axis.direction.data(), axis.point.data(), arc.center.data());
      }
      // Along itself the point may be anywhere.
      problem->AddResidualBlock(new ceres::AutoDiffCostFunction<HoldCost, 3, 3>(
                                    new HoldCost{1e-3 * Eigen::Matrix3d::Identity(), axis.point}),
                                nullptr, axis.point.data());
    }
  }

  void SetManifolds(ceres::Problem* problem) {
    const auto on_sphere = [&](double* block) {
      if (problem->HasParameterBlock(block)) {
        problem->SetManifold(block, new ceres::SphereManifold<3>());
      }
    };
    for (DirectionClass& direction : classes_.directions) on_sphere(direction.direction.data());
    for (PlaneClass& plane : classes_.planes) {
      if (plane.normal_class < 0) on_sphere(plane.normal.data());
    }
    for (AxisClass& axis : classes_.axes) on_sphere(axis.direction.data());
    for (auto& [i, arc] : arcs_) on_sphere(arc.normal.data());
  }

  void StoreClasses() {
    for (PlaneClass& plane : classes_.planes) {
      plane.normal = Eigen::Map<const Point>(NormalOf(&plane)).normalized();
    }
  }

  CircularArc ArcOf(int i) {
    ArcBlocks& blocks = arcs_.at(i);
    CircularArc arc = evidence_.arcs[i].arc;
    const LinkId l = evidence_.arcs[i].link;
    arc.center = blocks.center;
    arc.radius = *blocks.Radius();
    const Point normal = blocks.normal.normalized();
    const auto in_plane = [&](const Point& towards) {
      return Point(towards - towards.dot(normal) * normal).normalized();
    };
    const auto towards_end = [&](int end) {
      const NodeId node = graph_.links[l].NodeAt(end);
      const bool is_held = graph_.nodes[node].Degree() >= 2 && !graph_.links[l].closed;
      const CircularArc& best = evidence_.arcs[i].arc;
      return in_plane(is_held ? Point(*PointOf({l, end}) - arc.center)
                              : Point(PointAt(best, end) - best.center));
    };
    arc.x_axis = towards_end(0);
    arc.y_axis = normal.cross(arc.x_axis);
    if (!arc.IsCircle()) {
      const Point end = towards_end(1);
      const double angle = std::atan2(arc.y_axis.dot(end), arc.x_axis.dot(end));
      arc.sweep_rad = angle > 0 ? angle : angle + 2 * M_PI;
    }
    return arc;
  }

  RegularShapes Shapes() {
    RegularShapes shapes;
    for (const LinkId l : active_) {
      if (const auto line = line_of_.find(l); line != line_of_.end()) {
        shapes.lines[static_cast<int>(line->second)] = {*PointOf({l, 0}), *PointOf({l, 1})};
      } else if (const auto arc = arc_of_.find(l); arc != arc_of_.end()) {
        shapes.arcs[static_cast<int>(arc->second)] = ArcOf(static_cast<int>(arc->second));
      }
    }
    return shapes;
  }

  const DrawingGraph& graph_;
  const DrawingEvidence& evidence_;
  RegularityClasses& classes_;
  std::map<LinkId, size_t> line_of_, arc_of_;
  std::set<LinkId> members_, active_;
  std::set<NodeId> free_nodes_;
  std::map<NodeId, Point> node_points_;
  std::map<LinkEnd, Point> end_points_;
  std::map<int, ArcBlocks> arcs_;
};

}  // namespace

RegularShapes FitRegularShapes(const DrawingGraph& graph, const DrawingEvidence& evidence,
                               RegularityClasses* classes) {
  return RegularFit(graph, evidence, classes).Solve();
}

}  // namespace limn
