// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_contour_stack.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <map>
#include <set>

#include "boreholes/errors.h"
#include "io/write_contours.h"
#include "reeb/graph_conditions.h"
#include "reeb/graph_of_stack.h"
#include "reeb/level_set.h"
#include "tests/shapes.h"
#include "tests/stack_cases.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

std::string message_of(const std::string& file, const ReadContourStackOptions& options = {}) {
    try {
        read_contour_stack(file, options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) EXPECT_NE(text.find(part), text.npos) << part << "\n  in: " << text;
}

//! The same contours, whatever their order, sense and start?
void expect_same(const ContourStack& a, const ContourStack& b) {
    const SortedStack p = sorted_stack(a), q = sorted_stack(b);
    ASSERT_EQ(p.contours.size(), q.contours.size());
    for (std::size_t c = 0; c < p.contours.size(); ++c) {
        EXPECT_EQ(p.contours[c].z, q.contours[c].z);
        EXPECT_EQ(p.contours[c].points, q.contours[c].points);
    }
}

const ContourStack kRingWithHole{{testing::rectangle(1.5, 0, 0, 10, 10), testing::rectangle(1.5, 2, 2, 4, 5),
                                  testing::rectangle(0.1, 1, 1, 9, 9),
                                  testing::rectangle(1.5, 500000.25, 5000000.125, 500003, 5000004)}};

TEST(ReadContourStack, json_as_written_by_hand) {
    const TemporaryFolder folder;
    const auto file = folder.file("a.json", R"({"contours": [
        {"z": 1.5, "points": [[0,0],[0,10],[10,10],[10,0],[0,0]]}, {"z": 1.5, "name": "hole", "points": [[2,2],[4,2],[4,5],[2,5]]},
        {"z": 0.1, "points": [[1,1,0.1],[9,1,0.1],[9,9,0.1],[1,9,0.1]]},
        {"z": 1.5, "points": [[500000.25,5000000.125],[500003,5000000.125],[500003,5000004],[500000.25,5000004]]}]})");
    expect_same(read_contour_stack(file.string()), kRingWithHole);
}

TEST(ReadContourStack, levels_of_a_mesh_come_back_as_they_were_written) {
    const TemporaryFolder folder;
    const TriMesh mesh = half_edge_mesh(shapes::torus(3, 1, 40, 20));
    const ScalarField field = height_field(mesh);
    const auto levels = even_levels(field, 7);
    write_contours(folder / "levels.json", level_sets(mesh, field, levels), Point3{0, 0, 1});
    expect_same(read_contour_stack((folder / "levels.json").string()),
                testing::sections(mesh, field, levels));
    write_contours(folder / "x.json", level_sets(mesh, field, levels), Point3{1, 0, 0});
    expect_in(message_of((folder / "x.json").string()), {"another direction"});
}

TEST(ReadContourStack, all_faults_of_a_json_file_have_their_place) {
    const TemporaryFolder folder;
    const auto file =
        folder
            .file("bad.json",
                  R"({"contours": [{"z": "high", "points": [[0,0],[1,0],[1,1]]}, {"points": [[0],[1,0,7]]},
        {"z": 2, "closed": false, "points": [[0,0],[1,0],[1,1]]}, 7]})")
            .string();
    expect_in(message_of(file), {"bad.json", "contours[0].z", "contours[1]", "contours[1].points[0]",
                                 "contours[1].points[1]", "contours[2]: is open", "contours[3]"});
    const auto open =
        folder
            .file("open.json", R"({"contours": [{"z": 2, "closed": false, "points": [[0,0],[1,0],[1,1]]},
        {"z": 2, "closed": true, "points": [[5,0],[6,0],[6,1]]}]})")
            .string();
    EXPECT_EQ(read_contour_stack(open, {.leave_out_open = true}).contours.size(), 1u);
    EXPECT_THROW(read_contour_stack(folder.file("none.json", R"({"contours": []})").string()), InvalidInput);
    EXPECT_THROW(read_contour_stack(folder.file("list.json", "[1, 2]").string()), InvalidInput);
    EXPECT_THROW(read_contour_stack(folder.file("half.json", R"({"contours": [)").string()), InvalidInput);
    EXPECT_THROW(read_contour_stack((folder / "absent.json").string()), IoError);
    EXPECT_THROW(read_contour_stack((folder / "absent.gpkg").string()), IoError);
}

