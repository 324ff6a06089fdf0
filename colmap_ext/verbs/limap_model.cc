// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/limap_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/verbs/views_of_drawing.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/formats/tracks_writer.h"
#include "limn/model/footprint.h"
#include "limn/model/straight_link.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Greatest distance of a chain of lines from its curve, px.
constexpr double kChainPx = 0.5;

// A line to be: a link, or a part of one. `joints` are where it begins and ends.
struct Piece {
  LinkId link = -1;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  std::array<int, 2> joints = {};
  std::map<size_t, uint32_t> segment_of_image;  // by the image's place in the model
};

// The corners of lines that stand for a link that is not straight.
Polyline3d ChainOf(const DrawingLink& link, const std::vector<View>& views) {
  const double tolerance = kChainPx * LinkFootprint(link, views);
  if (!(tolerance > 0)) return link.points_in_world;
  if (!link.primitive) return Simplified(link.points_in_world, tolerance);
  Polyline3d chain = SampleShape(link.primitive->shape, tolerance);
  chain.front() = link.points_in_world.front();
  chain.back() = link.points_in_world.back();
  return chain;
}

double Uncertainty(const DrawingLink& link) {
  double sum = 0;
  int count = 0;
  for (const double sigma : link.sigma) {
    if (!std::isfinite(sigma)) continue;
    sum += sigma;
    ++count;
  }
  return count == 0 ? -1 : sum / count;
}

// The longest part of a line that the view shows, in COLMAP's pixels.
std::optional<LimapSegment> SegmentIn(const View& view, const Camera& camera, const Piece& piece) {
  LimapSegment longest;
  for (const auto& run : ProjectPolyline(view, {piece.start, piece.end})) {
    const Eigen::Vector2d start = ModelPixel(view, camera, run.front());
    const Eigen::Vector2d end = ModelPixel(view, camera, run.back());
    if ((end - start).norm() <= (longest.end - longest.start).norm()) continue;
    longest.start = start;
    longest.end = end;
  }
  if (longest.start == longest.end) return std::nullopt;
  return longest;
}

void CheckPinholes(const SparseModel& model) {
  for (const ModelImage& image : model.images) {
    const Camera& camera = model.CameraOf(image);
    if (camera.model == CameraModelId::kSimplePinhole || camera.model == CameraModelId::kPinhole) {
      continue;
    }
    if (camera.IsPanorama()) {
      throw InputError("camera " + std::to_string(camera.id) +
                       " is EQUIRECTANGULAR: LIMAP's lines are those of pinhole cameras");
    }
    throw InputError("camera " + std::to_string(camera.id) + " has a lens (" +
                     FindCameraModel(static_cast<int32_t>(camera.model))->name +
                     "): LIMAP's lines are those of pinhole cameras; give the workspace that "
                     "colmap image_undistorter writes");
  }
}

class LimapMaker {
 public:
  LimapMaker(DrawingFile drawing, SparseModel model, const std::vector<View>& views)
      : graph_(WithViewsOf(model, views, std::move(drawing))), views_(views) {
    made_.model = std::move(model);
    made_.structures.images.resize(made_.model.images.size());
    view_of_image_.resize(made_.model.images.size());
    for (const View& view : views_) view_of_image_[view.model_index] = &view;
    num_joints_ = static_cast<int>(graph_.nodes.size());
  }

  LimapModel Make(bool chains) {
    for (size_t id = 0; id < graph_.links.size(); ++id) AddPieces(static_cast<LinkId>(id), chains);
    for (size_t i = 0; i < pieces_.size(); ++i) AddLine(i);
    AddJoints();
    for (size_t i = 0; i < made_.model.images.size(); ++i) {
      LimapImage& image = made_.structures.images[i];
      image.id = made_.model.images[i].id;
      image.num_points = static_cast<uint32_t>(made_.model.images[i].observations.size());
    }
    std::sort(made_.structures.images.begin(), made_.structures.images.end(),
              [](const LimapImage& a, const LimapImage& b) { return a.id < b.id; });
    return std::move(made_);
  }

 private:
  void AddPieces(LinkId id, bool chains) {
    const DrawingLink& link = graph_.links[id];
    if (LineOf(link)) {
      Piece piece = {id,
                     link.points_in_world.front(),
                     link.points_in_world.back(),
                     {link.node0, link.node1},
                     {}};
      pieces_.push_back(std::move(piece));
    } else if (chains) {
      AddChain(id, ChainOf(link, views_));
    }
  }

  void AddChain(LinkId id, Polyline3d chain) {
    chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
    int joint = graph_.links[id].node0;
    for (size_t i = 1; i < chain.size(); ++i) {
      const int next = i + 1 == chain.size() ? graph_.links[id].node1 : num_joints_++;
      pieces_.push_back({id, chain[i - 1], chain[i], {joint, next}, {}});
      joint = next;
    }
  }

