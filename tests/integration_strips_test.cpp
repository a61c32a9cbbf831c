// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/integration_strips.h"

#include <gtest/gtest.h>

#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>

#include "io/cad_body.h"
#include "io/smooth_shapes.h"
#include "subdivision/cell_integrals.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

// Thin layers over waves that need many spans.
SmoothBrep wavy_layers(double wave) {
    const auto model = test::grid_model(
        {.cells = 30,
         .ground = [=](double x, double y) { return 3 * std::sin(x / wave) * std::cos(y / (1.3 * wave)); },
         .thickness = {test::constant(0.1), test::constant(3)}});
    return build_smooth_brep(model, {.sheets = {.most_functions = 3000}});
}

// Of the volumes that OpenCASCADE finds from those between the sheets.
double worst_off(const SmoothBrep& brep) {
    const auto shapes = smooth_shapes(brep);
    double worst = 0;
    for (std::size_t b = 0; b < shapes.size(); ++b)
        worst = std::max(worst, std::abs(cad_volume(*shapes[b]) / brep.quality[b].volume - 1));
    return worst;
}

TEST(IntegrationStrips, are_not_cut_where_volumes_are_right) {
    SmoothBrep brep = wavy_layers(40);
    ASSERT_LT(worst_off(brep), 1e-3);
    const std::size_t whole = brep.cells.cells.size();
    cut_for_integration(brep, 1e-3);
    EXPECT_EQ(brep.cells.cells.size(), whole);
}

TEST(IntegrationStrips, make_the_volumes_right_that_a_cad_program_finds) {
    SmoothBrep brep = wavy_layers(4);
    ASSERT_GT(worst_off(brep), 5e-3) << "nothing to mend";
    const std::size_t whole = brep.cells.cells.size();
    cut_for_integration(brep, 5e-4);
    EXPECT_LT(worst_off(brep), 1e-3);
    EXPECT_GT(brep.cells.cells.size(), whole);
    EXPECT_LT(brep.cells.cells.size(), whole + 30);
}

// What a program will add to a volume by mistake is foretold, face by face.
TEST(IntegrationStrips, errors_are_those_of_opencascade) {
    const SmoothBrep brep = wavy_layers(4);
    const auto shapes = smooth_shapes(brep);
    const auto& body = brep.cells.bodies[0];
    for (const double x : {0.0, 40.0, 300.0}) {
        const gp_Pnt from(x, 20, -5);
        TopExp_Explorer face(*shapes[0], TopAbs_FACE);
        for (const auto c : body.top) {
            BRepGProp_Face surface;
            surface.Load(TopoDS::Face(face.Current()));
            BRepGProp_Domain outline(TopoDS::Face(face.Current()));
            const double cone = BRepGProp_Vinert(surface, outline, from).Mass();
            const double exact = integrate_cell(brep, c, {x, 20, -5}).cone;
            ASSERT_GT(std::abs(cone - exact), 0.5) << x;
            EXPECT_NEAR(integration_error(brep, c, {x, 20, -5}) / (cone - exact), 1, 0.01) << x;
            face.Next();
        }
    }
}

}  // namespace
}  // namespace stratareeb
