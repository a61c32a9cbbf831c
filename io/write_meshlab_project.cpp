// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_meshlab_project.h"

#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

// Text as an XML attribute. Control characters have no place in XML at all.
std::string attribute(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    }
    return result;
}

}  // namespace

void write_meshlab_project(const std::filesystem::path& file,
                           const std::vector<std::pair<std::string, std::string>>& name_and_relative_file) {
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        out.print("<!DOCTYPE MeshLabDocument>\n<MeshLabProject>\n <MeshGroup>\n");
        for (const auto& [name, mesh] : name_and_relative_file)
            out.print(
                "  <MLMesh label=\"{}\" filename=\"{}\">\n"
                "   <MLMatrix44>\n1 0 0 0 \n0 1 0 0 \n0 0 1 0 \n0 0 0 1 \n</MLMatrix44>\n"
                "  </MLMesh>\n",
                attribute(name), attribute(mesh));
        out.print(" </MeshGroup>\n <RasterGroup/>\n</MeshLabProject>\n");
    });
}

}  // namespace stratareeb