  void AddLine(size_t index) {
    Piece& piece = pieces_[index];
    const DrawingLink& link = graph_.links[piece.link];
    LimapLine line = {index, piece.start, piece.end, {}, Uncertainty(link)};
    for (const ViewId id : link.supporting_views) {
      const View& view = views_[id];
      const size_t place = view.model_index;
      auto segment = SegmentIn(view, made_.model.cameras[view.camera_index], piece);
      if (!segment) continue;
      segment->line = index;
      std::vector<LimapSegment>& segments = made_.structures.images[place].segments;
      const auto number = static_cast<uint32_t>(segments.size());
      line.track.push_back({made_.model.images[place].id, number});
      piece.segment_of_image.emplace(place, number);
      segments.push_back(*segment);
    }
    made_.structures.lines.push_back(std::move(line));
  }

  void AddJoints() {
    std::vector<std::vector<size_t>> pieces_at(num_joints_);
    for (size_t i = 0; i < pieces_.size(); ++i) {
      for (const int joint : pieces_[i].joints) pieces_at[joint].push_back(i);
    }
    uint64_t next_id = NextPointId(made_.model);
    for (int joint = 0; joint < num_joints_; ++joint) {
      if (pieces_at[joint].size() > 1 && AddJoint(joint, pieces_at[joint], next_id)) ++next_id;
    }
  }

  // Whether two images show it.
  bool AddJoint(int joint, const std::vector<size_t>& pieces, uint64_t id) {
    ModelPoint point;
    point.id = id;
    const Piece& first = pieces_[pieces.front()];
    point.position = first.joints[0] == joint ? first.start : first.end;
    point.error = 0;
    std::map<size_t, std::vector<size_t>> pieces_in_image;
    for (const size_t piece : pieces) {
      for (const auto& [place, segment] : pieces_[piece].segment_of_image) {
        pieces_in_image[place].push_back(piece);
      }
    }
    std::erase_if(pieces_in_image, [&](const auto& item) {
      return !view_of_image_[item.first]->Project(point.position);
    });
    if (pieces_in_image.size() < 2) return false;
    std::map<size_t, double> num_images;  // of each piece, that show it at this point
    for (const size_t piece : pieces) num_images[piece] = 0;
    for (const auto& [place, seen] : pieces_in_image) {
      AddObservation(place, &point);
      for (const size_t piece : seen) {
        made_.structures.images[place].wireframe.push_back(
            {point.track.back().observation, pieces_[piece].segment_of_image.at(place), 1});
        ++num_images[piece];
      }
    }
    for (const auto& [piece, count] : num_images) {
      made_.structures.wireframe.push_back({id, piece, count});
    }
    made_.model.points.push_back(std::move(point));
    return true;
  }

  // Precondition: the image shows the point.
  void AddObservation(size_t place, ModelPoint* point) {
    const View& view = *view_of_image_[place];
    const Eigen::Vector2d pixel = view.Project(point->position).value();
    ModelImage& image = made_.model.images[place];
    point->track.push_back({image.id, static_cast<uint32_t>(image.observations.size())});
    image.observations.push_back(
        {ModelPixel(view, made_.model.cameras[view.camera_index], pixel), point->id});
  }

  DrawingGraph graph_;
  const std::vector<View>& views_;
  std::vector<const View*> view_of_image_;  // of the model
  int num_joints_ = 0;                      // those of nodes first
  std::vector<Piece> pieces_;
  LimapModel made_;
};

// Where the lines of a wireframe end.
class LineEnds {
 public:
  explicit LineEnds(const LimapModel& limap) {
    for (const ModelPoint& point : limap.model.points) position_.emplace(point.id, point.position);
    for (const auto& incidence : limap.structures.wireframe) {
      if (!position_.contains(incidence.point)) {
        throw IoError(limap.model.folder.string(), "the wireframe has a 3D point " +
                                                       std::to_string(incidence.point) +
                                                       ", which the model has not");
      }
      points_of_line_[incidence.line].push_back(incidence.point);
    }
  }

  // The point of the wireframe at each end of a line; kNoPoint3D: none.
  std::array<uint64_t, 2> PointsAt(const LimapLine& line) const {
    std::array<uint64_t, 2> points = {kNoPoint3D, kNoPoint3D};
    const auto of_line = points_of_line_.find(line.id);
    if (of_line == points_of_line_.end()) return points;
    std::array<double, 2> distance = {};
    for (const int end : {0, 1}) {
      distance[end] = std::max(line.uncertainty, 0.0);
      for (const uint64_t point : of_line->second) {
        const double found = (position_.at(point) - (end == 0 ? line.start : line.end)).norm();
        if (found > distance[end]) continue;
        distance[end] = found;
        points[end] = point;
      }
    }
    // Of a line as short as it is uncertain, one end is there.
    const bool has_both = points[0] != kNoPoint3D && points[1] != kNoPoint3D;
    if (has_both && Position(points[0]) == Position(points[1])) {
      points[distance[0] <= distance[1] ? 1 : 0] = kNoPoint3D;
    }
    return points;
  }

