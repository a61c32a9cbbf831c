// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/command.h"
#include "boreholes/errors.h"

namespace stratareeb {

void add_build_command(CLI::App& program) {
    program.add_subcommand("build", "")->callback([] { throw InvalidInput("build"); });
}

}  // namespace stratareeb
