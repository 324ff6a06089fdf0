// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/true_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "limn/geometry/spatial_index.h"
#include "limn/util/angles.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

const double kMinTurnCosine = std::cos(40 * kDeg);
constexpr int kMinJunctionDegree = 3;
// An end that is this many tolerances from a junction, or less, may be one of its arms.
constexpr double kMaxGap = 16;
const double kMinFacingCosine = std::cos(20 * kDeg);
// Distances equal to the tolerance are within it in spite of rounding.
constexpr double kRounding = 1 + 1e-9;

// A place at which curves may have to be cut or joined.
struct Place {
  Eigen::Vector3d position;
  double tolerance;
};

struct Cut {
  double arc;
  double tolerance;
  bool is_corner;
};

struct Piece {
  int polyline;
  double from, to;
  Polyline3d points;
};

// A place near a segment of the polyline at hand.
struct Approach {
  int place;
  int segment;
  double squared_distance;
  double arc;
};

class ChainFinder {
 public:
  ChainFinder(const CurveSet& truth,
              const std::function<double(const Eigen::Vector3d&)>& tolerance_at)
      : truth_(truth), tolerance_at_(tolerance_at) {}

  TrueChains Find() {
    CutPolylines();
    WeldEnds();
    FindContinuations();
    JoinPieces();
    MakeNodes();
    AddArmsAcrossGaps();
    return std::move(result_);
  }

 private:
  // End 2 * piece is the piece's first point, end 2 * piece + 1 its last one.
  int NumEnds() const { return 2 * static_cast<int>(pieces_.size()); }

