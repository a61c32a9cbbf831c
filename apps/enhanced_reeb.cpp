// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/enhanced_reeb.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "apps/field_option.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "apps/progress.h"
#include "apps/reeb_report.h"
#include "apps/turned_frame.h"
#include "boreholes/errors.h"
#include "io/write_enhanced_graph.h"
#include "reeb/graph_of_mesh.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

namespace {

std::string rotation_text(const PlaneFrame& frame) {
    std::string text;
    for (const auto& [name, axis] : {std::pair{'x', frame.u}, {'y', frame.v}, {'z', frame.w}})
        text += fmt::format("{}{} = {} X + {} Y + {} Z", text.empty() ? "" : ", ", name, axis.x + 0.0,
                            axis.y + 0.0, axis.z + 0.0);  // + 0: no -0
    return text;
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
        if (!arguments_.output.empty()) write_enhanced_graph(arguments_.output, graph_, comment_, axes_);
        progress_.clear();
        arguments_.json ? print_json() : print_text();
    }

 private:
    void turn_upward() {
        if (direction_.x == 0 && direction_.y == 0 && direction_.z > 0) return;
        axes_ = upward_frame(direction_);
        turn_into(input_.mesh, *axes_);
        comment_ = fmt::format("Turned so that ({}, {}, {}) is up: a point (X, Y, Z) of the mesh is at {}.",
                               direction_.x, direction_.y, direction_.z, rotation_text(*axes_));
        progress_.clear();
        fmt::print(stderr, "{}: turned so that ({}, {}, {}) is up; reconstruct turns the surface back\n",
                   input_.file, direction_.x, direction_.y, direction_.z);
    }

    void find_graph() {
        const auto start = std::chrono::steady_clock::now();
        try {
            graph_ =
                graph_of_mesh(input_.mesh, {.levels = arguments_.levels, .tolerance = arguments_.tolerance});
        } catch (const InvalidInput& error) {
            throw InvalidInput(fmt::format("{}: {}", input_.file, error.what()));
        }
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void print_json() const {
        auto json = reeb_json(input_.mesh, field_, asked_);
        json["contours"] = graph_.contours.size();
        json["turned"] = axes_.has_value();
        json["flat_nodes"] = count_of(NodeForm::Flat);
        json["open_nodes"] = count_of(NodeForm::Open);
        json["seconds"] = seconds_;
        fmt::print("{}\n", json.dump(2));
    }

    void print_text() const {
        fmt::print("{}enhanced Reeb graph: {}, {}, {}, {}\n", reeb_text(input_.mesh, field_, asked_),
                   counted(graph_.nodes.size(), "node"), counted(graph_.edges.size(), "edge"),
                   counted(graph_.contours.size(), "contour"), counted(loops_of(graph_), "loop"));
        const std::size_t flat = count_of(NodeForm::Flat), open = count_of(NodeForm::Open);
        if (flat > 0) fmt::print("{} where the surface is level\n", counted(flat, "node"));
        if (open > 0) fmt::print("{} where it ends in a boundary\n", counted(open, "node"));
    }

    std::size_t count_of(NodeForm form) const {
        return static_cast<std::size_t>(std::ranges::count(graph_.nodes, form, &EnhancedNode::form));
    }

    const ReebArguments& arguments_;
    const Point3 direction_;
    Progress progress_{"reeb"};
    InputMesh input_;
    ScalarField field_;
    AskedGraph asked_;
    EnhancedReebGraph graph_;
    std::optional<PlaneFrame> axes_;
    std::string comment_;
    double seconds_ = 0;
};

}  // namespace

void run_enhanced_reeb(const ReebArguments& arguments) {
    EnhancedReeb(arguments).run();
}

}  // namespace stratareeb
