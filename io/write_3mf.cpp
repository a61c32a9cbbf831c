// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_3mf.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "io/write_aside.h"
#include "io/xml_text.h"
#include "io/zip_writer.h"
#include "mesh/measures.h"

// A 3MF file is a ZIP archive with an XML model in it. It is written here and not by lib3mf, whose
// version 1.8 rounds transformations to six digits and stamps random identifiers into the file.
namespace stratareeb {
namespace {

constexpr const char* kContentTypes =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";

constexpr const char* kRelations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Id=\"model\" Target=\"/3D/3dmodel.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

// Formatted text into the open entry of an archive.
class EntryText {
 public:
    explicit EntryText(ZipWriter& zip) : zip_(zip) {}

    template <class... Arguments>
    void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
        if (buffer_.size() > (1 << 18)) flush();
    }
    void flush() {
        zip_.append({buffer_.data(), buffer_.size()});
        buffer_.clear();
    }

 private:
    ZipWriter& zip_;
    fmt::memory_buffer buffer_;
};

// Middle of all parts, in whole numbers: floats hold those exactly up to 16 million.
Point3 local_origin(std::span<const PartData> parts) {
    std::vector<Point3> corners;
    for (const auto& part : parts) {
        const auto box = bounding_box(part.soup.points);
        if (!part.soup.points.empty()) corners.insert(corners.end(), {box.min, box.max});
    }
    const auto middle = bounding_box(corners).centre();
    return {std::round(middle.x), std::round(middle.y), std::round(middle.z)};
}

void print_object(EntryText& out, const PartData& part, std::size_t number, const Point3& origin) {
    out.print(
        "  <object id=\"{}\" name=\"{}\" type=\"model\" pid=\"1\" pindex=\"{}\">\n   <mesh>\n    "
        "<vertices>\n",
        number + 2, xml_attribute(part.name), number);
    for (const auto& p : part.soup.points)
        out.print("     <vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", static_cast<float>(p.x - origin.x),
                  static_cast<float>(p.y - origin.y), static_cast<float>(p.z - origin.z));
    out.print("    </vertices>\n    <triangles>\n");
    for (const auto& t : part.soup.triangles)
        out.print("     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", t[0], t[1], t[2]);
    out.print("    </triangles>\n   </mesh>\n  </object>\n");
}

void print_model(EntryText& out, std::span<const PartData> parts) {
    const auto origin = local_origin(parts);
    out.print(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"meter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
        " <metadata name=\"Application\">Stratareeb</metadata>\n <resources>\n  <basematerials id=\"1\">\n");
    for (const auto& part : parts)
        out.print("   <base name=\"{}\" displaycolor=\"{}\"/>\n", xml_attribute(part.name),
                  text_from_rgb(part.color));
    out.print("  </basematerials>\n");
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i].soup.triangles.empty())
            print_object(out, parts[i], i, origin);  // 3MF knows no empty meshes
    out.print(" </resources>\n <build>\n");
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i].soup.triangles.empty())
            out.print("  <item objectid=\"{}\" transform=\"1 0 0 0 1 0 0 0 1 {:.0f} {:.0f} {:.0f}\"/>\n",
                      i + 2, origin.x, origin.y, origin.z);
    out.print(" </build>\n</model>\n");
}

void put_entry(ZipWriter& zip, const char* name, std::string_view content) {
    zip.begin(name);
    zip.append(content);
    zip.end();
}

}  // namespace

void write_3mf(const std::filesystem::path& file, std::span<const PartData> parts) {
    write_aside(file, [&](std::ostream& stream) {
        ZipWriter zip(stream);
        put_entry(zip, "[Content_Types].xml", kContentTypes);
        put_entry(zip, "_rels/.rels", kRelations);
        zip.begin("3D/3dmodel.model");
        EntryText out(zip);
        print_model(out, parts);
        out.flush();
        zip.end();
        zip.finish();
    });
}

}  // namespace stratareeb
