// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_step.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PreDefinedColour.hxx>
#include <StepVisual_PreDefinedItem.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>
#include <mutex>
#include <unordered_map>

#include <fmt/format.h>

#include "boreholes/errors.h"
#include "io/mesh_part.h"
#include "io/write_aside.h"
#include "mesh/planar_bodies.h"

namespace stratareeb {
namespace {

constexpr double kTolerance = 1e-7;  // OpenCASCADE's notion of "the same point"
constexpr double kUsSurveyFoot_mm = 1200.0 / 3937.0 * 1000.0;

// Turns one shell into OpenCASCADE's boundary representation. Every mesh vertex and every side of a polygon
// is one shared object, so the shell is closed by construction and nothing needs sewing.
class ShellBuilder {
 public:
    explicit ShellBuilder(const PlanarShell& shell) : mesh_(shell.mesh), faces_(shell.faces) {}

    TopoDS_Shell build() {
        TopoDS_Shell result;
        builder_.MakeShell(result);
        for (const auto& region : faces_) builder_.Add(result, face(region));
        result.Closed(true);
        return result;
    }

 private:
    TopoDS_Face face(const PlanarRegion& region) {
        const gp_Pnt at(region.point.x, region.point.y, region.point.z);
        const gp_Dir normal(region.normal.x, region.normal.y, region.normal.z);
        const gp_Pnt a = point(region.loops[0][0]), b = point(region.loops[0][1]);
        TopoDS_Face result;
        builder_.MakeFace(result, new Geom_Plane(gp_Ax3(at, normal, gp_Vec(a, b))), kTolerance);
        for (const auto& loop : region.loops) builder_.Add(result, wire(loop));
        return result;
    }

    TopoDS_Wire wire(const std::vector<std::uint32_t>& loop) {
        TopoDS_Wire result;
        builder_.MakeWire(result);
        for (std::size_t i = 0; i < loop.size(); ++i)
            builder_.Add(result, edge(loop[i], loop[(i + 1) % loop.size()]));
        result.Closed(true);
        return result;
    }

    TopoDS_Edge edge(std::uint32_t from, std::uint32_t to) {
        const auto [low, high] = std::minmax(from, to);
        auto& shared = edges_[(std::uint64_t{low} << 32) | high];
        if (shared.IsNull()) shared = new_edge(low, high);
        return TopoDS::Edge(shared.Oriented(from == low ? TopAbs_FORWARD : TopAbs_REVERSED));
    }

    TopoDS_Edge new_edge(std::uint32_t from, std::uint32_t to) {
        const gp_Vec along(point(from), point(to));
        TopoDS_Edge result;
        builder_.MakeEdge(result, new Geom_Line(point(from), gp_Dir(along)), kTolerance);
        builder_.Add(result, vertex(from).Oriented(TopAbs_FORWARD));
        builder_.Add(result, vertex(to).Oriented(TopAbs_REVERSED));
        builder_.Range(result, 0, along.Magnitude());
        return result;
    }

    const TopoDS_Vertex& vertex(std::uint32_t v) {
        auto& shared = vertices_[v];
        if (shared.IsNull()) builder_.MakeVertex(shared, point(v), kTolerance);
        return shared;
    }

    gp_Pnt point(std::uint32_t v) const {
        const auto& p = mesh_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1], p[2]};
    }

    const TriMesh& mesh_;
    const std::vector<PlanarRegion>& faces_;
    BRep_Builder builder_;
    std::unordered_map<std::uint32_t, TopoDS_Vertex> vertices_;
    std::unordered_map<std::uint64_t, TopoDS_Edge> edges_;  // by their two vertices, the lower first
};

TopoDS_Solid solid(const PlanarBody& body) {
    BRep_Builder builder;
    TopoDS_Solid result;
    builder.MakeSolid(result);
    builder.Add(result, ShellBuilder(body.outer).build());
    for (const auto& cavity : body.cavities) builder.Add(result, ShellBuilder(cavity).build());
    return result;
}

