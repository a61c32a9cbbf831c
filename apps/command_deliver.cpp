// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "apps/command.h"
#include "apps/deliver.h"

namespace stratareeb {

void add_deliver_command(CLI::App& program) {
    const auto arguments = std::make_shared<DeliverArguments>();
    CLI::App* command = program.add_subcommand(
        "deliver", "One folder to hand over: report, sections, maps, tables and the model's files");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    add_report_options(*command, arguments->choices);
    command->add_option("-o,--output", arguments->output, "Folder to write")->required();
    command->add_option(
        "--crs", arguments->crs,
        "Coordinate reference system of the model for GIS files, as EPSG:27700 (the model's own)");
    command->add_flag("--overwrite", arguments->overwrite,
                      "Write into a folder that holds something already");
    command->callback([arguments] { deliver(*arguments); });
}

}  // namespace stratareeb
