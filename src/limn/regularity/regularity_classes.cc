#include "limn/regularity/regularity_classes.h"

#include <algorithm>

namespace limn {
namespace {

template <class Evidence>
void Drop(const std::set<LinkId>& links, const std::vector<Evidence>& evidence,
          std::vector<int>* members) {
  std::erase_if(*members, [&](int i) { return links.contains(evidence[i].link); });
}

template <class Evidence>
void Insert(const std::vector<int>& members, const std::vector<Evidence>& evidence,
            std::set<LinkId>* links) {
  for (const int i : members) links->insert(evidence[i].link);
}

// Removes directions of fewer than two lines; others refer to the rest by new indices.
void RemoveSmallDirections(RegularityClasses* classes) {
  std::vector<DirectionClass>& directions = classes->directions;
  std::vector<int> index(directions.size(), -1);
  int count = 0;
  for (size_t c = 0; c < directions.size(); ++c) {
    if (directions[c].lines.size() >= 2) index[c] = count++;
  }
  std::erase_if(directions, [](const DirectionClass& of) { return of.lines.size() < 2; });
  for (DirectionClass& of : directions) {
    std::erase_if(of.orthogonal_to, [&](int other) { return index[other] < 0; });
    for (int& other : of.orthogonal_to) other = index[other];
  }
  for (PlaneClass& of : classes->planes) {
    if (of.normal_class >= 0) of.normal_class = index[of.normal_class];
  }
}

}  // namespace

std::set<LinkId> MembersOf(const RegularityClasses& classes, const DrawingEvidence& evidence) {
  std::set<LinkId> links;
  for (const auto& of : classes.directions) Insert(of.lines, evidence.lines, &links);
  for (const auto& of : classes.planes) {
    Insert(of.lines, evidence.lines, &links);
    Insert(of.arcs, evidence.arcs, &links);
  }
  for (const auto& of : classes.radii) Insert(of.arcs, evidence.arcs, &links);
  for (const auto& of : classes.axes) Insert(of.arcs, evidence.arcs, &links);
  return links;
}

void LetGo(const std::set<LinkId>& links, const DrawingEvidence& evidence,
           RegularityClasses* classes) {
  for (auto& of : classes->directions) Drop(links, evidence.lines, &of.lines);
  for (auto& of : classes->planes) {
    Drop(links, evidence.lines, &of.lines);
    Drop(links, evidence.arcs, &of.arcs);
  }
  for (auto& of : classes->radii) Drop(links, evidence.arcs, &of.arcs);
  for (auto& of : classes->axes) Drop(links, evidence.arcs, &of.arcs);
  std::erase_if(classes->planes,
                [](const PlaneClass& of) { return of.lines.size() + of.arcs.size() < 3; });
  std::erase_if(classes->radii, [](const RadiusClass& of) { return of.arcs.size() < 2; });
  std::erase_if(classes->axes, [](const AxisClass& of) { return of.arcs.size() < 2; });
  RemoveSmallDirections(classes);
}

}  // namespace limn
