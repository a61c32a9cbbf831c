// SPDX-License-Identifier: GPL-3.0-or-later
// Cells read back from files, by code that shares nothing with the writers.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace stratareeb::testing {

struct FileCell {
    int type = 0;  // the format's own number
    int layer = 0;
    std::vector<std::size_t> nodes;
};

struct CellFile {
    std::vector<std::array<double, 3>> points;
    std::vector<FileCell> cells, faces;
    std::map<std::string, std::vector<double>> data;  // cell data by name
    std::vector<std::string> groups;
};

//! The value of an attribute of an XML element.
inline std::string attribute(const std::string& element, const std::string& name) {
    const auto at = element.find(" " + name + "=\"");
    if (at == std::string::npos) return "";
    const auto begin = at + name.size() + 3;
    return element.substr(begin, element.find('"', begin) - begin);
}

//! A VTK unstructured grid with appended raw data, as ParaView's documentation of the format has it.
inline CellFile read_vtu(const std::string& text) {
    const auto appended = text.find('_', text.find("<AppendedData encoding=\"raw\">")) + 1;
    std::map<std::string, std::vector<double>> arrays;
    for (auto at = text.find("<DataArray"); at < appended; at = text.find("<DataArray", at + 1)) {
        const std::string element = text.substr(at, text.find('>', at) - at);
        if (attribute(element, "format") != "appended") continue;
        std::uint64_t bytes = 0;
        const char* from = text.data() + appended + std::stoull(attribute(element, "offset"));
        std::memcpy(&bytes, from, 8);
        const std::string type = attribute(element, "type");
        auto& values = arrays[attribute(element, "Name")];
        const auto take = [&](auto number) {
            for (std::size_t i = 0; i < bytes; i += sizeof number) {
                std::memcpy(&number, from + 8 + i, sizeof number);
                values.push_back(static_cast<double>(number));
            }
        };
        if (type == "Float64") take(double{});
        if (type == "Int64") take(std::int64_t{});
        if (type == "Int32") take(std::int32_t{});
        if (type == "UInt8") take(std::uint8_t{});
    }
    CellFile file;
    const auto& xyz = arrays["Points"];
    for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
        file.points.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
    std::size_t begin = 0;
    for (std::size_t i = 0; i < arrays["offsets"].size(); ++i) {
        const auto end = static_cast<std::size_t>(arrays["offsets"][i]);
        FileCell cell{.type = static_cast<int>(arrays["types"][i]),
                      .layer = static_cast<int>(arrays["layer"][i]),
                      .nodes = {}};
        for (; begin < end; ++begin)
            cell.nodes.push_back(static_cast<std::size_t>(arrays["connectivity"][begin]));
        file.cells.push_back(cell);
    }
    file.data = arrays;
    return file;
}

//! A gmsh file of version 2.2, from the format's description.
inline CellFile read_msh(const std::string& text) {
    CellFile file;
    std::istringstream in(text);
    const std::map<int, std::size_t> corners{{2, 3}, {3, 4}, {4, 4}, {6, 6}, {7, 5}};
    std::size_t count = 0;
    for (std::string line; std::getline(in, line);) {
        if (line == "$PhysicalNames")
            for (in >> count; count > 0; --count) {
                std::string dimension, tag, name;
                in >> dimension >> tag;
                std::getline(in, name);
                file.groups.push_back(dimension + " " + tag + name);
            }
        if (line == "$Nodes")
            for (in >> count; count > 0; --count) {
                std::array<double, 3> p{};
                in >> line >> p[0] >> p[1] >> p[2];
                file.points.push_back(p);
            }
        if (line == "$Elements")
            for (in >> count; count > 0; --count) {
                FileCell cell;
                std::size_t number = 0, tags = 0, elementary = 0;
                in >> number >> cell.type >> tags >> cell.layer >> elementary;
                cell.nodes.resize(corners.at(cell.type));
                for (auto& node : cell.nodes) in >> node, --node;
                (cell.type < 4 ? file.faces : file.cells).push_back(cell);
            }
    }
    return file;
}

inline double six_volumes(const CellFile& file, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    std::array<std::array<double, 3>, 3> e{};
    for (std::size_t i = 0; i < 3; ++i) {
        e[0][i] = file.points[b][i] - file.points[a][i];
        e[1][i] = file.points[c][i] - file.points[a][i];
        e[2][i] = file.points[d][i] - file.points[a][i];
    }
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

//! Of a prism whose first triangle is the lower one, a pyramid, or a tetrahedron; plane faces.
inline double volume(const CellFile& file, const std::vector<std::size_t>& n) {
    if (n.size() == 4) return six_volumes(file, n[0], n[1], n[2], n[3]) / 6;
    if (n.size() == 5)
        return (six_volumes(file, n[0], n[1], n[2], n[4]) + six_volumes(file, n[0], n[2], n[3], n[4])) / 6;
    return (six_volumes(file, n[0], n[1], n[2], n[3]) + six_volumes(file, n[1], n[2], n[3], n[4]) +
            six_volumes(file, n[2], n[3], n[4], n[5])) /
           6;
}

}  // namespace stratareeb::testing
