// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/command.h"
#include "boreholes/errors.h"

namespace stratareeb {

void add_sample_command(CLI::App& program) {
    program.add_subcommand("sample", "")->callback([] { throw InvalidInput("sample"); });
}

}  // namespace stratareeb