// OpenCASCADE's settings and messages belong to the process: one writer at a time, and all is put back
// afterwards.
class QuietSession {
 public:
    QuietSession() : lock_(mutex()), printers_(Message::DefaultMessenger()->Printers()) {
        Message::DefaultMessenger()->ChangePrinters().Clear();
        STEPCAFControl_Controller::Init();
    }
    ~QuietSession() {
        for (const auto& [name, value] : saved_) Interface_Static::SetCVal(name.c_str(), value.c_str());
        Message::DefaultMessenger()->ChangePrinters() = printers_;
    }
    QuietSession(const QuietSession&) = delete;
    QuietSession& operator=(const QuietSession&) = delete;

    void set(const char* name, const char* value) {
        saved_.emplace_back(name, Interface_Static::CVal(name));
        if (!Interface_Static::SetCVal(name, value))
            throw IoError(fmt::format("OpenCASCADE doesn't take {} = {}", name, value));
    }

 private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    std::lock_guard<std::mutex> lock_;
    Message_SequenceOfPrinters printers_;
    std::vector<std::pair<std::string, std::string>> saved_;
};

Quantity_Color color_of(const Unit& unit) {
    const Rgb rgb = rgb_from_text(unit.color);
    return {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0, Quantity_TOC_sRGB};
}

std::string body_name(const Unit& unit, std::size_t body) {
    const std::string name = unit.name.empty() ? unit.code : unit.name;
    return body == 0 ? name : fmt::format("{}, body {}", name, body + 1);
}

void add_solid(const Handle(TDocStd_Document) & document, const TopoDS_Solid& solid, const std::string& name,
               const Quantity_Color& color) {
    const TDF_Label label = XCAFDoc_DocumentTool::ShapeTool(document->Main())->AddShape(solid, false);
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
    XCAFDoc_DocumentTool::ColorTool(document->Main())->SetColor(label, color, XCAFDoc_ColorGen);
}

StepReport add_layer(const Handle(TDocStd_Document) & document, const LayerSolid& layer) {
    StepReport report;
    try {
        for (const auto& body : planar_bodies(layer.surface)) {
            add_solid(document, solid(body), body_name(layer.unit, report.solids), color_of(layer.unit));
            ++report.solids;
            report.faces += body.outer.faces.size();
            for (const auto& cavity : body.cavities) report.faces += cavity.faces.size();
        }
    } catch (const InvalidInput& e) {
        throw InvalidInput(fmt::format("layer '{}': {}", body_name(layer.unit, 0), e.what()));
    }
    return report;
}

// A name for a colour by which colours can be sorted.
std::string color_key(const Handle(StepVisual_Colour) & color) {
    if (const auto rgb = Handle(StepVisual_ColourRgb)::DownCast(color); !rgb.IsNull())
        return fmt::format("{} {} {}", rgb->Red(), rgb->Green(), rgb->Blue());
    const auto named = Handle(StepVisual_PreDefinedColour)::DownCast(color);
    return named.IsNull() || named->GetPreDefinedItem().IsNull()
               ? std::string()
               : named->GetPreDefinedItem()->Name()->ToCString();
}

// OpenCASCADE appends the colours of bodies in the order of a map of addresses, which differs from run to run.
// Here colours come first, then each presentation and what follows it in the order of the bodies.
void order_colors(const Handle(StepData_StepModel) & model) {
    using Presentation = StepVisual_MechanicalDesignGeometricPresentationRepresentation;
    using Entities = std::vector<Handle(Standard_Transient)>;
    Entities ordered;
    std::map<std::string, Entities> colors;
    std::map<int, Entities> presentations;  // by the number of the body
    Entities* block = &ordered;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto entity = model->Value(i);
        if (const auto shown = Handle(Presentation)::DownCast(entity); !shown.IsNull())
            block = &presentations[model->Number(
                Handle(StepVisual_StyledItem)::DownCast(shown->ItemsValue(1))->Item())];
        const auto color = Handle(StepVisual_Colour)::DownCast(entity);
        (color.IsNull() ? *block : colors[color_key(color)]).push_back(entity);
    }
    for (const auto& [key, entities] : colors)
        ordered.insert(ordered.end(), entities.begin(), entities.end());
    for (const auto& [body, entities] : presentations)
        ordered.insert(ordered.end(), entities.begin(), entities.end());
    model->ClearEntities();
    for (const auto& entity : ordered) model->AddEntity(entity);
}

