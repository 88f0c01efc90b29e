#include "mesher/read_cad.hpp"

#include "mesh/generation/surface_file.hpp"
#include "mesher/brep_text.hpp"
#include "mesher/iges_text.hpp"
#include "mesher/step_text.hpp"
#include "words/short_text.hpp"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Curve.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_Edge.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cmath>
#include <fstream>
#include <new>
#include <sstream>
#include <stdexcept>

namespace plica {
namespace {

using Shapes = TopTools_IndexedMapOfShape;

Shapes shapes_in(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  Shapes found;
  TopExp::MapShapes(shape, kind, found);
  return found;
}

std::string length_text(double m) {
  return short_text(1e3 * m, 3) + " mm";
}

std::string place_of(const TopoDS_Shape& shape) {
  const Shapes vertices = shapes_in(shape, TopAbs_VERTEX);
  if (vertices.IsEmpty()) return "";
  const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices(1)));
  return " near [" + length_text(p.X()) + ", " + length_text(p.Y()) + ", " + length_text(p.Z()) +
         "]";
}

std::string label(const Interface_InterfaceModel& model,
                  const Handle(Standard_Transient) & entity) {
  return model.StringLabel(entity)->ToCString();
}

// Failures that OpenCASCADE found while it read the file or made shapes of it.
void require_no_failure(const Interface_CheckIterator& checks) {
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Interface_Check)& check = checks.Value();
    if (!check->HasFailed()) continue;
    const Handle(Standard_Transient) entity = check->Entity();
    // Dates and names of the header; colours, layers, notes: not of the shape.
    if (entity.IsNull() || std::string(entity->DynamicType()->Name()).starts_with("StepVisual"))
      continue;
    std::string text = check->CFail(1);
    if (!checks.Model().IsNull()) text = label(*checks.Model(), entity) + ": " + text;
    throw std::runtime_error("OpenCASCADE says: " + text);
  }
}

void start(const XSControl_Reader& reader) {
  (void)reader; // its making registers these numbers
  Interface_Static::SetCVal("xstep.cascade.unit", "M");
}

// What has become a shape; null where nothing has.
TopoDS_Shape made_of(const XSControl_Reader& reader, const Handle(Standard_Transient) & entity) {
  return TransferBRep::ShapeResult(reader.WS()->TransferReader()->TransientProcess(), entity);
}

void require_all_made(const XSControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    const bool face = entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface));
    const bool edge = entity->IsKind(STANDARD_TYPE(StepShape_EdgeCurve));
    if ((face || edge) && made_of(reader, entity).IsNull())
      throw std::runtime_error("OpenCASCADE could not make the " +
                               std::string(face ? "face " : "edge ") + label(*model, entity));
  }
}

template <class Reader> TopoDS_Shape transferred(const std::string& file) {
  Reader reader;
  start(reader);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("OpenCASCADE cannot read it");
  require_no_failure(reader.WS()->ModelCheckList(Standard_True));
  const int roots = reader.NbRootsForTransfer();
  if (reader.TransferRoots() < roots)
    throw std::runtime_error("OpenCASCADE made shapes of less than its " + std::to_string(roots) +
                             " roots");
  require_no_failure(reader.WS()->TransferReader()->LastCheckList());
  require_all_made(reader);
  return reader.OneShape();
}

TopoDS_Shape read_brep(const std::string& text, double unit) {
  std::istringstream in(text);
  TopoDS_Shape shape;
  BRepTools::Read(shape, in, BRep_Builder());
  if (shape.IsNull()) throw std::runtime_error("OpenCASCADE cannot read it");
  gp_Trsf scale;
  scale.SetScaleFactor(unit);
  return BRepBuilderAPI_Transform(shape, scale, Standard_True).Shape();
}

TopoDS_Shape shape_of(const std::filesystem::path& file, double unit) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string suffix = lower_suffix(file);
  if (suffix == ".brep") {
    check_brep_text(text);
    return read_brep(text, unit);
  }
  if (suffix == ".iges" || suffix == ".igs") {
    check_iges_text(text);
    return transferred<IGESControl_Reader>(file.string());
  }
  check_step_text(text);
  return transferred<STEPControl_Reader>(file.string());
}

double area_of(const TopoDS_Shape& face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  return properties.Mass();
}