  const Eigen::Vector3d& EndPosition(int end) const {
    const Polyline3d& points = pieces_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  // Leaving the end, into its piece.
  Eigen::Vector3d EndDirection(int end) const {
    return DirectionFromEnd(pieces_[end / 2].points, end % 2 == 1, 0);
  }

  void CutPolylines() {
    std::vector<Place> places;
    for (const Polyline3d& polyline : truth_.polylines) {
      if (!(Length(polyline) > 0)) continue;
      for (const Eigen::Vector3d& end : {polyline.front(), polyline.back()}) {
        places.push_back({end, tolerance_at_(end)});
      }
    }
    for (const CurveNode& node : truth_.nodes) {
      places.push_back({node.position_in_world, tolerance_at_(node.position_in_world)});
    }
    std::vector<Eigen::Vector3d> positions;
    double widest = 0;
    for (const Place& place : places) {
      positions.push_back(place.position);
      widest = std::max(widest, place.tolerance);
    }
    const SpatialIndex index(positions);
    for (size_t i = 0; i < truth_.polylines.size(); ++i) {
      const Polyline3d& polyline = truth_.polylines[i];
      const std::vector<double> lengths = CumulativeLength(polyline);
      if (lengths.empty() || !(lengths.back() > 0)) continue;
      std::vector<Cut> cuts = Corners(polyline, lengths);
      AddMeetings(polyline, lengths, places, index, widest, &cuts);
      AddPieces(static_cast<int>(i), lengths.back(), std::move(cuts));
    }
  }

  // Interior vertices at which the polyline turns too much.
  std::vector<Cut> Corners(const Polyline3d& polyline, const std::vector<double>& lengths) const {
    std::vector<Cut> cuts;
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (size_t i = 0; i + 1 < polyline.size(); ++i) {
      const Eigen::Vector3d segment = polyline[i + 1] - polyline[i];
      if (!(segment.norm() > 0)) continue;
      const Eigen::Vector3d direction = segment.normalized();
      if (!before.isZero() && before.dot(direction) < kMinTurnCosine) {
        cuts.push_back({lengths[i], tolerance_at_(polyline[i]), true});
      }
      before = direction;
    }
    return cuts;
  }

  // Where the polyline passes a place: once for every time it comes near.
  static void AddMeetings(const Polyline3d& polyline, const std::vector<double>& lengths,
                          const std::vector<Place>& places, const SpatialIndex& index,
                          double widest, std::vector<Cut>* cuts) {
    std::vector<Approach> approaches;
    std::vector<SpatialIndex::Neighbor> found;
    for (size_t i = 0; i + 1 < polyline.size(); ++i) {
      const double length = lengths[i + 1] - lengths[i];
      const Eigen::Vector3d middle = 0.5 * (polyline[i] + polyline[i + 1]);
      index.FindWithin(middle, kRounding * (0.5 * length + widest), &found);
      for (const SpatialIndex::Neighbor& neighbor : found) {
        const Place& place = places[neighbor.index];
        const PolylinePoint foot = ClosestPoint(std::span(&polyline[i], 2), place.position);
        if (std::sqrt(foot.squared_distance) > place.tolerance) continue;
        approaches.push_back({neighbor.index, static_cast<int>(i), foot.squared_distance,
                              lengths[i] + foot.t * length});
      }
    }
    std::sort(approaches.begin(), approaches.end(), [](const Approach& a, const Approach& b) {
      return std::tie(a.place, a.segment) < std::tie(b.place, b.segment);
    });
    for (size_t begin = 0, end = 0; begin < approaches.size(); begin = end) {
      size_t best = begin;
      for (end = begin + 1;
           end < approaches.size() && approaches[end].place == approaches[begin].place &&
           approaches[end].segment == approaches[end - 1].segment + 1;
           ++end) {
        if (approaches[end].squared_distance < approaches[best].squared_distance) best = end;
      }
      cuts->push_back({approaches[best].arc, places[approaches[best].place].tolerance, false});
    }
  }

  // Cuts nearer to an end or to each other than the tolerance are one; a corner stays where it is.
  void AddPieces(int polyline, double length, std::vector<Cut> cuts) {
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.arc < b.arc; });
    std::vector<Cut> kept;
    for (const Cut& cut : cuts) {
      if (cut.arc <= cut.tolerance || cut.arc >= length - cut.tolerance) continue;
      if (kept.empty() || cut.arc - kept.back().arc > cut.tolerance) {
        kept.push_back(cut);
      } else if (cut.is_corner && !kept.back().is_corner) {
        kept.back() = cut;
      }
    }
    double from = 0;
    kept.push_back({length, 0, false});
    for (const Cut& cut : kept) {
      pieces_.push_back(
          {polyline, from, cut.arc, CutPolyline(truth_.polylines[polyline], from, cut.arc)});
      from = cut.arc;
    }
  }

  // Ends of pieces, then the truth's own nodes, in sets of common place.
  void WeldEnds() {
    std::vector<Eigen::Vector3d> positions;
    for (int end = 0; end < NumEnds(); ++end) positions.push_back(EndPosition(end));
    for (const CurveNode& node : truth_.nodes) positions.push_back(node.position_in_world);
    const SpatialIndex index(positions);
    UnionFind sets(static_cast<int>(positions.size()));
    std::vector<SpatialIndex::Neighbor> found;
    for (size_t i = 0; i < positions.size(); ++i) {
      index.FindWithin(positions[i], kRounding * tolerance_at_(positions[i]), &found);
      for (const SpatialIndex::Neighbor& other : found)
        sets.Union(static_cast<int>(i), other.index);
    }
    place_of_.resize(positions.size());
    for (size_t i = 0; i < positions.size(); ++i) place_of_[i] = sets.Find(static_cast<int>(i));
  }

  // A piece with both ends at one place and no room for a loop leaves it in no direction.
  bool IsArm(int end) const {
    const Piece& piece = pieces_[end / 2];
    return place_of_[end] != place_of_[end ^ 1] ||
           piece.to - piece.from > 2 * tolerance_at_(EndPosition(end));
  }

  // Per end, the end of another piece with which the chain continues, or -1.
  void FindContinuations() {
    continuation_.assign(NumEnds(), -1);
    std::set<int> own_junctions;
    for (size_t i = 0; i < truth_.nodes.size(); ++i) {
      if (truth_.nodes[i].degree >= kMinJunctionDegree)
        own_junctions.insert(place_of_[NumEnds() + i]);
    }
    std::map<int, std::vector<int>> arms_at;
    for (int end = 0; end < NumEnds(); ++end) {
      if (IsArm(end)) arms_at[place_of_[end]].push_back(end);
    }
    for (const auto& [place, arms] : arms_at) {
      if (arms.size() != 2 || own_junctions.contains(place)) continue;
      if (-EndDirection(arms[0]).dot(EndDirection(arms[1])) < kMinTurnCosine) continue;
      continuation_[arms[0]] = arms[1];
      continuation_[arms[1]] = arms[0];
    }
  }

  void JoinPieces() {
    result_.pieces.resize(truth_.polylines.size());
    is_joined_.assign(pieces_.size(), false);
    chain_ends_.clear();
    placed_.resize(pieces_.size());
    for (int end = 0; end < NumEnds(); ++end) {
      if (continuation_[end] < 0 && !is_joined_[end / 2]) JoinFrom(end);
    }
    for (int end = 0; end < NumEnds(); end += 2) {
      if (!is_joined_[end / 2]) JoinFrom(end);  // a loop
    }
    for (size_t i = 0; i < pieces_.size(); ++i) {
      result_.pieces[pieces_[i].polyline].push_back(placed_[i]);
    }
  }

  void JoinFrom(int end) {
    TrueChain chain;
    const int first = end;
    int last = -1;
    for (; end >= 0 && !is_joined_[end / 2]; end = continuation_[last]) {
      const Piece& piece = pieces_[end / 2];
      is_joined_[end / 2] = true;
      placed_[end / 2] = {piece.from, piece.to, static_cast<int>(result_.chains.size()),
                          chain.length, end % 2 == 1};
      Polyline3d points = piece.points;
      if (end % 2 == 1) std::reverse(points.begin(), points.end());
      chain.points.insert(chain.points.end(), points.begin() + (chain.points.empty() ? 0 : 1),
                          points.end());
      chain.length += piece.to - piece.from;
      last = end ^ 1;
    }
    const bool is_closed = continuation_[first] >= 0;
    chain_ends_.push_back(is_closed ? std::array{-1, -1} : std::array{first, last});
    result_.chains.push_back(std::move(chain));
  }

  void MakeNodes() {
    std::map<int, TrueNode> node_at;
    for (size_t i = 0; i < truth_.nodes.size(); ++i) {
      TrueNode& node = node_at[place_of_[NumEnds() + i]];
      if (truth_.nodes[i].degree <= node.degree) continue;
      node.degree = truth_.nodes[i].degree;
      node.kind = truth_.nodes[i].kind;
      node.position_in_world = truth_.nodes[i].position_in_world;
    }
    for (size_t chain = 0; chain < chain_ends_.size(); ++chain) {
      for (const bool from_end : {false, true}) {
        const int end = chain_ends_[chain][from_end];
        if (end < 0) continue;
        TrueNode& node = node_at[place_of_[end]];
        if (node.degree == 0 && node.arms.empty()) node.position_in_world = EndPosition(end);
        if (IsArm(end)) node.arms.push_back({static_cast<int>(chain), from_end});
      }
    }
    for (auto& [place, node] : node_at) {
      if (truth_.nodes.empty()) node.degree = static_cast<int>(node.arms.size());
      result_.nodes.push_back(std::move(node));
    }
  }

  struct FacingArm {
    double gap;
    TrueArm arm;
    Eigen::Vector3d direction;
  };

  Eigen::Vector3d ArmPosition(const TrueArm& arm) const {
    const Polyline3d& points = result_.chains[arm.chain].points;
    return arm.from_end ? points.back() : points.front();
  }

  // A truth of what images show has gaps where curves meet: its own junctions say how many arms
  // they have.
  void AddArmsAcrossGaps() {
    std::vector<TrueArm> ends;
    std::vector<Eigen::Vector3d> positions;
    for (const TrueNode& node : result_.nodes) {
      if (node.arms.size() != 1) continue;
      ends.push_back(node.arms.front());
      positions.push_back(ArmPosition(ends.back()));
    }
    const SpatialIndex index(positions);
    std::vector<SpatialIndex::Neighbor> found;
    for (TrueNode& node : result_.nodes) {
      if (node.degree < kMinJunctionDegree || node.degree <= static_cast<int>(node.arms.size()))
        continue;
      const double tolerance = tolerance_at_(node.position_in_world);
      index.FindWithin(node.position_in_world, kRounding * kMaxGap * tolerance, &found);
      std::vector<FacingArm> facing;
      for (const SpatialIndex::Neighbor& end : found) {
        const double gap = std::sqrt(end.squared_distance);
        if (gap <= tolerance) continue;  // its own arm
        const TrueArm& arm = ends[end.index];
        const Eigen::Vector3d direction =
            DirectionFromEnd(result_.chains[arm.chain].points, arm.from_end, kMaxGap * tolerance);
        const Eigen::Vector3d across = positions[end.index] - node.position_in_world;
        if (across.dot(direction) < kMinFacingCosine * gap) continue;
        facing.push_back({gap, arm, direction});
      }
      std::stable_sort(facing.begin(), facing.end(),
                       [](const FacingArm& a, const FacingArm& b) { return a.gap < b.gap; });
      AddFacingArms(facing, kMaxGap * tolerance, &node);
    }
  }

  // The nearest ones in new directions, up to the node's degree.
  void AddFacingArms(const std::vector<FacingArm>& facing, double reach, TrueNode* node) const {
    std::vector<Eigen::Vector3d> directions;
    for (const TrueArm& arm : node->arms) {
      directions.push_back(DirectionFromEnd(result_.chains[arm.chain].points, arm.from_end, reach));
    }
    for (const FacingArm& candidate : facing) {
      if (node->degree <= static_cast<int>(node->arms.size())) return;
      const bool is_new =
          std::none_of(directions.begin(), directions.end(), [&](const Eigen::Vector3d& direction) {
            return direction.dot(candidate.direction) > kMinFacingCosine;
          });
      if (!is_new) continue;
      directions.push_back(candidate.direction);
      node->arms.push_back(candidate.arm);
    }
  }

  const CurveSet& truth_;
  const std::function<double(const Eigen::Vector3d&)>& tolerance_at_;
  std::vector<Piece> pieces_;
  std::vector<int> place_of_;
  std::vector<int> continuation_;
  std::vector<bool> is_joined_;
  std::vector<TruePiece> placed_;
  std::vector<std::array<int, 2>> chain_ends_;
  TrueChains result_;
};

}  // namespace

