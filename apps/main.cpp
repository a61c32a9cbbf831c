// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>

#include "apps/command.h"
#include "boreholes/errors.h"

int main(int argc, char** argv) {
    using namespace stratareeb;
    CLI::App program{"Borehole tables to smooth, watertight, conforming layer solids."};
    program.set_version_flag("--version", std::string("stratareeb ") + STRATAREEB_VERSION);
    program.require_subcommand(1);
    add_build_command(program);
    add_cells_command(program);
    add_check_command(program);
    add_convert_command(program);
    add_decimate_command(program);
    add_deliver_command(program);
    add_grid_command(program);
    add_info_command(program);
    add_levels_command(program);
    add_map_command(program);
    add_query_command(program);
    add_reconstruct_command(program);
    add_reeb_command(program);
    add_refine_command(program);
    add_sample_command(program);
    add_report_command(program);
    add_section_command(program);
    add_split_command(program);
    add_thin_command(program);
    add_validate_command(program);
    add_view_command(program);
    add_volume_command(program);
    add_voxels_command(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const CommandFailed&) {
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "stratareeb: %s\n", error.what());
        return 1;
    }
    return 0;
}
