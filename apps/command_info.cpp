// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/command.h"
#include "boreholes/errors.h"

namespace stratareeb {

void add_info_command(CLI::App& program) {
    program.add_subcommand("info", "")->callback([] { throw InvalidInput("info"); });
}

}  // namespace stratareeb
