// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_brep.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <ostream>

#include "boreholes/errors.h"
#include "io/write_aside.h"

namespace stratareeb {

void write_brep(const std::filesystem::path& path, std::span<const CadBody> bodies) {
    if (bodies.empty()) throw InvalidInput("no layer has a body; a BREP file needs at least one");
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const auto& body : bodies) builder.Add(compound, *body.solid);
    write_aside(path, [&](std::ostream& stream) { BRepTools::Write(compound, stream); });
}

}  // namespace stratareeb