TEST(ReadContourStack, table_of_points_in_any_order) {
    const TemporaryFolder folder;
    const auto file =
        folder.file("p.csv",
                    "Ring,Elevation (m),Vertex,X,Y\n7,1.5,2,10,0\n7,1.5,1,0,0\n3,0.5,1,1,1\n7,1.5,3,10,10\n"
                    "3,0.5,2,9,1\n7,1.5,4,0,10\n3,0.5,3,9,9\n3,0.5,4,1,9\n");
    expect_same(read_contour_stack(file.string()),
                {{testing::rectangle(1.5, 0, 0, 10, 10), testing::rectangle(0.5, 1, 1, 9, 9)}});
    const auto plain =
        folder.file("plain.txt", "x\ty\tz\n0\t0\t1\n5\t0\t1\n5\t5\t1\n0\t0\t2\n5\t0\t2\n5\t5\t2\n");
    EXPECT_EQ(read_contour_stack(plain.string()).contours.size(), 2u);
}

TEST(ReadContourStack, one_body_of_several_in_a_table) {
    const TemporaryFolder folder;
    std::string text = "roi,contour,x_mm,y_mm,z_mm\n";
    for (const std::string roi : {"liver", "lung"})
        for (const std::string point : {"0,0", "4,0", "4,4"})
            text += roi + ",1," + point + (roi == "lung" ? ",9\n" : ",8\n");
    const auto file = folder.file("roi.csv", text).string();
    expect_in(message_of(file), {"several bodies: liver, lung"});
    const ContourStack stack = read_contour_stack(file, {.part = "lung"});
    ASSERT_EQ(stack.contours.size(), 1u);
    EXPECT_EQ(stack.contours[0].z, 9);
    EXPECT_EQ(stack.contours[0].points.size(), 3u);
    expect_in(message_of(file, {.part = "heart"}), {"heart", "liver"});
}

TEST(ReadContourStack, all_faults_of_a_table_have_their_row) {
    const TemporaryFolder folder;
    const auto file =
        folder.file("bad.csv", "ring,elevation,x,y\n1,5,0,zero\n1,5,1,0\n1,6,1,1\n1,,0,1\n").string();
    expect_in(message_of(file), {"bad.csv", "row 2", "zero", "row 4", "elevation is 6, and 5", "row 5"});
    expect_in(message_of(folder.file("n.csv", "a,x,y\n1,2,3\n2,3,4\n").string()),
              {"no column elevation", "a, x, y"});
    expect_in(message_of(folder.file("h.csv", "1,2,3\n2,3,4\n").string()), {"no header"});
    const auto named = folder.file("m.csv", "ring,stage,x,y\n1,5,0,0\n1,5,1,0\n1,5,1,1\n").string();
    EXPECT_EQ(read_contour_stack(named, {.elevation = "Stage"}).contours[0].z, 5);
    expect_in(message_of(named, {.elevation = "depth"}), {"no column or attribute depth", "stage"});
}

