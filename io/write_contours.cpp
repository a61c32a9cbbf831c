// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_contours.h"

#include <string>

#include "boreholes/errors.h"
#include "io/text_output.h"
#include "io/write_aside.h"
#include "reeb/contour_nesting.h"

namespace stratareeb {

namespace {

void print_points(TextOutput& out, const Contour& contour, bool in_plan) {
    const char* comma = "";
    for (const Point3& p : contour.points) {
        if (in_plan)
            out.print("{}[{}, {}]", comma, p.x, p.y);
        else
            out.print("{}[{}, {}, {}]", comma, p.x, p.y, p.z);
        comma = ", ";
    }
}

void write_json(std::ostream& stream, std::span<const LevelSet> sets,
                const std::optional<Point3>& direction) {
    TextOutput out(stream);
    const bool in_plan = direction == Point3{0, 0, 1};
    out.print("{{");
    if (direction && !in_plan)
        out.print("\"direction\": [{}, {}, {}], ", direction->x, direction->y, direction->z);
    out.print("\"contours\": [");
    const char* comma = "\n";
    std::size_t first = 0;  // of the level's contours in the file
    for (const LevelSet& set : sets) {
        const ContourNesting nesting = direction ? nest_contours(set, *direction) : ContourNesting{};
        for (std::size_t c = 0; c < set.contours.size(); ++c) {
            out.print("{} {{\"z\": {}, \"closed\": {}, ", comma, set.level, set.contours[c].closed);
            if (direction && nesting.parent[c] == ContourNesting::kNone)
                out.print("\"depth\": 0, \"parent\": null, ");
            else if (direction)
                out.print("\"depth\": {}, \"parent\": {}, ", nesting.depth[c], first + nesting.parent[c]);
            out.print("\"points\": [");
            print_points(out, set.contours[c], in_plan);
            out.print("]}}");
            comma = ",\n";
        }
        first += set.contours.size();
    }
    out.print("\n]}}\n");
}

void write_obj(std::ostream& stream, std::span<const LevelSet> sets) {
    TextOutput out(stream);
    std::size_t first = 1;
    for (const LevelSet& set : sets)
        for (const Contour& contour : set.contours) {
            for (const Point3& p : contour.points) out.print("v {} {} {}\n", p.x, p.y, p.z);
            out.print("l");
            for (std::size_t i = 0; i < contour.points.size(); ++i) out.print(" {}", first + i);
            if (contour.closed) out.print(" {}", first);
            out.print("\n");
            first += contour.points.size();
        }
}

}  // namespace

void write_contours(const std::filesystem::path& file, std::span<const LevelSet> sets,
                    const std::optional<Point3>& direction) {
    const std::string extension = file.extension().string();
    if (extension != ".json" && extension != ".obj")
        throw IoError(file.string() + ": contours are written as .json or .obj");
    write_aside(file, [&](std::ostream& stream) {
        extension == ".json" ? write_json(stream, sets, direction) : write_obj(stream, sets);
    });
}

}  // namespace stratareeb
