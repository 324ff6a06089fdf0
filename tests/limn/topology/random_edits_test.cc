// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "limn/topology/editor_fixture.h"
#include "limn/topology/link_geometry.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::ExpectSound;

// A random graph and its random edits. Keeps count of the samples that must be in the links.
class RandomEdits {
 public:
  explicit RandomEdits(unsigned seed) : random_(seed), editor_(&graph_) {
    for (int i = 0; i < 12; ++i) AddRandom();
  }

  // One edit; its name.
  std::string Step() {
    using Edit = std::string (RandomEdits::*)();
    static constexpr Edit kEdits[] = {
        &RandomEdits::Add,      &RandomEdits::Split,     &RandomEdits::Split,
        &RandomEdits::Open,     &RandomEdits::EndAt,     &RandomEdits::EndAt,
        &RandomEdits::Free,     &RandomEdits::CutTo,     &RandomEdits::DropOvershoot,
        &RandomEdits::Join,     &RandomEdits::Join,      &RandomEdits::Join,
        &RandomEdits::MoveNode, &RandomEdits::MovePoint, &RandomEdits::Remove,
        &RandomEdits::Keep,     &RandomEdits::Compact};
    const auto edit = kEdits[Int(static_cast<int>(std::size(kEdits)))];
    const std::string name = (this->*edit)();
    if (!name.empty()) ++num_edits_[name];
    return name;
  }

  void ExpectAsCounted(const std::string& what) const {
    ExpectSound(graph_, what);
    std::multiset<SketchSample> found;
    for (const DrawingLink& link : graph_.links) {
      for (const LinkVertex& vertex : link.vertices) {
        found.insert(vertex.samples.begin(), vertex.samples.end());
      }
    }
    ASSERT_EQ(found, samples_) << what;
  }

  const std::map<std::string, int>& num_edits() const { return num_edits_; }

