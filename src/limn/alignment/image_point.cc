// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/image_point.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "limn/util/errors.h"
#include "limn/util/number_text.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

// Links whose distances differ by less are equally near: the one in front is meant.
constexpr double kSamePlacePx = 1;

struct Candidate {
  DrawingPlace place;
  double sigma = 0;                                    // of the link
  Eigen::Vector3d along_px = Eigen::Vector3d::Zero();  // the way along it that is a pixel long
  double depth = 0;
  bool is_supported = false;
};

// A point of a link as the photograph shows it.
struct SeenPoint {
  Eigen::Vector2d pixel;
  double depth = 0;
};

std::optional<SeenPoint> See(const View& view, const Eigen::Vector3d& point) {
  const auto pixel = view.Project(point);
  const auto stored = pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
  if (!stored) return std::nullopt;
  return SeenPoint{*stored, (view.cam_from_world * point).z()};
}

double Mix(double a, double b, double share) { return a + share * (b - a); }

// Unknown where one of them is.
double MixSigmas(double a, double b, double share) {
  return std::isfinite(a) && std::isfinite(b) ? Mix(a, b, share) : std::max(a, b);
}

Eigen::Vector3d PointOn(const DrawingLink& link, size_t i, double share) {
  return link.points_in_world[i] + share * (link.points_in_world[i + 1] - link.points_in_world[i]);
}

// Of a segment, by shares of its length.
struct Piece {
  double begin = 0, end = 1;
};

// Segments that are long in the image, or that it shows in part, are taken in pieces.
int NumPieces(const std::optional<SeenPoint>& a, const std::optional<SeenPoint>& b) {
  constexpr double kLongPx = 20;
  constexpr int kMostPieces = 64;
  if (!a || !b) return kMostPieces;
  return std::clamp(static_cast<int>((b->pixel - a->pixel).norm() / kLongPx), 1, kMostPieces);
}

// The nearest place on a piece of a segment. In space it is not where it is in the image: what is
// nearer to the camera is longer there.
Candidate NearestOnPiece(const DrawingLink& link, size_t i, const Piece& piece, const SeenPoint& a,
                         const SeenPoint& b, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d along = b.pixel - a.pixel;
  const double square = along.squaredNorm();
  const double in_image =
      square > 0 ? std::clamp((pixel - a.pixel).dot(along) / square, 0.0, 1.0) : 0.0;
  const double on_piece = in_image * a.depth / (b.depth + in_image * (a.depth - b.depth));
  const double in_space = Mix(piece.begin, piece.end, on_piece);
  Candidate found;
  found.place.position = PointOn(link, i, in_space);
  found.place.distance_px = (a.pixel + in_image * along - pixel).norm();
  found.depth = Mix(a.depth, b.depth, on_piece);
  // Where it is seen end on, all of the piece.
  found.along_px = (PointOn(link, i, piece.end) - PointOn(link, i, piece.begin)) /
                   std::max(1.0, std::sqrt(square));
  const bool is_known = !link.sigma.empty() && link.kind != LinkKind::kContour;
  if (is_known) found.sigma = MixSigmas(link.sigma[i], link.sigma[i + 1], in_space);
  return found;
}

std::optional<Candidate> NearestOnLink(const DrawingLink& link, const View& view,
                                       const Eigen::Vector2d& pixel) {
  std::optional<Candidate> best;
  std::optional<SeenPoint> before = See(view, link.points_in_world.front());
  for (size_t i = 0; i + 1 < link.points_in_world.size(); ++i) {
    const std::optional<SeenPoint> end = See(view, link.points_in_world[i + 1]);
    const int num_pieces = NumPieces(before, end);
    for (int k = 1; k <= num_pieces; ++k) {
      const Piece piece = {(k - 1.0) / num_pieces, static_cast<double>(k) / num_pieces};
      const auto here = k < num_pieces ? See(view, PointOn(link, i, piece.end)) : end;
      if (before && here) {
        const Candidate found = NearestOnPiece(link, i, piece, *before, *here, pixel);
        if (!best || found.place.distance_px < best->place.distance_px) best = found;
      }
      before = here;
    }
  }
  return best;
}

Eigen::Matrix3d CovarianceOf(const Candidate& found) {
  if (!std::isfinite(found.sigma) || !(found.sigma > 0)) return Eigen::Matrix3d::Zero();
  return found.sigma * found.sigma * Eigen::Matrix3d::Identity() +
         kClickSigmaPx * kClickSigmaPx * found.along_px * found.along_px.transpose();
}

std::vector<Candidate> CandidatesAt(const Eigen::Vector2d& pixel, const View& view, ViewId id,
                                    const DrawingGraph& graph) {
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < graph.links.size(); ++i) {
    auto found = NearestOnLink(graph.links[i], view, pixel);
    if (!found || found->place.distance_px > kMaxSnapPx) continue;
    found->place.link = static_cast<LinkId>(i);
    found->is_supported = std::ranges::count(graph.links[i].supporting_views, id) > 0;
    candidates.push_back(*found);
  }
  return candidates;
}

}  // namespace

std::string TextOf(const ImagePoint& point) {
  return Printable(point.image) + " " + NumberText(point.pixel.x()) + "," +
         NumberText(point.pixel.y());
}

DrawingPlace SnapToDrawing(const ImagePoint& point, const View& view, ViewId id,
                           const DrawingGraph& graph) {
  // The middle of the top-left pixel is (0, 0) in views.
  const Eigen::Vector2d pixel = point.pixel - Eigen::Vector2d(0.5, 0.5);
  std::vector<Candidate> candidates = CandidatesAt(pixel, view, id, graph);
  const bool has_supported =
      std::ranges::any_of(candidates, [](const Candidate& one) { return one.is_supported; });
  std::erase_if(candidates,
                [&](const Candidate& one) { return has_supported && !one.is_supported; });
  if (candidates.empty()) {
    throw InputError("no link of the drawing is within " + ShortNumber(kMaxSnapPx) + " px of " +
                     TextOf(point));
  }
  const auto distance = [](const Candidate& one) { return one.place.distance_px; };
  const double least = std::ranges::min(candidates, {}, distance).place.distance_px;
  std::erase_if(candidates,
                [&](const Candidate& one) { return distance(one) > least + kSamePlacePx; });
  Candidate found = std::ranges::min(candidates, {}, &Candidate::depth);
  found.place.covariance = CovarianceOf(found);
  return found.place;
}

}  // namespace limn
