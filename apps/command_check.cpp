// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/command.h"
#include "boreholes/errors.h"

namespace stratareeb {

void add_check_command(CLI::App& program) {
    program.add_subcommand("check", "")->callback([] { throw InvalidInput("check"); });
}

}  // namespace stratareeb
