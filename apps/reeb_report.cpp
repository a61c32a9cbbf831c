// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reeb_report.h"

#include <fmt/format.h>

#include <chrono>

#include "mesh/analysis.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/critical_points.h"

namespace stratareeb {

namespace {

struct CriticalCounts {
    int minima = 0, saddles = 0, maxima = 0;  // saddles with their multiplicity
};

CriticalCounts critical_counts(const TriMesh& mesh, const ScalarField& field) {
    CriticalCounts counts;
    for (const CriticalPoint& point : critical_points(mesh, field)) {
        counts.minima += point.type == CriticalType::Minimum;
        counts.saddles += point.type == CriticalType::Saddle ? point.multiplicity : 0;
        counts.maxima += point.type == CriticalType::Maximum;
    }
    return counts;
}

}  // namespace

std::string counted(std::size_t count, const char* thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

AskedGraph asked_graph(const TriMesh& mesh, const ScalarField& field, const AskedGraphOptions& options) {
    AskedGraph asked;
    const auto start = std::chrono::steady_clock::now();
    asked.fine = reeb_graph(mesh, field);
    asked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    asked.collapsed = collapse_plateaus(asked.fine);
    if (options.simplify) asked.simplified = simplify(asked.collapsed, mesh, field, *options.simplify);
    asked.plateaus = options.plateaus;
    return asked;
}

nlohmann::ordered_json reeb_json(const TriMesh& mesh, const ScalarField& field, const AskedGraph& asked) {
    const MeshReport report = analyze(mesh, {.self_intersections = false});
    const CriticalCounts critical = critical_counts(mesh, field);
    nlohmann::ordered_json json{
        {"vertices", report.vertices},
        {"triangles", report.triangles},
        {"components", report.components},
        {"boundary_loops", report.boundary_loops},
        {"genus", report.genus.value_or(0)},
        {"nodes", asked.graph().nodes.size()},
        {"arcs", asked.graph().arcs.size()},
        {"loops", asked.graph().loops()},
        {"collapsed", {{"nodes", asked.collapsed.nodes.size()}, {"arcs", asked.collapsed.arcs.size()}}},
        {"critical",
         {{"minimum", critical.minima}, {"saddle", critical.saddles}, {"maximum", critical.maxima}}},
        {"seconds", asked.seconds}};
    if (asked.simplified)
        json["simplified"] = {{"threshold", asked.simplified->threshold},
                              {"pruned_branches", asked.simplified->pruned_branches},
                              {"closed_loops", asked.simplified->closed_loops}};
    return json;
}

std::string reeb_text(const TriMesh& mesh, const ScalarField& field, const AskedGraph& asked) {
    const MeshReport report = analyze(mesh, {.self_intersections = false});
    const CriticalCounts critical = critical_counts(mesh, field);
    const ReebGraph& graph = asked.graph();
    std::string text = fmt::format("{} in {}, genus {}, {}\n", counted(report.triangles, "triangle"),
                                   counted(report.components, "component"), report.genus.value_or(0),
                                   counted(report.boundary_loops, "boundary loop"));
    text += fmt::format("Reeb graph: {}, {}, {}\n", counted(graph.nodes.size(), "node"),
                        counted(graph.arcs.size(), "arc"), counted(graph.loops(), "loop"));
    if (!asked.plateaus && !asked.simplified && asked.collapsed.nodes.size() != asked.fine.nodes.size())
        text += fmt::format("with each plateau as one node: {} nodes, {} arcs\n",
                            asked.collapsed.nodes.size(), asked.collapsed.arcs.size());
    if (asked.simplified)
        text += fmt::format("simplified: {} branches and {} loops below {:.6g} left out\n",
                            asked.simplified->pruned_branches, asked.simplified->closed_loops,
                            asked.simplified->threshold);
    return text + fmt::format("critical points: {} minima, {} saddles, {} maxima\n", critical.minima,
                              critical.saddles, critical.maxima);
}

}  // namespace stratareeb
