// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/enhanced_reeb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "apps/field_option.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "apps/progress.h"
#include "apps/reeb_report.h"
#include "boreholes/errors.h"
#include "io/write_enhanced_graph.h"
#include "reeb/graph_of_mesh.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

namespace {

using Rotation = std::array<Point3, 3>;  // rows: the new x, y and z axes

double dot(const Point3& a, const Point3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

//! The shortest rotation that turns a direction upward; what points down is turned over about the x axis first, so that
//! no denominator comes near 0.
Rotation upward(const Point3& direction) {
    // By the largest coordinate first: a direction may be too long or too short to be squared.
    const double most = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    const Point3 d{direction.x / most, direction.y / most, direction.z / most};
    const double length = std::sqrt(dot(d, d)), side = d.z < 0 ? -1 : 1;
    const Point3 u{d.x / length, side * d.y / length, side * d.z / length};
    const double k = 1 / (1 + u.z);
    return {Point3{1 - k * u.x * u.x, -side * k * u.x * u.y, -side * u.x},
            Point3{-k * u.x * u.y, side * (1 - k * u.y * u.y), -side * u.y},
            Point3{u.x, side * u.y, side * u.z}};
}

void turn(TriMesh& mesh, const Rotation& rotation) {
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        const Point3 point{p[0], p[1], p[2]};
        mesh.set_point(v, {dot(rotation[0], point), dot(rotation[1], point), dot(rotation[2], point)});
    }
}

std::string rotation_text(const Rotation& rotation) {
    std::string text;
    for (std::size_t row = 0; row < 3; ++row)
        text +=
            fmt::format("{}{} = {} X + {} Y + {} Z", row > 0 ? ", " : "", "xyz"[row], rotation[row].x + 0.0,
                        rotation[row].y + 0.0, rotation[row].z + 0.0);  // + 0: no -0
    return text;
}

//! A direction near to the given one along which level parts are not level.
std::string tilted(const Point3& direction) {
    const Rotation rotation = upward(direction);
    const double length = std::hypot(direction.x, direction.y, direction.z);
    const auto part = [&](double of, double x, double y) { return of + length * (0.001 * x + 0.0007 * y); };
    return fmt::format("{:.6g},{:.6g},{:.6g}", part(direction.x, rotation[0].x, rotation[1].x),
                       part(direction.y, rotation[0].y, rotation[1].y),
                       part(direction.z, rotation[0].z, rotation[1].z));
}

bool has_plateau(const ReebGraph& graph) {
    return std::ranges::any_of(graph.arcs, [&](const ReebArc& arc) {
        return graph.nodes[arc.lower].value == graph.nodes[arc.upper].value;
    });
}

void check_output(const ReebArguments& arguments) {
    if (arguments.output.empty()) return;
    if (std::filesystem::path(arguments.output).extension() != ".json")
        throw IoError(arguments.output + ": enhanced Reeb graphs are written as .json");
    keep_existing(arguments.output, arguments.overwrite);
}

class EnhancedReeb {
 public:
    explicit EnhancedReeb(const ReebArguments& arguments)
        : arguments_(arguments), direction_(*field_direction(arguments.field)) {}

    void run() {
        check_output(arguments_);
        progress_.step("reading", 0);
        input_ = read_input_mesh(arguments_.meshes.front(), arguments_.repair);
        turn_upward();
        progress_.step("graph", 0.2);
        field_ = height_field(input_.mesh);
        asked_ = asked_graph(input_.mesh, field_, {});
        progress_.step("contours", 0.3);
        find_graph();
        progress_.step("writing", 0.8);
        if (!arguments_.output.empty()) write_enhanced_graph(arguments_.output, graph_, comment_);
        progress_.clear();
        arguments_.json ? print_json() : print_text();
    }

 private:
    void turn_upward() {
        if (direction_.x == 0 && direction_.y == 0 && direction_.z > 0) return;
        if (direction_.x == 0 && direction_.y == 0 && direction_.z == 0)
            throw InvalidInput("--field 0,0,0: the direction has no length");
        const Rotation rotation = upward(direction_);
        turn(input_.mesh, rotation);
        comment_ = fmt::format("Turned so that ({}, {}, {}) is up: a point (X, Y, Z) of the mesh is at {}.",
                               direction_.x, direction_.y, direction_.z, rotation_text(rotation));
        progress_.clear();
        fmt::print(stderr, "{}: turned so that ({}, {}, {}) is up; the graph is in turned coordinates\n",
                   input_.file, direction_.x, direction_.y, direction_.z);
    }

    void find_graph() {
        const auto start = std::chrono::steady_clock::now();
        try {
            graph_ =
                graph_of_mesh(input_.mesh, {.levels = arguments_.levels, .tolerance = arguments_.tolerance});
        } catch (const InvalidInput& error) {
            const std::string way_out =
                has_plateau(asked_.fine) ? ", as in --field " + tilted(direction_) : "";
            throw InvalidInput(fmt::format("{}: {}{}", input_.file, error.what(), way_out));
        }
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void print_json() const {
        auto json = reeb_json(input_.mesh, field_, asked_);
        json["contours"] = graph_.contours.size();
        json["turned"] = !comment_.empty();
        json["seconds"] = seconds_;
        fmt::print("{}\n", json.dump(2));
    }

    void print_text() const {
        fmt::print("{}enhanced Reeb graph: {}, {}, {}, {}\n", reeb_text(input_.mesh, field_, asked_),
                   counted(graph_.nodes.size(), "node"), counted(graph_.edges.size(), "edge"),
                   counted(graph_.contours.size(), "contour"), counted(loops_of(graph_), "loop"));
    }

    const ReebArguments& arguments_;
    const Point3 direction_;
    Progress progress_{"reeb"};
    InputMesh input_;
    ScalarField field_;
    AskedGraph asked_;
    EnhancedReebGraph graph_;
    std::string comment_;
    double seconds_ = 0;
};

}  // namespace

void run_enhanced_reeb(const ReebArguments& arguments) {
    EnhancedReeb(arguments).run();
}

}  // namespace stratareeb
