// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/command.h"
#include "boreholes/errors.h"

namespace stratareeb {

void add_convert_command(CLI::App& program) {
    program.add_subcommand("convert", "")->callback([] { throw InvalidInput("convert"); });
}

}  // namespace stratareeb