// What OpenCASCADE leaves to counters, clocks and its own idea of a name.
void finish_model(const Handle(StepData_StepModel) & model, const StepOptions& options) {
    const auto text = [](const std::string& s) { return new TCollection_HAsciiString(s.c_str()); };
    const std::string description = fmt::format("local origin {:.17g} {:.17g} {:.17g} {}", options.origin.x,
                                                options.origin.y, options.origin.z, options.length_unit);
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto entity = model->Value(i);
        if (const auto product = Handle(StepBasic_Product)::DownCast(entity); !product.IsNull())
            product->SetDescription(text(description));
        if (options.length_unit != "us-ft") continue;
        const auto unit = Handle(StepBasic_ConversionBasedUnitAndLengthUnit)::DownCast(entity);
        if (unit.IsNull()) continue;
        unit->SetName(text("US SURVEY FOOT"));
        unit->ConversionFactor()->SetValueComponent(kUsSurveyFoot_mm);
    }
    APIHeaderSection_MakeHeader header(model);
    header.SetName(text("model.step"));
    header.SetTimeStamp(text("1970-01-01T00:00:00"));
    header.SetAuthorValue(1, text(""));
    header.SetOrganizationValue(1, text(""));
    header.SetOriginatingSystem(text("Stratareeb"));
}

// OpenCASCADE's own 12 digits turn a wall of half a kilometre out of its plane by more than the tolerance, and FreeCAD
// then calls the solid invalid: numbers are written in full.
void print(const Handle(XSControl_WorkSession) & session, const Handle(StepData_StepModel) & model,
           std::ostream& stream) {
    StepData_StepWriter text(model);
    text.FloatWriter().SetFormat("%.16E");
    text.SendModel(Handle(StepData_Protocol)::DownCast(session->Protocol()));
    text.Print(stream);
}

const char* occt_unit(const std::string& length_unit) {
    if (length_unit == "m") return "M";
    if (length_unit == "ft" || length_unit == "us-ft") return "FT";
    throw InvalidInput(fmt::format("length unit '{}' (expected m, ft or us-ft)", length_unit));
}

StepReport write(const std::filesystem::path& path, std::span<const LayerSolid> solids,
                 const StepOptions& options) {
    const char* unit = occt_unit(options.length_unit);
    QuietSession session;
    session.set("write.step.unit", unit);
    session.set("xstep.cascade.unit", unit);      // the unit of our coordinates: written as they are
    session.set("write.surfacecurve.mode", "0");  // planes need no curves in parameter space
    session.set("write.step.schema", "AP214IS");
    session.set("write.step.product.name", "layer");

    const Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
    StepReport report;
    for (const auto& layer : solids) {
        const auto added = add_layer(document, layer);
        report.solids += added.solids;
        report.faces += added.faces;
    }
    if (report.solids == 0) throw InvalidInput("no layer has a body; a STEP file needs at least one");

    STEPCAFControl_Writer writer;
    writer.SetLayerMode(false);
    writer.SetPropsMode(false);
    writer.SetSHUOMode(false);
    writer.SetDimTolMode(false);
    writer.SetMaterialMode(false);
    if (!writer.Transfer(document, STEPControl_AsIs))
        throw GeometryError(fmt::format("{}: OpenCASCADE can't turn the solids into STEP", path.string()));
    const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
    order_colors(model);
    finish_model(model, options);
    write_aside(path, [&](std::ostream& stream) { print(writer.ChangeWriter().WS(), model, stream); });
    return report;
}

}  // namespace

StepReport write_step(const std::filesystem::path& path, std::span<const LayerSolid> solids,
                      const StepOptions& options) {
    try {
        return write(path, solids, options);
    } catch (const Standard_Failure& e) {
        throw GeometryError(fmt::format("{}: OpenCASCADE: {}", path.string(), e.GetMessageString()));
    }
}

}  // namespace stratareeb