//! Write contours as features of a GDAL format: polygons whose holes are the contours inside them, or lines.
std::string write_features(const std::filesystem::path& file, const char* driver, bool polygons, bool as_z) {
    GDALAllRegister();
    const GDALDatasetUniquePtr dataset(
        GetGDALDriverManager()->GetDriverByName(driver)->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* layer = dataset->CreateLayer(
        "contours", nullptr,
        as_z ? (polygons ? wkbPolygon25D : wkbLineString25D) : (polygons ? wkbPolygon : wkbLineString));
    if (!as_z) {
        OGRFieldDefn field("ELEV", OFTReal);
        layer->CreateField(&field);
    }
    const auto put = [&](OGRGeometry& geometry, double z) {
        OGRFeature feature(layer->GetLayerDefn());
        if (!as_z) feature.SetField("ELEV", z);
        feature.SetGeometry(&geometry);
        EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    };
    const auto fill = [&](OGRLineString& line, const StackContour& contour) {
        for (std::size_t i = 0; i <= contour.points.size(); ++i) {
            const Point2& p = contour.points[i % contour.points.size()];
            as_z ? line.addPoint(p.x, p.y, contour.z) : line.addPoint(p.x, p.y);
        }
    };
    OGRPolygon with_hole;
    for (std::size_t c = 0; c < kRingWithHole.contours.size(); ++c) {
        const StackContour& contour = kRingWithHole.contours[c];
        if (polygons) {
            OGRLinearRing ring;
            fill(ring, contour);
            OGRPolygon other;
            OGRPolygon& polygon = c < 2 ? with_hole : other;
            polygon.addRing(&ring);
            if (c > 0) put(polygon, contour.z);
        } else {
            OGRLineString line;
            fill(line, contour);
            put(line, contour.z);
        }
    }
    return file.string();
}

TEST(ReadContourStack, lines_and_polygons_of_geographic_formats) {
    const TemporaryFolder folder;
    for (const bool polygons : {false, true})
        for (const bool as_z : {false, true}) {
            const std::string mark = std::string(polygons ? "p" : "l") + (as_z ? "z" : "a");
            for (const auto& [driver, extension] : std::map<const char*, std::string>{
                     {"GPKG", ".gpkg"}, {"ESRI Shapefile", ".shp"}, {"GeoJSON", ".geojson"}}) {
                SCOPED_TRACE(mark + extension);
                expect_same(
                    read_contour_stack(write_features(folder / (mark + extension), driver, polygons, as_z)),
                    kRingWithHole);
            }
        }
    expect_same(read_contour_stack(write_features(folder / "drawing.dxf", "DXF", false, true)),
                kRingWithHole);
    EXPECT_EQ(read_contour_stack((folder / "la.geojson").string(), {.elevation = "elev"}).contours.size(),
              4u);
}

TEST(ReadContourStack, table_with_well_known_text) {
    const TemporaryFolder folder;
    const auto file =
        folder.file("w.csv",
                    "WKT,level\n\"POLYGON ((0 0,10 0,10 10,0 10,0 0),(2 2,4 2,4 5,2 5,2 2))\",1.5\n"
                    "\"LINESTRING (1 1,9 1,9 9,1 9,1 1)\",0.1\n");
    const ContourStack stack = read_contour_stack(file.string());
    expect_same(stack, {{kRingWithHole.contours[0], kRingWithHole.contours[1], kRingWithHole.contours[2]}});
    EXPECT_EQ(stack.contours[1].name, "feature 1, ring 2");
}

TEST(ReadContourStack, faults_of_features_are_told_together) {
    const TemporaryFolder folder;
    const auto feature = [](const std::string& properties, const std::string& type,
                            const std::string& coordinates) {
        return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":")" + type +
               R"(","coordinates":)" + coordinates + "}}";
    };
    const std::string open = feature(R"("elevation":5)", "LineString", "[[0,0],[1,0],[1,1]]");
    const std::string text = R"({"type":"FeatureCollection","features":[)" + open + "," +
                             feature(R"("elevation":null)", "LineString", "[[0,0],[1,0],[1,1],[0,0]]") + "," +
                             feature(R"("elevation":6)", "LineString", "[[0,0],[1,0],[1,1],[0,0]]") + "]}";
    const auto file = folder.file("f.geojson", text).string();
    expect_in(message_of(file),
              {"feature 0: its line is open, from (0, 0) to (1, 1)", "feature 1: its elevation is empty"});
    const auto tilted =
        folder.file("t.geojson", R"({"type":"FeatureCollection","features":[)" +
                                     feature("", "LineString", "[[0,0,1],[1,0,1],[1,1,2],[0,0,1]]") + "]}");
    expect_in(message_of(tilted.string()), {"points 1 and 3 have heights 1 and 2"});
    const auto flat = folder.file(
        "n.geojson", R"({"type":"FeatureCollection","features":[)" +
                         feature(R"("kind":"x")", "LineString", "[[0,0],[1,0],[1,1],[0,0]]") + "]}");
    expect_in(message_of(flat.string()), {"no height", "kind"});
    const auto lines = folder.file(
        "o.json", R"({"type":"FeatureCollection","features":[)" + open + "," +
                      feature(R"("elevation":6)", "LineString", "[[0,0],[1,0],[1,1],[0,0]]") + "]}");
    EXPECT_EQ(read_contour_stack(lines.string(), {.leave_out_open = true}).contours.size(), 1u);
}

