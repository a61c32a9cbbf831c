// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_viewer.h"

#include <zlib.h>

#include <stdexcept>
#include <string_view>

#include "io/base64.h"
#include "io/view_payload.h"
#include "io/viewer_template.h"
#include "io/write_aside.h"
#include "io/xml_text.h"

namespace stratareeb {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTitlePlace = "@@title@@", kModelPlace = "@@model@@";

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
        throw std::runtime_error("zlib: out of memory");
    packed.resize(size);
    return packed;
}

std::string folder_name(const fs::path& folder) {
    const fs::path whole = fs::absolute(folder).lexically_normal();
    return (whole.has_filename() ? whole.filename() : whole.parent_path().filename()).string();
}

}  // namespace

std::string viewer_page(const SavedModel& saved, const ViewerOptions& options, const fs::path& summary,
                        const LayerModel* unrefined) {
    const std::string payload = view_payload(saved, {options.title, options.report, summary, unrefined});
    const std::string_view whole = viewer_template();
    const std::size_t title = whole.find(kTitlePlace), model = whole.find(kModelPlace);
    if (title > model || model == std::string_view::npos)
        throw std::logic_error("viewer/dist/page.inc has no places for title and model; build it again");
    std::string page(whole.substr(0, title));
    page += xml_attribute(options.title);
    page += whole.substr(title + kTitlePlace.size(), model - title - kTitlePlace.size());
    page += base64(deflated(payload));
    page += whole.substr(model + kModelPlace.size());
    return page;
}

std::size_t write_viewer(const fs::path& folder, const fs::path& file, const ViewerOptions& options) {
    ViewerOptions used = options;
    if (used.title.empty()) used.title = folder_name(folder);
    if (used.report.empty() && fs::exists(fs::absolute(file).parent_path() / "report.html"))
        used.report = "report.html";
    const auto unrefined = read_unrefined(folder);
    const std::string page =
        viewer_page(read_model(folder), used, folder / "model.json", unrefined ? &*unrefined : nullptr);
    write_aside(file, [&](std::ostream& stream) { stream << page; });
    return page.size();
}

}  // namespace stratareeb
