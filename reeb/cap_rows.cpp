// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cap_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "reeb/cap_profile.h"
#include "reeb/cap_slopes.h"
#include "reeb/monotone_edge.h"
#include "reeb/point_math.h"
#include "reeb/sliding_homotopy.h"

namespace stratareeb {

namespace {

using Kind = StrandEnd::Kind;

class CapRows {
 public:
    CapRows(const CapBase& base, const std::vector<Point3>& targets, const Strand& strand,
            const ContourHomotopy* homotopy)
        : base_(base),
          targets_(targets),
          strand_(strand),
          homotopy_(homotopy),
          end_(base.is_top ? strand.top : strand.bottom) {
        if (strand.lean && end_.kind == Kind::Tip) edge_.emplace(*strand.lean);
    }

    std::vector<SampledContour> run(std::size_t steps) const {
        const double node_z = end_.node.z;
        const auto own = CapProfile::of(strand_.homotopy.kind);
        std::vector<CapProfile> profiles;
        if (!own)
            for (const double slope : slopes())
                profiles.push_back(CapProfile::conic(end_.is_outline ? std::max(slope, 0.0) : slope));
        std::vector<SampledContour> rows;
        for (std::size_t j = steps - 1; j > 0; --j) {
            const double root = static_cast<double>(j) / static_cast<double>(steps), x = root * root;
            const double z = node_z + x * (base_.height - node_z);
            SampledContour row = base_.contour;
            for (std::size_t i = 0; i < row.points.size(); ++i) {
                Point3& p = row.points[i];
                const Point3& target = targets_[i];
                const double width = (own ? *own : profiles[i]).width(x);
                p = {target.x + width * (p.x - target.x), target.y + width * (p.y - target.y),
                     z + width * (p.z - base_.height)};
            }
            if (edge_) lean_over(row, x, z);
            rows.push_back(std::move(row));
        }
        return rows;
    }

 private:
    //! The lean of SlidingHomotopy, between a tip and a contour.
    void lean_over(SampledContour& row, double x, double z) const {
        const Point3 own = mean_point(row), edge = edge_->at(z);
        const double weight = sliding_weight(x);
        for (Point3& p : row.points) p = p + Point3{weight * (edge.x - own.x), weight * (edge.y - own.y), 0};
    }

    //! How the contour's width goes on from a cap at each of its points, d width / d x of CapProfile at x = 1.
    std::vector<double> slopes() const {
        const double rise = std::abs(base_.height - end_.node.z);
        if (!homotopy_) return std::vector<double>(targets_.size(), single_slope(rise));
        constexpr double kStep = 1e-3;
        const std::size_t interval = base_.is_top ? homotopy_->intervals() - 1 : 0;
        const SampledContour& contour = homotopy_->contours()[base_.is_top ? interval + 1 : 0];
        const double t = base_.is_top ? 1 - kStep : kStep;
        const double way = std::abs(homotopy_->level(interval, t) - base_.height);
        return cap_slopes(contour.points, targets_, homotopy_->contour_at(contour.parameters, interval, t),
                          way / rise);
    }

    //! A contour alone between two tips: the ellipsoid through them. Between a tip and a saddle: upright.
    double single_slope(double rise) const {
        if (strand_.bottom.kind != Kind::Tip || strand_.top.kind != Kind::Tip) return 0;
        const double whole = strand_.top.node.z - strand_.bottom.node.z;
        return 1 - whole / (whole - rise) / 2;
    }

    const CapBase& base_;
    const std::vector<Point3>& targets_;
    const Strand& strand_;
    const ContourHomotopy* homotopy_;
    const StrandEnd& end_;
    std::optional<MonotoneEdge> edge_;  // to lean along
};

}  // namespace

std::vector<SampledContour> cap_rows(const CapBase& base, const std::vector<Point3>& targets,
                                     const Strand& strand, const ContourHomotopy* homotopy,
                                     std::size_t steps) {
    return CapRows(base, targets, strand, homotopy).run(steps);
}

}  // namespace stratareeb
