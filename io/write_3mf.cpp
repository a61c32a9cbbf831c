// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_3mf.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>

#include <cmath>

#include "boreholes/errors.h"
#include "io/three_mf.h"
#include "io/write_aside.h"
#include "mesh/measures.h"

namespace stratareeb {
namespace {

using namespace NMR;

class ThreeMfWriter {
 public:
    explicit ThreeMfWriter(std::string file) : file_(std::move(file)) {
        if (lib3mf_createmodel(model_.out()) != 0) throw IoError(file_ + ": lib3mf can't make a model");
        check(lib3mf_model_setunit(model_.get(), MODELUNIT_METER), model_);
        check(lib3mf_model_addbasematerialgroup(model_.get(), materials_.out()), model_);
    }

    void add(const PartData& part, const Point3& origin) {
        ThreeMfObject mesh;
        check(lib3mf_model_addmeshobject(model_.get(), mesh.out()), model_);
        check(lib3mf_object_setnameutf8(mesh.get(), part.name.c_str()), mesh);
        set_geometry(mesh, part.soup, origin);
        set_material(mesh, part);
        MODELTRANSFORM place{};
        for (int k = 0; k < 3; ++k) place.m_fFields[k][k] = 1;
        place.m_fFields[0][3] = static_cast<float>(origin.x);
        place.m_fFields[1][3] = static_cast<float>(origin.y);
        place.m_fFields[2][3] = static_cast<float>(origin.z);
        ThreeMfObject item;
        check(lib3mf_model_addbuilditem(model_.get(), mesh.get(), &place, item.out()), model_);
    }

    void write(const std::filesystem::path& to) {
        ThreeMfObject writer;
        check(lib3mf_model_querywriter(model_.get(), "3mf", writer.out()), model_);
        check(lib3mf_writer_writetofileutf8(writer.get(), to.string().c_str()), writer);
    }

 private:
    void set_geometry(const ThreeMfObject& mesh, const TriangleSoup& soup, const Point3& origin) {
        std::vector<MODELMESHVERTEX> vertices;
        for (const auto& p : soup.points)
            vertices.push_back({{static_cast<float>(p.x - origin.x), static_cast<float>(p.y - origin.y),
                                 static_cast<float>(p.z - origin.z)}});
        std::vector<MODELMESHTRIANGLE> triangles;
        for (const auto& t : soup.triangles) triangles.push_back({{t[0], t[1], t[2]}});
        check(lib3mf_meshobject_setgeometry(mesh.get(), vertices.data(), static_cast<DWORD>(vertices.size()),
                                            triangles.data(), static_cast<DWORD>(triangles.size())),
              mesh);
    }

    void set_material(const ThreeMfObject& mesh, const PartData& part) {
        DWORD index = 0, group = 0;
        check(lib3mf_basematerial_addmaterialutf8(materials_.get(), part.name.c_str(), part.color[0],
                                                  part.color[1], part.color[2], &index),
              materials_);
        check(lib3mf_basematerial_getresourceid(materials_.get(), &group), materials_);
        ThreeMfObject property;
        check(lib3mf_object_createdefaultpropertyhandler(mesh.get(), property.out()), mesh);
        check(lib3mf_defaultpropertyhandler_setbasematerial(property.get(), group, index), property);
    }

    void check(LIB3MFRESULT result, const ThreeMfObject& object) const {
        if (result != 0) throw IoError(fmt::format("{}: can't be written: {}", file_, object.error()));
    }

    std::string file_;
    ThreeMfObject model_, materials_;
};

}  // namespace

void write_3mf(const std::filesystem::path& file, std::span<const PartData> parts) {
    std::vector<Point3> corners;
    for (const auto& part : parts) {
        const auto box = bounding_box(part.soup.points);
        if (!part.soup.points.empty()) corners.insert(corners.end(), {box.min, box.max});
    }
    const auto middle = bounding_box(corners).centre();
    // Rounded to whole numbers, which the float transformation of a build item can hold up to 16 million.
    const Point3 origin{std::round(middle.x), std::round(middle.y), std::round(middle.z)};
    ThreeMfWriter writer(file.string());
    for (const auto& part : parts)
        if (!part.soup.triangles.empty()) writer.add(part, origin);  // 3MF knows no empty meshes
    replace_aside(file, [&](const std::filesystem::path& temporary) { writer.write(temporary); });
}

}  // namespace stratareeb
