// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/shells.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeFix_Shell.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include "limn/formats/step/border_edges.h"
#include "limn/formats/step/borders.h"
#include "limn/formats/step/faces.h"
#include "limn/formats/step/sheets.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

constexpr double kMaxGapRel = 0.05;

struct MadeSheets {
  FaceBorders borders;
  std::vector<TopoDS_Edge> edges;
  std::vector<TopoDS_Face> faces;  // per sheet of the borders
  std::set<int> apart;
};

std::map<int, int> CountByFace(const std::vector<StepSheet>& sheets) {
  std::map<int, int> counts;
  for (const StepSheet& sheet : sheets) ++counts[sheet.face];
  return counts;
}

// Returns the faces of which a sheet could not be made: half a face is not a face.
std::set<int> MakeFaces(const DrawingGraph& graph, const std::vector<StepSheet>& sheets,
                        MadeSheets* made) {
  std::map<int, int> num_made;
  for (const BorderSheet& sheet : made->borders.sheets) {
    if (const auto face = MakeStepFace(graph, sheet, made->edges, kMaxGapRel)) {
      made->faces.push_back(*face);
      ++num_made[sheet.face];
    }
  }
  std::set<int> failed;
  for (const auto& [face, count] : CountByFace(sheets)) {
    if (num_made[face] != count) failed.insert(face);
  }
  return failed;
}

// What to try after faces have failed: planes with the points of links for curves, then apart; not
// the others.
std::vector<StepSheet> TriedNext(const DrawingGraph& graph, std::vector<StepSheet> sheets,
                                 const std::set<int>& failed, std::set<int>* apart) {
  std::vector<StepSheet> next;
  for (StepSheet& sheet : sheets) {
    if (!failed.contains(sheet.face)) {
      next.push_back(std::move(sheet));
    } else if (apart->erase(sheet.face) > 0 ||
               graph.faces[sheet.face].surface != FaceSurface::kPlane) {
      continue;
    } else if (!sheet.of_points) {
      sheet.of_points = true;
      next.push_back(std::move(sheet));
    } else {
      StepSheet alone = SheetApart(graph, sheet.face);
      if (alone.sides.empty()) continue;
      apart->insert(sheet.face);
      next.push_back(std::move(alone));
    }
  }
  return next;
}

// Edges carry the curves and tolerances of all faces: those of faces that fail must go, and
// everything is made again without these faces, or with borders that are theirs alone.
MadeSheets MakeSheets(const DrawingGraph& graph) {
  std::vector<StepSheet> sheets = SheetsOf(graph);
  std::set<int> apart;
  for (;;) {
    MadeSheets made;
    made.borders = MakeFaceBorders(graph, sheets, kMaxGapRel);
    made.edges = MakeBorderEdges(graph, made.borders);
    const std::set<int> failed = MakeFaces(graph, sheets, &made);
    if (failed.empty()) {
      made.apart = std::move(apart);
      return made;
    }
    sheets = TriedNext(graph, std::move(sheets), failed, &apart);
  }
}

// Sheets that share edges, as lists.
std::vector<std::vector<int>> ConnectedSheets(const FaceBorders& borders) {
  const int count = static_cast<int>(borders.sheets.size());
  UnionFind connected(count);
  std::vector<int> sheet_of_edge(borders.edges.size(), -1);
  for (int s = 0; s < count; ++s) {
    for (const auto& side : borders.sheets[s].sides) {
      for (const BorderStep& step : side) {
        int& other = sheet_of_edge[step.edge];
        if (other >= 0) connected.Union(other, s);
        other = s;
      }
    }
  }
  std::map<int, std::vector<int>> sets;
  for (int s = 0; s < count; ++s) sets[connected.Find(s)].push_back(s);
  std::vector<std::vector<int>> lists;
  for (auto& [first, list] : sets) lists.push_back(std::move(list));
  return lists;
}

TopoDS_Shell ShellOf(const std::vector<TopoDS_Face>& faces) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  shell.Closed(BRep_Tool::IsClosed(shell));
  return shell;
}

std::vector<TopoDS_Shape> ShapesIn(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  std::vector<TopoDS_Shape> shapes;
  for (TopExp_Explorer at(shape, type); at.More(); at.Next()) shapes.push_back(at.Current());
  return shapes;
}

// Faces turned so that neighbors agree; several shells where more than two faces share an edge.
std::vector<TopoDS_Shape> OrientedShells(const TopoDS_Shell& shell) {
  ShapeFix_Shell fix;
  fix.FixFaceOrientation(shell);
  return ShapesIn(fix.Shape(), TopAbs_SHELL);
}

void AddShell(const TopoDS_Shell& shell, StepShells* result) {
  if (BRep_Tool::IsClosed(shell)) {
    TopoDS_Solid solid;
    BRep_Builder builder;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    if (BRepLib::OrientClosedSolid(solid) && BRepCheck_Analyzer(solid).IsValid()) {
      result->solids.push_back(solid);
      return;
    }
  }
  if (BRepCheck_Analyzer(shell).IsValid()) {
    result->shells.push_back(shell);
    return;
  }
  // Each face is valid by itself.
  for (const TopoDS_Shape& face : ShapesIn(shell, TopAbs_FACE)) {
    result->shells.push_back(ShellOf({TopoDS::Face(face)}));
  }
}

double LargestTolerance(const std::vector<TopoDS_Edge>& edges) {
  double largest = 0;
  for (const TopoDS_Edge& edge : edges) {
    largest = std::max(largest, BRep_Tool::Tolerance(edge));
    for (const TopoDS_Shape& vertex : ShapesIn(edge, TopAbs_VERTEX)) {
      largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(vertex)));
    }
  }
  return largest;
}

}  // namespace

StepShells MakeStepShells(const DrawingGraph& graph) {
  const MadeSheets made = MakeSheets(graph);
  StepShells result;
  result.apart.assign(made.apart.begin(), made.apart.end());
  std::vector<bool> is_in(graph.faces.size(), false);
  for (size_t s = 0; s < made.faces.size(); ++s) {
    const int face = made.borders.sheets[s].face;
    result.faces.push_back({made.faces[s], face});
    is_in[face] = true;
  }
  for (size_t f = 0; f < is_in.size(); ++f) {
    if (!is_in[f]) result.left_out.push_back(static_cast<int>(f));
  }
  for (size_t e = 0; e < made.edges.size(); ++e) {
    const int link = made.borders.edges[e].link;
    if (link >= 0) result.edges.push_back({made.edges[e], link});
  }
  for (const std::vector<int>& list : ConnectedSheets(made.borders)) {
    std::vector<TopoDS_Face> faces;
    for (const int sheet : list) faces.push_back(made.faces[sheet]);
    for (const TopoDS_Shape& shell : OrientedShells(ShellOf(faces))) {
      AddShell(TopoDS::Shell(shell), &result);
    }
  }
  result.tolerance = LargestTolerance(made.edges);
  return result;
}

}  // namespace limn
