// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/feature_geometries.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>

#include "boreholes/errors.h"
#include "io/quiet_gdal.h"

namespace stratareeb {

void for_each_geometry(const std::string& path, const std::string& content,
                       const std::function<void(OGRGeometry&)>& visit) {
    GDALAllRegister();
    const QuietErrors quiet;
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
    if (!dataset) throw IoError(fmt::format("{}: not a file of {} that can be opened", path, content));
    for (int i = 0; i < dataset->GetLayerCount(); ++i) {
        OGRLayer& layer = *dataset->GetLayer(i);
        layer.ResetReading();
        while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()})
            if (const OGRGeometry* geometry = feature->GetGeometryRef()) {
                const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry());
                visit(*linear);
            }
    }
}

}  // namespace stratareeb
