// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace stratareeb {

//! Write a file so that others see either the old content or all of the new: into a temporary file beside it,
//! on disk before it takes the name. If anything fails, the old file stays and the temporary one is removed.
//! A link keeps pointing where it does; a device or pipe is written directly.
//! \throw IoError if the file
//! can't be written; whatever `write` throws comes through.
void write_aside(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write);

//! The same for a library that opens files itself: `write` gets the temporary name, which has the target's
//! extension, and throws if it fails.
void replace_aside(const std::filesystem::path& target,
                   const std::function<void(const std::filesystem::path& temporary)>& write);

}  // namespace stratareeb
