// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_meshlab_project.h"

#include "io/text_output.h"
#include "io/write_aside.h"
#include "io/xml_text.h"

namespace stratareeb {
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
                xml_attribute(name), xml_attribute(mesh));
        out.print(" </MeshGroup>\n <RasterGroup/>\n</MeshLabProject>\n");
    });
}

}  // namespace stratareeb
