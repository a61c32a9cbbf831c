// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_contours.h"

#include <string>

#include "boreholes/errors.h"
#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

void write_json(std::ostream& stream, std::span<const LevelSet> sets) {
    TextOutput out(stream);
    out.print("{{\"contours\": [");
    const char* comma = "\n";
    for (const LevelSet& set : sets)
        for (const Contour& contour : set.contours) {
            out.print("{} {{\"z\": {}, \"closed\": {}, \"points\": [", comma, set.level, contour.closed);
            for (std::size_t i = 0; i < contour.points.size(); ++i)
                out.print("{}[{}, {}]", i ? ", " : "", contour.points[i].x, contour.points[i].y);
            out.print("]}}");
            comma = ",\n";
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

void write_contours(const std::filesystem::path& file, std::span<const LevelSet> sets) {
    const std::string extension = file.extension().string();
    if (extension != ".json" && extension != ".obj")
        throw IoError(file.string() + ": contours are written as .json or .obj");
    write_aside(file, [&](std::ostream& stream) {
        extension == ".json" ? write_json(stream, sets) : write_obj(stream, sets);
    });
}

}  // namespace stratareeb
