// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_3mf.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "boreholes/errors.h"
#include "io/text_scanner.h"
#include "io/three_mf.h"

namespace stratareeb {
namespace {

using namespace NMR;

constexpr std::uint64_t kMostTriangles =
    200'000'000;  // what components may add up to by using a mesh again and again
constexpr std::uint64_t kMostObjects = 1'000'000;

class ThreeMfReader {
 public:
    explicit ThreeMfReader(std::string file) : file_(std::move(file)) {
        if (lib3mf_createmodel(model_.out()) != 0) throw IoError(file_ + ": lib3mf can't make a model");
    }

    std::vector<PartData> parts(std::string content) {
        ThreeMfObject reader;
        check(lib3mf_model_queryreader(model_.get(), "3mf", reader.out()), model_);
        check(lib3mf_reader_readfrombuffer(reader.get(), reinterpret_cast<BYTE*>(content.data()),
                                           content.size()),
              reader);
        ThreeMfObject items;
        check(lib3mf_model_getbuilditems(model_.get(), items.out()), model_);
        for (BOOL more = false; check(lib3mf_builditemiterator_movenext(items.get(), &more), items), more;) {
            ThreeMfObject item, object;
            check(lib3mf_builditemiterator_getcurrent(items.get(), item.out()), items);
            check(lib3mf_builditem_getobjectresource(item.get(), object.out()), item);
            MODELTRANSFORM place;
            check(lib3mf_builditem_getobjecttransform(item.get(), &place), item);
            add(object, affine(place), 0);
        }
        return std::move(parts_);
    }

 private:
    static Eigen::Affine3d affine(const MODELTRANSFORM& transform) {
        Eigen::Affine3d result = Eigen::Affine3d::Identity();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 4; ++j) result(i, j) = double{transform.m_fFields[i][j]};
        return result;
    }

    void add(const ThreeMfObject& object, const Eigen::Affine3d& place, int depth) {
        if (depth > 100 || ++objects_ > kMostObjects) fail("components are nested too deeply");
        BOOL is_mesh = false;
        check(lib3mf_object_ismeshobject(object.get(), &is_mesh), object);
        if (is_mesh) return add_mesh(object, place);
        DWORD count = 0;
        check(lib3mf_componentsobject_getcomponentcount(object.get(), &count), object);
        for (DWORD i = 0; i < count; ++i) {
            ThreeMfObject component, child;
            check(lib3mf_componentsobject_getcomponent(object.get(), i, component.out()), object);
            check(lib3mf_component_getobjectresource(component.get(), child.out()), component);
            MODELTRANSFORM transform;
            check(lib3mf_component_gettransform(component.get(), &transform), component);
            add(child, place * affine(transform), depth + 1);
        }
    }

    void add_mesh(const ThreeMfObject& mesh, const Eigen::Affine3d& place) {
        DWORD vertices = 0, triangles = 0;
        check(lib3mf_meshobject_getvertexcount(mesh.get(), &vertices), mesh);
        check(lib3mf_meshobject_gettrianglecount(mesh.get(), &triangles), mesh);
        triangles_ += triangles;
        if (triangles_ > kMostTriangles) fail("the components unfold to more triangles than are read");
        std::vector<MODELMESHVERTEX> positions(vertices);
        std::vector<MODELMESHTRIANGLE> corners(triangles);
        if (vertices > 0)
            check(lib3mf_meshobject_getvertices(mesh.get(), positions.data(), vertices, nullptr), mesh);
        if (triangles > 0)
            check(lib3mf_meshobject_gettriangleindices(mesh.get(), corners.data(), triangles, nullptr), mesh);
        PartData part{name(mesh), color(mesh), {}, {}};
        for (const auto& v : positions) {
            const Eigen::Vector3d p =
                place *
                Eigen::Vector3d(double{v.m_fPosition[0]}, double{v.m_fPosition[1]}, double{v.m_fPosition[2]});
            if (!p.allFinite()) fail("a coordinate is not a finite number");
            part.soup.points.push_back({p.x(), p.y(), p.z()});
        }
        const bool mirrored = place.linear().determinant() < 0;
        for (const auto& t : corners) {
            for (const auto v : t.m_nIndices)
                if (v >= vertices)
                    fail(fmt::format("vertex index {} is out of range; there are {} vertices", v, vertices));
            part.soup.triangles.push_back(
                {t.m_nIndices[0], t.m_nIndices[mirrored ? 2 : 1], t.m_nIndices[mirrored ? 1 : 2]});
        }
        parts_.push_back(std::move(part));
    }

    std::string name(const ThreeMfObject& object) const {
        ULONG size = 0;
        if (lib3mf_object_getnameutf8(object.get(), nullptr, 0, &size) != 0 || size == 0) return "";
        std::string result(size + 1, '\0');
        if (lib3mf_object_getnameutf8(object.get(), result.data(), size + 1, &size) != 0) return "";
        result.resize(result.find('\0'));
        return result;
    }

    Rgb color(const ThreeMfObject& object) const {
        ThreeMfObject property, materials;
        DWORD group = 0, index = 0;
        BYTE r = 0, g = 0, b = 0, alpha = 0;
        const bool known =
            lib3mf_object_createdefaultpropertyhandler(object.get(), property.out()) == 0 &&
            lib3mf_defaultpropertyhandler_getbasematerial(property.get(), &group, &index) == 0 &&
            group != 0 && lib3mf_model_getbasematerialbyid(model_.get(), group, materials.out()) == 0 &&
            lib3mf_basematerial_getdisplaycolor(materials.get(), index, &r, &g, &b, &alpha) == 0;
        return known ? Rgb{r, g, b} : PartData{}.color;
    }

    [[noreturn]] void fail(const std::string& message) const { throw InvalidInput(file_ + ": " + message); }

    void check(LIB3MFRESULT result, const ThreeMfObject& object) const {
        if (result != 0) fail("not a sound 3MF file: " + object.error());
    }

    std::string file_;
    ThreeMfObject model_;
    std::uint64_t triangles_ = 0, objects_ = 0;
    std::vector<PartData> parts_;
};

}  // namespace

std::vector<PartData> read_3mf(const std::filesystem::path& file) {
    return ThreeMfReader(file.string()).parts(file_content(file));
}

}  // namespace stratareeb
