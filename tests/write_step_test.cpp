// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_step.h"

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <fstream>
#include <sstream>

#include "boreholes/errors.h"
#include "tests/planar_shapes.h"

namespace stratareeb {
namespace {

using test::add_slab;
using test::level;
using test::slab;

class WriteStep : public testing::Test {
 protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("write_step_") + info->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file(const std::string& name = "model.step") const { return folder_ / name; }

    std::filesystem::path folder_;
};

struct ReadSolid {
    std::string name, color;
    double volume = 0;
    bool valid = false, closed = false;
    std::size_t faces = 0, shells = 0;
};

std::string color_of(const TDF_Label& label) {
    const auto tool = XCAFDoc_DocumentTool::ColorTool(label);
    Quantity_Color color;
    for (const auto type : {XCAFDoc_ColorGen, XCAFDoc_ColorSurf})
        if (tool->GetColor(label, type, color)) return Quantity_Color::ColorToHex(color).ToCString();
    return "none";
}

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum what) {
    std::size_t n = 0;
    for (TopExp_Explorer it(shape, what); it.More(); it.Next()) ++n;
    return n;
}

ReadSolid inspect(const TDF_Label& label) {
    ReadSolid solid;
    Handle(TDataStd_Name) name;
    if (label.FindAttribute(TDataStd_Name::GetID(), name)) {
        std::string utf8(static_cast<std::size_t>(name->Get().LengthOfCString()), '\0');
        auto* begin = utf8.data();
        name->Get().ToUTF8CString(begin);
        solid.name = utf8;
    }
    solid.color = color_of(label);
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    EXPECT_EQ(shape.ShapeType(), TopAbs_SOLID);
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    solid.volume = properties.Mass();
    solid.valid = BRepCheck_Analyzer(shape).IsValid();
    solid.closed = true;
    for (TopExp_Explorer it(shape, TopAbs_SHELL); it.More(); it.Next())
        solid.closed = solid.closed && BRep_Tool::IsClosed(it.Current());
    solid.faces = count(shape, TopAbs_FACE);
    solid.shells = count(shape, TopAbs_SHELL);
    return solid;
}

// Reads with millimetres inside, as FreeCAD does.
std::vector<ReadSolid> read(const std::filesystem::path& path) {
    STEPCAFControl_Controller::Init();
    Message::DefaultMessenger()->ChangePrinters().Clear();
    Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
    STEPCAFControl_Reader reader;
    EXPECT_EQ(reader.ReadFile(path.string().c_str()), IFSelect_RetDone);
    EXPECT_TRUE(reader.Transfer(document));
    TDF_LabelSequence labels;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(labels);
    std::vector<ReadSolid> solids;
    for (const auto& label : labels) solids.push_back(inspect(label));
    return solids;
}

std::string bytes(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

LayerSolid layer(TriMesh mesh, const std::string& name = "clay", const std::string& color = "#c8a050") {
    return {.order = 1, .unit = {.code = name, .name = name, .color = color}, .surface = std::move(mesh)};
}

StepReport write(const std::filesystem::path& path, const TriMesh& mesh, const StepOptions& options = {}) {
    const std::vector<LayerSolid> layers{layer(mesh)};
    return write_step(path, layers, options);
}

void expect_sound(const ReadSolid& solid, double volume, double unit_mm) {
    const double expected = volume * unit_mm * unit_mm * unit_mm;
    EXPECT_TRUE(solid.valid) << solid.name;
    EXPECT_TRUE(solid.closed) << solid.name;
    EXPECT_NEAR(solid.volume, expected, 1e-9 * expected) << solid.name;
}

TEST_F(WriteStep, a_box_is_six_faces_of_the_right_volume) {
    const auto report = write(file(), slab({.n = 7, .size = 3}));
    EXPECT_EQ(report.solids, 1u);
    EXPECT_EQ(report.faces, 6u);
    const auto solids = read(file());
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_EQ(solids[0].faces, 6u);
    expect_sound(solids[0], 9.0, 1000);
}

TEST_F(WriteStep, units_of_length_give_true_sizes) {
    for (const auto& [unit, mm] :
         {std::pair{"m", 1000.0}, {"ft", 304.8}, {"us-ft", 1200.0 / 3937.0 * 1000.0}}) {
        write(file(), slab({.n = 1}), {.length_unit = unit});
        SCOPED_TRACE(unit);
        expect_sound(read(file()).at(0), 1.0, mm);
    }
}

TEST_F(WriteStep, every_body_has_its_name_and_colour) {
    TriMesh islands;
    add_slab(islands, {.n = 3});
    add_slab(islands, {.n = 2, .size = 2, .x0 = 5});
    const std::vector<LayerSolid> layers{layer(slab({.n = 2}), "topsoil", "#1240ff"),
                                         layer(TriMesh(), "absent"),
                                         layer(islands, "Argile à blocs", "#c8a050")};
    EXPECT_EQ(write_step(file(), layers).solids, 3u);
    const auto solids = read(file());
    ASSERT_EQ(solids.size(), 3u);
    EXPECT_EQ(solids[0].name, "topsoil");
    EXPECT_EQ(solids[0].color, "#1240FF");
    EXPECT_EQ(solids[1].name, "Argile à blocs");
    EXPECT_EQ(solids[2].name, "Argile à blocs, body 2");
    EXPECT_EQ(solids[2].color, "#C8A050");
    expect_sound(solids[1], 1, 1000);
    expect_sound(solids[2], 4, 1000);
}

TEST_F(WriteStep, shapes_come_back_valid_closed_and_of_the_same_volume) {
    const std::vector<std::pair<std::string, TriMesh>> shapes{
        {"hole", slab({.n = 6, .has_cell = [](int i, int j) { return i < 2 || i > 3 || j < 2 || j > 3; }})},
        {"wavy", slab({.n = 20,
                       .size = 6,
                       .top = [](double x, double y) { return 2 + std::sin(x) * std::cos(1.3 * y); }})},
        {"dipping", slab({.n = 20,
                          .size = 1000,
                          .top = [](double x, double y) { return 0.3 * x - 0.2 * y + 5; },
                          .base = [](double x, double y) { return 0.3 * x - 0.2 * y; }})},
        {"lens", test::cone_lens(24, 6, 100, 2, 3)},
        {"thin lens", test::cone_lens(60, 10, 1000, 0.01, 0.02)},
        {"touching itself",
         slab({.n = 6,
               .size = 6,
               .top = [](double x,
                         double y) { return (x == 2 && y == 2) || (x == 4 && y == 4) ? 2.0 : 1.0; }})},
        {"far away", slab({.n = 10, .size = 1000, .x0 = 5e5, .y0 = 5e6, .top = [](double x, double y) {
                               return 20 + std::sin(x / 60) * std::cos(y / 90);
                           }})}};
    for (const auto& [name, mesh] : shapes) {
        SCOPED_TRACE(name);
        write(file(), mesh);
        const auto solids = read(file());
        ASSERT_EQ(solids.size(), 1u);
        expect_sound(solids[0], test::mesh_volume(mesh), 1000);
    }
}

TEST_F(WriteStep, an_inward_shell_becomes_a_cavity) {
    TriMesh mesh;
    add_slab(mesh, {.n = 2, .size = 10, .top = level(10)});
    add_slab(mesh, {.n = 2, .size = 2, .x0 = 4, .y0 = 4, .top = level(6), .base = level(4), .inward = true});
    write(file(), mesh);
    const auto solids = read(file());
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_EQ(solids[0].shells, 2u);
    expect_sound(solids[0], 992, 1000);
}

TEST_F(WriteStep, the_same_solids_give_the_same_bytes) {
    const auto mesh = test::cone_lens(9, 3, 10, 2, 3);
    write(file("a.step"), mesh);
    write(file("b.step"), mesh);
    EXPECT_EQ(bytes(file("a.step")), bytes(file("b.step")));
}

TEST_F(WriteStep, the_origin_is_on_record) {
    write(file(), slab({.n = 1}), {.origin = {431250.5, 5012345.25, -3}});
    EXPECT_NE(bytes(file()).find("local origin 431250.5 5012345.25 -3 m"), std::string::npos);
}

TEST_F(WriteStep, numbers_are_written_in_full) {
    // With 12 digits, a long wall leaves its plane by more than the tolerance, and FreeCAD calls the solid invalid.
    write(file(), slab({.n = 1, .size = 1.0 / 3, .top = level(1000.0 / 7)}));
    EXPECT_NE(bytes(file()).find("3.3333333333333331E-01"), std::string::npos);
    EXPECT_NE(bytes(file()).find("1.4285714285714286E+02"), std::string::npos);
}

TEST_F(WriteStep, names_travel_in_any_script) {
    const std::vector<LayerSolid> layers{layer(slab({.n = 1}), "Schluff, weiß 粘土 'x' \\ 100 %")};
    write_step(file(), layers);
    EXPECT_EQ(read(file()).at(0).name, layers[0].unit.name);
}

TEST_F(WriteStep, nothing_is_printed_and_settings_are_put_back) {
    STEPCAFControl_Controller::Init();
    const std::string unit = Interface_Static::CVal("write.step.unit");
    const auto printers = Message::DefaultMessenger()->Printers().Length();
    testing::internal::CaptureStdout();
    write(file(), slab({.n = 1}));
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(Interface_Static::CVal("write.step.unit"), unit);
    EXPECT_EQ(Message::DefaultMessenger()->Printers().Length(), printers);
}

TEST_F(WriteStep, bad_input_is_refused_and_the_old_file_stays) {
    write(file(), slab({.n = 1}));
    const auto before = bytes(file());
    EXPECT_THROW(write(file(), TriMesh()), InvalidInput);
    EXPECT_THROW(write(file(), slab({.n = 1}), {.length_unit = "furlong"}), InvalidInput);
    TriMesh open;
    open.add_face(open.add_vertex({0, 0, 0}), open.add_vertex({1, 0, 0}), open.add_vertex({0, 1, 0}));
    try {
        write(file(), open);
        FAIL();
    } catch (const InvalidInput& e) {
        EXPECT_NE(std::string(e.what()).find("layer 'clay': the surface is open at ("), std::string::npos)
            << e.what();
    }
    EXPECT_EQ(bytes(file()), before);
}

TEST_F(WriteStep, a_folder_that_is_not_there_is_named) {
    try {
        write(folder_ / "nowhere" / "model.step", slab({.n = 1}));
        FAIL();
    } catch (const IoError& e) {
        EXPECT_NE(std::string(e.what()).find("nowhere"), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "nowhere"));
}

}  // namespace
}  // namespace stratareeb
