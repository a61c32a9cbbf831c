// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/step_document.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
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
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>
#include <mutex>
#include <sstream>

#include <fmt/format.h>

#include "boreholes/errors.h"
#include "boreholes/length_unit.h"
#include "io/step_sharing.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

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

Quantity_Color occt_color(const Rgb& rgb) {
    return {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0, Quantity_TOC_sRGB};
}

void add_body(const Handle(TDocStd_Document) & document, const CadBody& body) {
    const TDF_Label label = XCAFDoc_DocumentTool::ShapeTool(document->Main())->AddShape(*body.solid, false);
    TDataStd_Name::Set(label, TCollection_ExtendedString(body.name.c_str(), true));
    XCAFDoc_DocumentTool::ColorTool(document->Main())
        ->SetColor(label, occt_color(body.color), XCAFDoc_ColorGen);
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
void finish_model(const Handle(StepData_StepModel) & model, const StepDocumentOptions& options) {
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
        unit->ConversionFactor()->SetValueComponent(metres_per(options.length_unit) * 1000);
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
    std::ostringstream whole;
    text.Print(whole);
    share_step_geometry(whole.view(), stream);
}

const char* occt_unit(const std::string& length_unit) {
    if (length_unit == "m") return "M";
    if (length_unit == "ft" || length_unit == "us-ft") return "FT";
    throw InvalidInput(fmt::format("length unit '{}' (expected m, ft or us-ft)", length_unit));
}

}  // namespace

void write_step_document(const std::filesystem::path& path, std::span<const CadBody> bodies,
                         const StepDocumentOptions& options) {
    const char* unit = occt_unit(options.length_unit);
    if (bodies.empty()) throw InvalidInput("no layer has a body; a STEP file needs at least one");
    QuietSession session;
    session.set("write.step.unit", unit);
    session.set("xstep.cascade.unit", unit);  // the unit of our coordinates: written as they are
    session.set("write.surfacecurve.mode", options.has_parameter_curves ? "1" : "0");
    session.set("write.step.schema", "AP214IS");
    session.set("write.step.product.name", "layer");

    const Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
    for (const auto& body : bodies) add_body(document, body);

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
}

}  // namespace stratareeb
