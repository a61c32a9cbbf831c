// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/contour_features.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/checked_json.h"
#include "io/contour_columns.h"
#include "io/quiet_gdal.h"

namespace stratareeb {

namespace {

class FeatureReader {
 public:
    FeatureReader(const std::string& file, const ReadContourStackOptions& options)
        : file_(file), options_(options), faults_(file) {}

    ContourStack read(GDALDataset& dataset) {
        for (int i = 0; i < dataset.GetLayerCount(); ++i) read_layer(*dataset.GetLayer(i));
        faults_.throw_if_any();
        if (options_.part.empty() && parts_.size() > 1)
            throw InvalidInput(fmt::format("{}: there are several bodies: {}; say which part to read", file_,
                                           fmt::join(parts_, ", ")));
        if (stack_.contours.empty())
            throw InvalidInput(
                options_.part.empty()
                    ? fmt::format("{}: there is no closed line or polygon in it", file_)
                    : fmt::format(
                          "{}: no contour belongs to {}{}", file_, options_.part,
                          parts_.empty() ? "" : fmt::format("; there are {}", fmt::join(parts_, ", "))));
        return std::move(stack_);
    }

 private:
    void read_layer(OGRLayer& layer) {
        std::vector<std::string> names;
        for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
            names.emplace_back(layer.GetLayerDefn()->GetFieldDefn(i)->GetNameRef());
        elevation_ = options_.elevation.empty() ? find_contour_column(names, ContourColumn::Elevation)
                                                : stated_contour_column(names, options_.elevation, file_);
        part_ = find_contour_column(names, ContourColumn::Part);
        if (part_ == elevation_) part_.reset();
        names_ = std::move(names);
        layer.ResetReading();
        while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) read_feature(*feature);
    }

    void read_feature(OGRFeature& feature) {
        name_ = fmt::format("feature {}", feature.GetFID());
        if (part_ && feature.IsFieldSetAndNotNull(static_cast<int>(*part_))) {
            const std::string part = feature.GetFieldAsString(static_cast<int>(*part_));
            parts_.insert(part);
            if (!options_.part.empty() && part != options_.part) return;
        } else if (!options_.part.empty()) {
            return;
        }
        const OGRGeometry* geometry = feature.GetGeometryRef();
        if (!geometry || geometry->IsEmpty()) return;
        const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry());
        const std::size_t before = stack_.contours.size();
        height_ = attribute_height(feature);
        add(*linear);
        const std::size_t added = stack_.contours.size() - before;
        for (std::size_t r = 0; added > 1 && r < added; ++r)
            stack_.contours[before + r].name += fmt::format(", ring {}", r + 1);
    }

    //! Nothing where it is to be the points' z; NaN if it is no number, which is told.
    std::optional<double> attribute_height(const OGRFeature& feature) {
        if (!elevation_) return std::nullopt;
        const int field = static_cast<int>(*elevation_);
        if (!feature.IsFieldSetAndNotNull(field) && options_.elevation.empty()) return std::nullopt;
        const bool is_real = feature.GetFieldDefnRef(field)->GetType() == OFTReal;
        const std::string text = is_real ? "" : feature.GetFieldAsString(field);
        const CellValue cell =
            is_real ? CellValue{CellKind::Number, feature.GetFieldAsDouble(field)} : cell_value(text);
        if (cell.kind == CellKind::Number && std::isfinite(cell.number)) return cell.number;
        faults_.add(name_, fmt::format("its {} is \"{}\" (expected a height)", names_[*elevation_],
                                       is_real ? fmt::format("{}", cell.number) : text));
        return std::nan("");
    }

    void add(const OGRGeometry& geometry) {
        switch (wkbFlatten(geometry.getGeometryType())) {
            case wkbLineString:
                return add_line(*geometry.toLineString());
            case wkbPolygon:
                for (const OGRLinearRing* ring : *geometry.toPolygon()) add_line(*ring);
                return;
            case wkbMultiPolygon:
            case wkbMultiLineString:
            case wkbGeometryCollection:
                for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part);
                return;
            default:
                return;
        }
    }

    void add_line(const OGRLineString& line) {
        const int count = line.getNumPoints();
        if (count == 0) return;
        const int last = count - 1;
        if (line.getX(0) != line.getX(last) || line.getY(0) != line.getY(last)) {
            if (!options_.leave_out_open)
                faults_.add(
                    name_,
                    fmt::format("its line is open, from ({:.10g}, {:.10g}) to ({:.10g}, {:.10g}); close it, "
                                "or leave open lines out",
                                line.getX(0), line.getY(0), line.getX(last), line.getY(last)));
            return;
        }
        StackContour contour{.z = 0, .points = {}, .name = name_};
        if (const auto z = height_ ? height_ : own_height(line))
            contour.z = *z;
        else
            return;
        for (int i = 0; i < last; ++i) contour.points.push_back({line.getX(i), line.getY(i)});
        stack_.contours.push_back(std::move(contour));
    }

    std::optional<double> own_height(const OGRLineString& line) {
        if (!line.Is3D()) {
            faults_.add(
                name_,
                elevation_
                    ? fmt::format("its {} is empty", names_[*elevation_])
                    : fmt::format("it has no height: no z and no attribute that is called so among: {}; "
                                  "say which one it is",
                                  fmt::join(names_, ", ")));
            return std::nullopt;
        }
        for (int i = 1; i < line.getNumPoints(); ++i)
            if (line.getZ(i) != line.getZ(0)) {
                faults_.add(name_,
                            fmt::format("its points 1 and {} have heights {} and {} (expected a level line)",
                                        i + 1, line.getZ(0), line.getZ(i)));
                return std::nullopt;
            }
        return line.getZ(0);
    }

    const std::string& file_;
    const ReadContourStackOptions& options_;
    FileFaults faults_;
    ContourStack stack_;
    std::set<std::string> parts_;
    // Of the layer and of the feature being read:
    std::vector<std::string> names_;
    std::optional<std::size_t> elevation_, part_;
    std::string name_;
    std::optional<double> height_;
};

}  // namespace

ContourStack read_contour_features(const std::string& file, const ReadContourStackOptions& options) {
    GDALAllRegister();
    const QuietErrors quiet;
    const std::array<const char*, 3> open{"GEOM_POSSIBLE_NAMES=WKT,geometry,geom,the_geom",
                                          "AUTODETECT_TYPE=YES", nullptr};
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, open.data(), nullptr));
    if (!dataset) throw IoError(fmt::format("{}: not a file of lines or polygons that can be opened", file));
    return FeatureReader(file, options).read(*dataset);
}

}  // namespace stratareeb
