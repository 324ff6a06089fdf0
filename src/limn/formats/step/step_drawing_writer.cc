// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/step_drawing_writer.h"

#include <algorithm>
#include <ostream>
#include <string>

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPEdit.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_ApplicationContext.hxx>
#include <StepBasic_ApplicationProtocolDefinition.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepShape_AdvancedBrepShapeRepresentation.hxx>
#include <StepShape_ConnectedEdgeSet.hxx>
#include <StepShape_EdgeBasedWireframeModel.hxx>
#include <StepShape_EdgeBasedWireframeShapeRepresentation.hxx>
#include <StepShape_HArray1OfConnectedEdgeSet.hxx>
#include <StepShape_HArray1OfEdge.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_ManifoldSurfaceShapeRepresentation.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS.hxx>
#include <TopoDSToStep_MakeManifoldSolidBrep.hxx>
#include <TopoDSToStep_MakeShellBasedSurfaceModel.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <Transfer_FinderProcess.hxx>

#include "limn/formats/step/edges.h"
#include "limn/formats/step/occt_versions.h"
#include "limn/formats/step/rods.h"
#include "limn/formats/step/shells.h"
#include "limn/model/drawing_paths.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"
#include "limn/version.h"

namespace limn {
namespace {

using opencascade::handle;

constexpr double kLeastUncertaintyMm = 1e-7;

handle<TCollection_HAsciiString> Text(const std::string& text) {
  return new TCollection_HAsciiString(text.c_str());
}

handle<Interface_HArray1OfHAsciiString> OneText(const std::string& text) {
  handle<Interface_HArray1OfHAsciiString> texts = new Interface_HArray1OfHAsciiString(1, 1);
  texts->SetValue(1, Text(text));
  return texts;
}

handle<StepShape_ConnectedEdgeSet> MakeEdgeSet(const DrawingPath& path, const StepEdges& edges,
                                               const std::string& name) {
  handle<StepShape_HArray1OfEdge> of_path =
      new StepShape_HArray1OfEdge(1, static_cast<int>(path.size()));
  for (size_t i = 0; i < path.size(); ++i) {
    of_path->SetValue(static_cast<int>(i) + 1, edges.of_link[path[i].link]);
  }
  handle<StepShape_ConnectedEdgeSet> edge_set = new StepShape_ConnectedEdgeSet;
  edge_set->Init(Text(name), of_path);
  return edge_set;
}

handle<StepShape_EdgeBasedWireframeModel> MakeWireframe(const std::vector<DrawingPath>& paths,
                                                        const StepEdges& edges) {
  handle<StepShape_HArray1OfConnectedEdgeSet> edge_sets =
      new StepShape_HArray1OfConnectedEdgeSet(1, static_cast<int>(paths.size()));
  for (size_t i = 0; i < paths.size(); ++i) {
    edge_sets->SetValue(static_cast<int>(i) + 1,
                        MakeEdgeSet(paths[i], edges, "path_" + std::to_string(i)));
  }
  handle<StepShape_EdgeBasedWireframeModel> wireframe = new StepShape_EdgeBasedWireframeModel;
  wireframe->Init(Text("drawing"), edge_sets);
  return wireframe;
}

handle<StepShape_ShapeRepresentation> MakeRepresentation(
    const handle<StepShape_EdgeBasedWireframeModel>& wireframe,
    const STEPConstruct_UnitContext& units) {
  handle<StepRepr_HArray1OfRepresentationItem> items =
      new StepRepr_HArray1OfRepresentationItem(1, 1);
  items->SetValue(1, wireframe);
  handle<StepShape_EdgeBasedWireframeShapeRepresentation> representation =
      new StepShape_EdgeBasedWireframeShapeRepresentation;
  representation->Init(Text("drawing"), items, units.Value());
  return representation;
}

// A model and what its products have in common.
class ProductModel {
 public:
  ProductModel() {
    model_->SetProtocol(STEPEdit::Protocol());
    context_->Init(Text("core data for automotive mechanical design processes"));
    handle<StepBasic_ApplicationProtocolDefinition> protocol =
        new StepBasic_ApplicationProtocolDefinition;
    protocol->Init(Text("international standard"), Text("automotive_design"), 2000, context_);
    model_->AddWithRefs(protocol);
  }

  void Add(const char* name, const handle<StepShape_ShapeRepresentation>& representation) {
    model_->AddWithRefs(StepPart(representation, Text(name), context_, model_).SDRValue());
  }

  STEPConstruct_UnitContext Units(double tolerance_mm) const {
    return StepUnits(std::max(kLeastUncertaintyMm, 2 * tolerance_mm), model_);
  }

  // That remembers which entities shapes have become.
  handle<Transfer_FinderProcess> Process() const {
    handle<Transfer_FinderProcess> process = new Transfer_FinderProcess;
    process->SetModel(model_);  // OpenCASCADE 7.8 asks it
    return process;
  }

  const handle<StepData_StepModel>& model() const { return model_; }