// How far edges lie off their faces and vertices off their edges.
void require_closed_gaps(const TopoDS_Shape& shape, double limit) {
  const auto require = [&](double gap, const char* what, const TopoDS_Shape& where) {
    if (!(gap <= limit))
      throw std::runtime_error(std::string(what) + " by " + length_text(gap) + place_of(where) +
                               ", more than " + length_text(limit) +
                               ", 3e-4 of the root of its area: numbers of the file do not agree");
  };
  const Shapes vertices = shapes_in(shape, TopAbs_VERTEX), edges = shapes_in(shape, TopAbs_EDGE),
               faces = shapes_in(shape, TopAbs_FACE);
  for (int i = 1; i <= vertices.Extent(); ++i)
    require(BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))), "a vertex lies off its edges",
            vertices(i));
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    require(BRep_Tool::Tolerance(edge), "an edge lies off its faces", edge);
    double from = 0, to = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
    if (curve.IsNull() || std::isinf(from) || std::isinf(to)) continue;
    for (const auto& [vertex, at] :
         {std::pair{TopExp::FirstVertex(edge), from}, {TopExp::LastVertex(edge), to}})
      if (!vertex.IsNull())
        require(BRep_Tool::Pnt(vertex).Distance(curve->Value(at)), "a vertex lies off its edge",
                edge);
  }
  for (int f = 1; f <= faces.Extent(); ++f) {
    const Shapes own = shapes_in(faces(f), TopAbs_EDGE);
    for (int e = 1; e <= own.Extent(); ++e) {
      const TopoDS_Edge edge = TopoDS::Edge(own(e));
      double gap = 0;
      if (BRep_Tool::Degenerated(edge)) continue;
      ShapeAnalysis_Edge().CheckSameParameter(edge, TopoDS::Face(faces(f)), gap);
      require(gap, "an edge lies off its face", edge);
    }
  }
}

void require_valid(const TopoDS_Shape& shape) {
  const BRepCheck_Analyzer analyzer(shape);
  if (analyzer.IsValid()) return;
  for (TopAbs_ShapeEnum kind :
       {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_WIRE, TopAbs_FACE, TopAbs_SHELL}) {
    const Shapes all = shapes_in(shape, kind);
    for (int i = 1; i <= all.Extent(); ++i) {
      if (analyzer.IsValid(all(i))) continue;
      std::ostringstream why;
      for (const BRepCheck_Status status : analyzer.Result(all(i))->Status())
        if (status != BRepCheck_NoError) BRepCheck::Print(status, why);
      std::string text = why.str();
      while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.pop_back();
      throw std::runtime_error("OpenCASCADE calls the shape invalid: " + text + place_of(all(i)));
    }
  }
  throw std::runtime_error("OpenCASCADE calls the shape invalid");
}

CadFaces checked(const TopoDS_Shape& shape) {
  if (shape.IsNull()) throw std::runtime_error("it holds no face");
  if (const int solids = shapes_in(shape, TopAbs_SOLID).Extent(); solids > 0)
    throw std::runtime_error("it holds " + std::to_string(solids) +
                             " solids; a shell is meshed on faces: export the middle or outer "
                             "surface alone");
  const Shapes faces = shapes_in(shape, TopAbs_FACE);
  if (faces.IsEmpty()) throw std::runtime_error("it holds no face");
  double area = 0;
  for (int i = 1; i <= faces.Extent(); ++i) {
    const double own = area_of(faces(i));
    if (!(own > 0) || !std::isfinite(own))
      throw std::runtime_error("a face has no area, or no end" + place_of(faces(i)));
    area += own;
  }
  constexpr double gap = 3e-4;
  require_closed_gaps(shape, gap * std::sqrt(area));
  require_valid(shape);
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (int i = 1; i <= faces.Extent(); ++i) builder.Add(all, faces(i));
  return {std::make_shared<TopoDS_Shape>(all)};
}

} // namespace

CadFaces read_cad(const std::filesystem::path& file, double unit) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  try {
    return checked(shape_of(file, unit));
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    throw std::runtime_error("OpenCASCADE says: " + std::string(failure.DynamicType()->Name()) +
                             " " + failure.GetMessageString());
  }
}

} // namespace plica
