#include "limn/formats/step_drawing_writer.h"

#include <algorithm>
#include <ostream>
#include <string>

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <STEPConstruct_Part.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPEdit.hxx>
#include <StepBasic_ApplicationContext.hxx>
#include <StepBasic_ApplicationProtocolDefinition.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepShape_ConnectedEdgeSet.hxx>
#include <StepShape_EdgeBasedWireframeModel.hxx>
#include <StepShape_EdgeBasedWireframeShapeRepresentation.hxx>
#include <StepShape_HArray1OfConnectedEdgeSet.hxx>
#include <StepShape_HArray1OfEdge.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>

#include "limn/formats/step_edges.h"
#include "limn/model/drawing_paths.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"
#include "limn/version.h"

namespace limn {
namespace {

using opencascade::handle;

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

// The representation with its units (mm, rad). Distances below `uncertainty_mm` mean nothing.
handle<StepShape_ShapeRepresentation> MakeRepresentation(
    const handle<StepShape_EdgeBasedWireframeModel>& wireframe, double uncertainty_mm) {
  handle<StepRepr_HArray1OfRepresentationItem> items =
      new StepRepr_HArray1OfRepresentationItem(1, 1);
  items->SetValue(1, wireframe);
  STEPConstruct_UnitContext units;
  units.Init(uncertainty_mm);
  handle<StepShape_EdgeBasedWireframeShapeRepresentation> representation =
      new StepShape_EdgeBasedWireframeShapeRepresentation;
  representation->Init(Text("drawing"), items, units.Value());
  return representation;
}

void AddProduct(const handle<StepShape_ShapeRepresentation>& representation,
                StepData_StepModel* model) {
  handle<StepBasic_ApplicationContext> context = new StepBasic_ApplicationContext;
  context->Init(Text("core data for automotive mechanical design processes"));
  handle<StepBasic_ApplicationProtocolDefinition> protocol =
      new StepBasic_ApplicationProtocolDefinition;
  protocol->Init(Text("international standard"), Text("automotive_design"), 2000, context);
  STEPConstruct_Part part;
  part.MakeSDR(representation, Text("drawing"), context);
  model->AddWithRefs(protocol);
  model->AddWithRefs(part.SDRValue());
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

}  // namespace

void WriteDrawingStep(const DrawingGraph& graph, LengthUnit unit, std::ostream& out) {
  constexpr double kLeastUncertaintyMm = 1e-7;
  if (graph.links.empty()) throw InputError("a drawing without links cannot be a STEP file");
  const DrawingGraph in_mm =
      Transformed(graph, Millimeters(unit), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  STEPControl_Controller::Init();
  handle<StepData_StepModel> model = new StepData_StepModel;
  model->SetProtocol(STEPEdit::Protocol());
  const std::vector<DrawingPath> paths = PathsOf(in_mm);
  const StepEdges edges = MakeStepEdges(in_mm, paths);
  AddProduct(
      MakeRepresentation(MakeWireframe(paths, edges), std::max(kLeastUncertaintyMm, 2 * edges.gap)),
      model.get());
  AddHeader(model);
  StepData_StepWriter writer(model);
  writer.FloatWriter().SetFormat("%.16E");  // all digits
  writer.SendModel(handle<StepData_Protocol>::DownCast(STEPEdit::Protocol()));
  writer.Print(out);
}

}  // namespace limn
