// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace stratareeb {

// Each command file adds its subcommand to the program; its callback runs the command. A callback throws on failure;
// main turns exceptions into exit codes (0 done, 1 failed, 2 wrong usage). Results go to stdout, messages to stderr.
void add_build_command(CLI::App& program);
void add_cells_command(CLI::App& program);
void add_check_command(CLI::App& program);
void add_convert_command(CLI::App& program);
void add_decimate_command(CLI::App& program);
void add_grid_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_levels_command(CLI::App& program);
void add_map_command(CLI::App& program);
void add_query_command(CLI::App& program);
void add_reconstruct_command(CLI::App& program);
void add_reeb_command(CLI::App& program);
void add_refine_command(CLI::App& program);
void add_sample_command(CLI::App& program);
void add_section_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_deliver_command(CLI::App& program);
void add_split_command(CLI::App& program);
void add_thin_command(CLI::App& program);
void add_validate_command(CLI::App& program);
void add_view_command(CLI::App& program);
void add_volume_command(CLI::App& program);
void add_voxels_command(CLI::App& program);

//! Thrown by a command that did its work and found a failure to report by exit code 1, its text already printed.
struct CommandFailed {};

}  // namespace stratareeb