  const Eigen::Vector3d& Position(uint64_t point) const { return position_.at(point); }

 private:
  std::unordered_map<uint64_t, Eigen::Vector3d> position_;
  std::unordered_map<uint64_t, std::vector<uint64_t>> points_of_line_;
};

class DrawingMaker {
 public:
  static constexpr ViewId kNoView = -1;

  DrawingMaker(const LimapModel& limap, const std::vector<std::string>& view_names)
      : limap_(limap), ends_(limap) {
    std::map<std::string, uint32_t> id_of_name;
    for (const ModelImage& image : limap.model.images) {
      id_of_name.emplace(image.name, image.id);
      view_of_image_.emplace(image.id, kNoView);
    }
    std::vector<std::string>& names = made_.metadata.view_names;
    names = view_names;
    if (names.empty()) {
      for (const auto& [name, id] : id_of_name) names.push_back(name);
    }
    for (size_t v = 0; v < names.size(); ++v) {
      const auto found = id_of_name.find(names[v]);
      if (found == id_of_name.end()) {
        throw IoError(limap.model.folder.string(), "the model has no image " + names[v]);
      }
      view_of_image_[found->second] = static_cast<ViewId>(v);
    }
  }

  DrawingFile Make() {
    for (const LimapLine& line : limap_.structures.lines) {
      if (line.start != line.end) AddLink(line);
    }
    RebuildIncidence(&made_.graph);
    return std::move(made_);
  }

 private:
  void AddLink(const LimapLine& line) {
    const std::array<uint64_t, 2> points = ends_.PointsAt(line);
    DrawingLink link;
    link.node0 = NodeAt(points[0], line.start);
    link.node1 = NodeAt(points[1], line.end);
    const Eigen::Vector3d& start = made_.graph.nodes[link.node0].position_in_world;
    const Eigen::Vector3d& end = made_.graph.nodes[link.node1].position_in_world;
    link.points_in_world = {start, end};
    link.sigma.assign(
        2, line.uncertainty > 0 ? line.uncertainty : std::numeric_limits<double>::infinity());
    link.supporting_views = ViewsOf(line);
    link.primitive = LinkPrimitive{LineSegment{start, end}};
    made_.graph.links.push_back(std::move(link));
  }

  // The node of a point, or a new one of its own.
  NodeId NodeAt(uint64_t point, const Eigen::Vector3d& end) {
    const auto next = static_cast<NodeId>(made_.graph.nodes.size());
    if (point != kNoPoint3D) {
      const auto [found, is_new] = node_of_point_.emplace(point, next);
      if (!is_new) return found->second;
    }
    DrawingNode node;
    node.position_in_world = point == kNoPoint3D ? end : ends_.Position(point);
    made_.graph.nodes.push_back(std::move(node));
    return next;
  }

  std::vector<ViewId> ViewsOf(const LimapLine& line) const {
    std::vector<ViewId> views;
    for (const LimapTrackElement& element : line.track) {
      const auto view = view_of_image_.find(element.image_id);
      if (view == view_of_image_.end()) {
        throw IoError(limap_.model.folder.string(),
                      "line " + std::to_string(line.id) + " has a track in an image " +
                          std::to_string(element.image_id) + ", which the model has not");
      }
      if (view->second != kNoView) views.push_back(view->second);
    }
    std::sort(views.begin(), views.end());
    views.erase(std::unique(views.begin(), views.end()), views.end());
    return views;
  }

  const LimapModel& limap_;
  LineEnds ends_;
  std::unordered_map<uint32_t, ViewId> view_of_image_;
  std::unordered_map<uint64_t, NodeId> node_of_point_;
  DrawingFile made_;
};

}  // namespace

LimapModel ToLimap(DrawingFile drawing, SparseModel model, const std::vector<View>& views,
                   bool chains) {
  CheckPinholes(model);
  return LimapMaker(std::move(drawing), std::move(model), views).Make(chains);
}

DrawingFile FromLimap(const LimapModel& limap, const std::vector<std::string>& view_names) {
  return DrawingMaker(limap, view_names).Make();
}

bool HoldsLimapDrawing(const fs::path& folder) {
  const fs::path lines = FindLimapLines(folder);
  if (lines.empty()) return false;
  const fs::path structures = fs::weakly_canonical(lines.parent_path());
  return structures.filename() == "structures" && HoldsColmapModel(structures.parent_path());
}

DrawingFile ReadLimapDrawing(const fs::path& folder, const std::vector<std::string>& view_names) {
  const fs::path lines = FindLimapLines(folder);
  if (lines.empty()) {
    throw IoError(folder.string(),
                  "is not a drawing: a folder without structures of LIMAP (lines3D.bin or .txt)");
  }
  const fs::path structures = fs::weakly_canonical(lines.parent_path());
  return FromLimap({ReadColmapModel(structures.parent_path()), ReadLimapStructures(structures)},
                   view_names);
}

}  // namespace limn::colmap_ext