 private:
  int Int(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double Uniform(double low, double high) {
    return testing::UniformDistribution<double>(low, high)(random_);
  }
  // On a small grid, so that points and lines coincide often.
  Vector3d Place() {
    return {static_cast<double>(Int(5)), static_cast<double>(Int(5)), static_cast<double>(Int(3))};
  }

  // -1 if there is none.
  LinkId SomeLink(bool closed_only = false) {
    std::vector<LinkId> links;
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      if (editor_.IsLink(id) && (!closed_only || editor_.link(id).closed)) links.push_back(id);
    }
    return links.empty() ? -1 : links[Int(static_cast<int>(links.size()))];
  }
  NodeId SomeNode() {
    std::vector<NodeId> nodes;
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      if (editor_.IsNode(id)) nodes.push_back(id);
    }
    return nodes.empty() ? -1 : nodes[Int(static_cast<int>(nodes.size()))];
  }

  void AddRandom() {
    DrawingLink link;
    const int curve = num_curves_++;
    const int size = 2 + Int(6);
    for (int k = 0; k < size; ++k) {
      Vector3d point = Place();
      while (k > 0 && point == link.points_in_world.back()) point = Place();
      link.points_in_world.push_back(point);
    }
    // At a node, and back to where it begins; no point twice in a row.
    Polyline3d& points = link.points_in_world;
    const NodeId node = Int(3) == 0 ? SomeNode() : -1;
    if (node >= 0 && editor_.node(node).position_in_world != points[1]) {
      link.node0 = node;
      points.front() = editor_.node(node).position_in_world;
    }
    if (size > 3 && Int(3) == 0 && points.front() != points[size - 2]) {
      points.back() = points.front();
    }
    for (int k = 0; k < size; ++k) {
      const SketchSample sample = {curve, k};
      link.sigma.push_back(k);
      link.vertices.push_back({Eigen::Matrix3d::Identity(), 1, 0, {{curve % 5, k}}, {sample}});
      samples_.insert(sample);
    }
    editor_.Add(std::move(link));
  }

  std::string Add() {
    if (samples_.size() > 150) return "";
    AddRandom();
    return "Add";
  }

  std::string Split() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    const DrawingLink& link = editor_.link(id);
    if (link.closed) {
      const int index = Int(link.size());
      const Vector3d place = link.points_in_world[index];
      const NodeId node = editor_.Split(id, index);
      EXPECT_EQ(editor_.node(node).position_in_world, place);
      return "Split closed";
    }
    if (link.size() < 3) return "";
    const int index = 1 + Int(link.size() - 2);
    // Parts must have a length.
    const Polyline3d& points = link.points_in_world;
    if (!(Length(Polyline3d(points.begin(), points.begin() + index + 1)) > 0) ||
        !(Length(Polyline3d(points.begin() + index, points.end())) > 0)) {
      return "";
    }
    editor_.Split(id, index);
    return "Split";
  }

  std::string Open() {
    const LinkId id = SomeLink(true);
    if (id < 0) return "";
    editor_.Split(id, Int(editor_.link(id).size()));
    editor_.Free({id, Int(2)});
    return "Open";
  }

  std::string EndAt() {
    const std::vector<LinkEnd> ends = editor_.FreeEnds();
    if (ends.empty()) return "";
    const LinkEnd end = ends[Int(static_cast<int>(ends.size()))];
    const NodeId node = Int(4) == 0 ? editor_.AddNode(Place()) : SomeNode();
    if (node == editor_.NodeAt(end)) return "";
    if (!KeepsLength(end, editor_.node(node).position_in_world)) return "";
    editor_.EndAt(end, node);
    EXPECT_EQ(editor_.NodeAt(end), node);
    return "EndAt";
  }

  // A link of two points does not end where it begins.
  bool KeepsLength(const LinkEnd& end, const Vector3d& place) const {
    const DrawingLink& link = editor_.link(end.link);
    return link.size() > 2 || EndPoint(link, 1 - end.end) != place;
  }

  std::string Free() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    const LinkEnd end = {id, Int(2)};
    editor_.Free(end);
    EXPECT_TRUE(editor_.IsFree(end));
    return "Free";
  }

  std::string CutTo() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    const DrawingLink& link = editor_.link(id);
    const int begin = Int(link.size() - 1);
    const int end = begin + 2 + Int(link.size() - begin - 1);
    const Polyline3d& points = link.points_in_world;
    if (!(Length(Polyline3d(points.begin() + begin, points.begin() + end)) > 0)) return "";
    for (int k = 0; k < link.size(); ++k) {
      if (k >= begin && k < end) continue;
      for (const SketchSample& sample : link.vertices[k].samples) {
        samples_.erase(samples_.find(sample));
      }
    }
    editor_.CutTo(id, begin, end);
    EXPECT_EQ(editor_.link(id).size(), end - begin);
    return "CutTo";
  }

  std::string DropOvershoot() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    editor_.DropOvershoot({id, Int(2)}, Place() + Vector3d(Uniform(0, 1), 0, 0));
    return "DropOvershoot";
  }

  // Of two free ends, or the two that are alone at a node.
  std::string Join() {
    LinkEnd a, b;
    std::string name = "Join";
    if (Int(2) == 0) {
      const NodeId node = SomeNode();
      if (node < 0 || editor_.node(node).Degree() != 2) return "";
      a = editor_.node(node).incident[0];
      b = editor_.node(node).incident[1];
      name += " at a node";
    } else {
      const std::vector<LinkEnd> ends = editor_.FreeEnds();
      if (ends.size() < 2) return "";
      const int i = Int(static_cast<int>(ends.size()));
      int j = Int(static_cast<int>(ends.size()));
      if (i == j) return "";
      if (Int(4) == 0 && editor_.IsFree({ends[i].link, 1 - ends[i].end})) {
        a = ends[i];
        b = {a.link, 1 - a.end};
      } else {
        a = ends[i];
        b = ends[j];
      }
    }
    if (Int(2) == 0) std::swap(a, b);
    const bool is_loop = a.link == b.link;
    const Vector3d far = EndPoint(editor_.link(b.link), 1 - b.end);
    editor_.Join(a, b);
    if (is_loop) {
      EXPECT_TRUE(editor_.link(a.link).closed);
      return name + " to a loop";
    }
    EXPECT_FALSE(editor_.IsLink(b.link));
    const LinkEnd now = editor_.CurrentEnd({b.link, 1 - b.end});
    EXPECT_EQ(EndPoint(editor_.link(now.link), now.end), far);
    return name;
  }

  std::string MoveNode() {
    const NodeId node = SomeNode();
    if (node < 0) return "";
    // Off the grid: no link loses its length.
    editor_.MoveNode(node, Place() + Vector3d(Uniform(0.1, 0.4), 0, Uniform(0.1, 0.4)));
    return "MoveNode";
  }

  std::string MovePoint() {
    const LinkId id = SomeLink();
    if (id < 0 || editor_.link(id).size() < 3) return "";
    editor_.MovePoint(id, 1 + Int(editor_.link(id).size() - 2),
                      Place() + Vector3d(0, Uniform(0.1, 0.4), 0));
    return "MovePoint";
  }

  void Forget(LinkId id) {
    for (const LinkVertex& vertex : editor_.link(id).vertices) {
      for (const SketchSample& sample : vertex.samples) samples_.erase(samples_.find(sample));
    }
  }

  std::string Remove() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    Forget(id);
    editor_.Remove(id);
    return "Remove";
  }

  std::string Keep() {
    if (Int(5) != 0) return "";
    std::vector<uint8_t> keep(editor_.NumLinks(), 1);
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      if (Int(6) != 0 || !editor_.IsLink(id)) continue;
      keep[id] = 0;
      Forget(id);
    }
    editor_.Keep(keep);
    return "Keep";
  }

  std::string Compact() {
    if (Int(4) != 0) return "";
    editor_.Compact();
    return "Compact";
  }

  std::mt19937 random_;
  DrawingGraph graph_;
  GraphEditor editor_;
  int num_curves_ = 0;
  std::multiset<SketchSample> samples_;
  std::map<std::string, int> num_edits_;
};

class RandomEditsTest : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomEditsTest, GraphIsSoundAfterEveryEdit) {
  RandomEdits edits(GetParam());
  edits.ExpectAsCounted("the first links");
  if (HasFatalFailure()) return;
  for (int step = 0; step < 1500; ++step) {
    const std::string name = edits.Step();
    edits.ExpectAsCounted("step " + std::to_string(step) + ", " + name);
    if (HasFatalFailure()) return;
  }
  for (const char* name :
       {"Add", "Split", "Split closed", "Open", "EndAt", "Free", "CutTo", "DropOvershoot", "Join",
        "Join at a node", "Join to a loop", "Join at a node to a loop", "MoveNode", "MovePoint",
        "Remove", "Keep", "Compact"}) {
    EXPECT_TRUE(edits.num_edits().contains(name)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEditsTest, ::testing::Range(1u, 13u));

}  // namespace
}  // namespace limn