TrueChains FindTrueChains(const CurveSet& truth,
                          const std::function<double(const Eigen::Vector3d&)>& tolerance_at) {
  return ChainFinder(truth, tolerance_at).Find();
}

std::vector<ChainPlace> PlacesOnChains(const TrueChains& chains, const CurveSamples& samples) {
  std::vector<ChainPlace> places(samples.size());
  int first = 0;
  size_t piece = 0;
  for (int i = 0; i < samples.size(); ++i) {
    if (samples.IsFirst(i)) {
      first = i;
      piece = 0;
    }
    const size_t polyline = samples.CurveOf(i);
    if (polyline >= chains.pieces.size() || chains.pieces[polyline].empty()) continue;
    const std::vector<TruePiece>& pieces = chains.pieces[polyline];
    const double arc = (i - first + 0.5) * samples.Weight(i);
    while (piece + 1 < pieces.size() && arc > pieces[piece].to) ++piece;
    places[i] = {pieces[piece].chain, pieces[piece].ToChain(arc)};
  }
  return places;
}

Eigen::Vector3d DirectionFromEnd(const Polyline3d& points, bool from_end, double reach) {
  const int count = static_cast<int>(points.size());
  const auto point = [&](int i) { return points[from_end ? count - 1 - i : i]; };
  double arc = 0;
  Eigen::Vector3d chord = Eigen::Vector3d::Zero();
  for (int i = 1; i < count && (arc < reach || chord.isZero(0)); ++i) {
    const Eigen::Vector3d segment = point(i) - point(i - 1);
    const double length = segment.norm();
    const double t = length > 0 && reach > arc ? std::min(1.0, (reach - arc) / length) : 1.0;
    chord = point(i - 1) + t * segment - point(0);
    arc += length;
  }
  const double length = chord.norm();
  return length > 0 ? Eigen::Vector3d(chord / length) : Eigen::Vector3d::Zero();
}

}  // namespace limn
