// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/temporary_folder.h"

namespace stratareeb {

struct ProgramResult {
    int exit_code = -1;
    std::string out, err;
};

//! Run the program with arguments as a shell reads them, in the folder.
inline ProgramResult run_program(const TemporaryFolder& folder, const std::string& arguments) {
    const TemporaryFolder streams;
    const auto out = streams / "out", err = streams / "err";
    const std::string command = "cd '" + folder.path().string() + "' && '" STRATAREEB_PROGRAM "' " +
                                arguments + " >'" + out.string() + "' 2>'" + err.string() + "' </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

}  // namespace stratareeb
