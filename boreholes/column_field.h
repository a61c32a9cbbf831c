// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/complete_columns.h"
#include "boreholes/rule_columns.h"
#include "boreholes/thickness_field.h"

namespace stratareeb {

//! What the holes say, and what predicts columns between them: all that layer models and hold-out tests share.
class ColumnField {
 public:
    //! Complete the holes' columns, in survey coordinates.
    //! \throw InvalidInput as complete_columns and rule_columns do
    ColumnField(const Survey& survey, const CompletionOptions& options);

    //! Count everything from there.
    void move_origin(const Point3& origin);
    const Point3& origin() const { return origin_; }

    //! Ready for predictions. Layers thinner than a share of `extent`, of the columns' depth and of the ground's range become absent.
    //! `bare`: on the plain Delaunay triangulation of the holes, as the thesis does; otherwise pinch-outs and all but linear
    //! predictions keep off flat triangles along the hull.
    void prepare(double extent, bool bare);

    const CompleteColumns& columns() const { return columns_; }
    const RuleColumns& rules() const { return rules_; }
    bool is_ruled() const { return options_.rules.any(); }
    double thinnest() const { return thinnest_; }  // a layer that is there
    const HoleTriangulation& holes() const { return *holes_; }
    const ThicknessField& thickness() const { return *field_; }

    //! The ground's elevation: the terrain, bent to pass through the elevations that holes give; without one, predicted from
    //! the holes'.
    std::vector<double> ground(std::span<const Point2> where) const;
    //! Under rules: the columns before younger units cut older ones.
    std::vector<UncutColumn> uncut(std::span<const Point2> where, std::span<const double> ground) const;

 private:
    void drop_thin_layers(double extent);
    void settle_unknown();
    std::optional<double> terrain(const Point2& p) const;
    std::unique_ptr<Interpolator> interpolator() const;

    CompletionOptions options_;
    RuleColumns rules_;  // without rules only columns
    CompleteColumns columns_;
    Point3 origin_{};
    double thinnest_ = 0;
    std::vector<std::vector<double>> bounds_;  // [layer][site]: the least that the hole says
    std::shared_ptr<const HoleTriangulation> holes_, sites_;
    std::unique_ptr<ThicknessField> field_;
};

}  // namespace stratareeb