 private:
  handle<StepData_StepModel> model_ = new StepData_StepModel;
  handle<StepBasic_ApplicationContext> context_ = new StepBasic_ApplicationContext;
};

// Solids or shells as a representation of the given type.
template <typename Representation, typename Shape, typename Make>
handle<StepShape_ShapeRepresentation> MakeSurfaces(const char* name,
                                                   const std::vector<Shape>& shapes,
                                                   const STEPConstruct_UnitContext& units,
                                                   const Make& make) {
  handle<StepRepr_HArray1OfRepresentationItem> items =
      new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(shapes.size()));
  for (size_t i = 0; i < shapes.size(); ++i) {
    items->SetValue(static_cast<int>(i) + 1, make(shapes[i]));
  }
  handle<Representation> representation = new Representation;
  representation->Init(Text(name), items, units.Value());
  return representation;
}

void Name(const handle<Transfer_FinderProcess>& made, const TopoDS_Shape& shape,
          const std::string& name) {
  const handle<StepRepr_RepresentationItem> item = STEPConstruct::FindEntity(made, shape);
  if (!item.IsNull()) item->SetName(Text(name));
}

void AddRods(const DrawingGraph& graph, const StepRods& rods, ProductModel* products) {
  if (rods.tubes.empty()) return;
  const handle<Transfer_FinderProcess> made = products->Process();
  const auto make = [&](const LabeledShape& tube) {
    const auto solid = MadeBy<TopoDSToStep_MakeManifoldSolidBrep>(TopoDS::Solid(tube.shape), made);
    solid.Value()->SetName(Text(StepNameOf(graph.links[tube.id], NumberOfLink(graph, tube.id))));
    return solid.Value();
  };
  products->Add("rods", MakeSurfaces<StepShape_AdvancedBrepShapeRepresentation>(
                            "rods", rods.tubes, products->Units(rods.tolerance), make));
}

void AddShells(const DrawingGraph& graph, const StepShells& shells, ProductModel* products) {
  const handle<Transfer_FinderProcess> made = products->Process();
  if (!shells.solids.empty()) {
    const auto make = [&](const TopoDS_Shape& solid) {
      return MadeBy<TopoDSToStep_MakeManifoldSolidBrep>(TopoDS::Solid(solid), made).Value();
    };
    products->Add("solids", MakeSurfaces<StepShape_AdvancedBrepShapeRepresentation>(
                                "solids", shells.solids, products->Units(shells.tolerance), make));
  }
  if (!shells.shells.empty()) {
    const auto make = [&](const TopoDS_Shape& shell) {
      return MadeBy<TopoDSToStep_MakeShellBasedSurfaceModel>(TopoDS::Shell(shell), made).Value();
    };
    products->Add("shells", MakeSurfaces<StepShape_ManifoldSurfaceShapeRepresentation>(
                                "shells", shells.shells, products->Units(shells.tolerance), make));
  }
  for (const LabeledShape& face : shells.faces) {
    Name(made, face.shape, "face_" + std::to_string(face.id));
  }
  for (const LabeledShape& edge : shells.edges) {
    Name(made, edge.shape, StepNameOf(graph.links[edge.id], NumberOfLink(graph, edge.id)));
  }
}

// Without the links of shells and tubes; a path is cut where they are.
std::vector<DrawingPath> PathsWithout(const StepShells& shells, const StepRods& rods,
                                      const DrawingGraph& graph) {
  std::vector<bool> is_in(graph.links.size(), false);
  for (const LabeledShape& edge : shells.edges) is_in[edge.id] = true;
  for (const LabeledShape& tube : rods.tubes) is_in[tube.id] = true;
  std::vector<DrawingPath> paths;
  for (const DrawingPath& path : PathsOf(graph)) {
    bool goes_on = false;
    for (const PathStep& step : path) {
      if (!is_in[step.link]) {
        if (!goes_on) paths.emplace_back();
        paths.back().push_back(step);
      }
      goes_on = !is_in[step.link];
    }
  }
  return paths;
}

void AddHeader(const handle<StepData_StepModel>& model) {
  APIHeaderSection_MakeHeader header(0);
  header.SetName(Text("drawing"));
  // The same drawing gives the same bytes: no time.
  header.SetTimeStamp(Text("1970-01-01T00:00:00"));
  header.SetAuthor(OneText(""));
  header.SetOrganization(OneText(""));
  header.SetOriginatingSystem(Text("limn " LIMN_VERSION));
  header.SetAuthorisation(Text(""));
  header.SetDescription(OneText("3D drawing"));
  header.SetSchemaIdentifiers(OneText("AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"));
  header.Apply(model);
}

StepShells ShellsOf(const DrawingGraph& graph) {
  try {
    return MakeStepShells(graph);
  } catch (const Standard_Failure& failure) {
    throw InputError(std::string("faces: no shells of OpenCASCADE: ") + failure.GetMessageString());
  }
}

}  // namespace

StepNotes WriteDrawingStep(const DrawingGraph& graph, const StepOptions& options, LengthUnit unit,
                           std::ostream& out) {
  if (graph.links.empty()) throw InputError("a drawing without links cannot be a STEP file");
  const DrawingGraph in_mm =
      Transformed(graph, Millimeters(unit), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  STEPControl_Controller::Init();
  ProductModel products;
  const StepShells shells = ShellsOf(in_mm);
  const StepRods rods = options.rods_as_tubes ? MakeStepRods(in_mm) : StepRods();
  const std::vector<DrawingPath> paths = PathsWithout(shells, rods, in_mm);
  if (!paths.empty()) {
    const StepEdges edges = MakeStepEdges(in_mm, paths);
    products.Add("drawing",
                 MakeRepresentation(MakeWireframe(paths, edges), products.Units(edges.gap)));
  }
  AddShells(in_mm, shells, &products);
  AddRods(in_mm, rods, &products);
  AddHeader(products.model());
  StepData_StepWriter writer(products.model());
  writer.FloatWriter().SetFormat("%.16E");  // all digits
  writer.SendModel(handle<StepData_Protocol>::DownCast(STEPEdit::Protocol()));
  writer.Print(out);
  return {shells.apart, shells.left_out, rods.left_out};
}

}  // namespace limn
