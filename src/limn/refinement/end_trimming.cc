#include <algorithm>

#include "limn/geometry/spatial_index.h"
#include "limn/refinement/topology_edits.h"

namespace limn {
namespace {

// Links nearer than this run along each other, px.
constexpr double kBesidePx = 1.2;
// What is left of a link that was cut back must be longer, px.
constexpr int kMinRestPx = 6;

class EndTrimmer {
 public:
  explicit EndTrimmer(GraphEditor* editor)
      : editor_(editor),
        places_(editor->CollectPlaces()),
        index_(places_.position),
        keep_(editor->graph().links.size(), 1) {
    for (const DrawingLink& link : editor->graph().links) {
      rest_.push_back({0, static_cast<int>(link.points_in_world.size())});
    }
  }

  int64_t Run() {
    int64_t num_trimmed = 0;
    for (const LinkEnd& free : editor_->FreeEnds()) num_trimmed += Trim(free);
    for (size_t l = 0; l < keep_.size(); ++l) {
      const bool cut = rest_[l].size() < static_cast<int>(editor_->link(l).points_in_world.size());
      if (keep_[l] && cut) editor_->CutTo(rest_[l].begin, rest_[l].end, static_cast<LinkId>(l));
    }
    editor_->Keep(keep_);
    return num_trimmed;
  }

 private:
  // What is left of a link's points: [begin, end).
  struct Rest {
    int begin = 0;
    int end = 0;

    int size() const { return end - begin; }
    bool Contains(int k) const { return k >= begin && k < end; }
  };

  bool Trim(const LinkEnd& free) {
    Rest& rest = rest_[free.link];
    const int before = rest.size();
    if (free.end == 0) {
      while (rest.size() > 0 && IsBesideAnother(free.link, rest.begin)) ++rest.begin;
    } else {
      while (rest.size() > 0 && IsBesideAnother(free.link, rest.end - 1)) --rest.end;
    }
    if (rest.size() == before) return false;
    keep_[free.link] = rest.size() > kMinRestPx;
    return true;
  }

  bool IsBesideAnother(LinkId id, int k) {
    const Eigen::Vector3d direction = editor_->DirectionAt(id, k);
    index_.FindWithin(editor_->link(id).points_in_world[k], kBesidePx * editor_->FootprintOf(id),
                      &near_);
    return std::any_of(near_.begin(), near_.end(), [&](const SpatialIndex::Neighbor& neighbor) {
      const auto& [other, at] = places_.point[neighbor.index];
      return other != id && keep_[other] && rest_[other].Contains(at) &&
             LineAngleBetween(direction, places_.direction[neighbor.index]) < kMinPartingRad;
    });
  }

  GraphEditor* editor_;
  GraphEditor::Places places_;
  SpatialIndex index_;
  std::vector<uint8_t> keep_;
  std::vector<Rest> rest_;
  std::vector<SpatialIndex::Neighbor> near_;
};

}  // namespace

int64_t TrimEnds(GraphEditor* editor) { return EndTrimmer(editor).Run(); }

}  // namespace limn