std::string shared(const std::string& file) {
    return std::string(STRATAREEB_SOURCE_DIR "/../shared/data/") + file;
}

void expect_sound(const EnhancedReebGraph& graph) {
    const auto faults = faults_of(graph);
    EXPECT_TRUE(faults.empty()) << faults.size() << ", first: " << faults.front();
}

TEST(ReadContourStack, mount_st_helens) {
    if (!std::filesystem::exists(shared("contours_st_helens")))
        GTEST_SKIP() << "the shared data are not here";
    const ContourStack points = read_contour_stack(shared("contours_st_helens/ring_points.csv"));
    ASSERT_EQ(points.contours.size(), 114u);
    const ContourStack lines = read_contour_stack(shared("contours_st_helens/rings.geojson"));
    ASSERT_EQ(lines.contours.size(), 114u);
    for (std::size_t c = 0; c < 114; ++c)  // its coordinates are rounded to 0.1 m
        EXPECT_EQ(lines.contours[c].z, points.contours[c].z);
    const StackGraph all = graph_of_stack(points);
    expect_sound(all.graph);
    EXPECT_EQ(all.graph.nodes.size(), 145u);
    EXPECT_EQ(all.graph.edges.size(), 100u);
    EXPECT_TRUE(all.dropped.empty());
    ContourStack big;
    for (const StackContour& contour : points.contours) {
        double twice = 0;
        const Point2 o = contour.points[0];
        for (std::size_t i = 0; i + 1 < contour.points.size(); ++i) {
            const Point2 &a = contour.points[i], &b = contour.points[i + 1];
            twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
        }
        if (std::abs(twice) / 2 > 50000) big.contours.push_back(contour);
    }
    EXPECT_EQ(big.contours.size(), 37u);
    const StackGraph over_5ha = graph_of_stack(big);
    expect_sound(over_5ha.graph);
    EXPECT_EQ(testing::node_kinds(over_5ha.graph),
              (std::map<std::pair<int, int>, int>{
                  {{0, 1}, 6}, {{1, 0}, 9}, {{1, 2}, 2}, {{1, 3}, 1}, {{2, 1}, 1}}));
    EXPECT_TRUE(over_5ha.dropped.empty());
}

TEST(ReadContourStack, radiotherapy_structures) {
    if (!std::filesystem::exists(shared("contours_rtstruct"))) GTEST_SKIP() << "the shared data are not here";
    const std::map<std::string, std::size_t> contours{{"breast", 48}, {"heart", 33}};
    for (const std::string roi : {"heart", "breast", "tumor_bed", "tumor_bed_block", "scar", "nodes"}) {
        const ContourStack stack =
            read_contour_stack(shared("contours_rtstruct/contour_points.csv"), {.part = roi});
        if (contours.contains(roi)) {
            EXPECT_EQ(stack.contours.size(), contours.at(roi));
        }
        for (const StackEnds ends : {StackEnds::Domes, StackEnds::Flat}) {
            const StackGraph result = graph_of_stack(stack, {.ends = ends});
            expect_sound(result.graph);
            EXPECT_EQ(result.graph.edges.size(), roi == "breast" ? 3u : 1u);
            EXPECT_TRUE(result.dropped.empty());
        }
    }
}

}  // namespace
}  // namespace stratareeb
