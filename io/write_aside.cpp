// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_aside.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

std::string reason() {
    return errno != 0 ? std::generic_category().message(errno) : "unknown reason";
}

// Where the bytes finally go: a link is followed, so that it stays a link.
fs::path real_target(const fs::path& target) {
    std::error_code error;
    if (!fs::is_symlink(target, error)) return target;
    const auto followed = fs::weakly_canonical(target, error);
    return error ? target : followed;
}

bool is_device(const fs::path& path) {
    std::error_code error;
    const auto status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

fs::path temporary_beside(const fs::path& target) {
    static std::atomic<unsigned> count = 0;
    return target.parent_path() / fmt::format(".{}-{}.{}{}", target.stem().string().substr(0, 100),
                                              ::getpid(), ++count, target.extension().string());
}

void require_folder(const fs::path& target) {
    const auto folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw IoError(
            fmt::format("{}: the folder {} does not exist; make it first", target.string(), folder.string()));
    if (fs::is_directory(target, error))
        throw IoError(fmt::format("{}: is a folder; give the name of a file", target.string()));
}

void flush_to_disk(const fs::path& file, const fs::path& target) {
    errno = 0;
    const int descriptor = ::open(file.c_str(), O_RDONLY);
    const bool done = descriptor >= 0 && ::fsync(descriptor) == 0;
    const auto why = reason();
    if (descriptor >= 0) ::close(descriptor);
    if (!done) throw IoError(fmt::format("{}: can't be written: {}", target.string(), why));
}

void write_stream(const fs::path& file, const fs::path& target,
                  const std::function<void(std::ostream&)>& write) {
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    if (!stream) throw IoError(fmt::format("{}: can't be written: {}", target.string(), reason()));
    errno = 0;
    write(stream);
    stream.close();
    if (!stream) throw IoError(fmt::format("{}: can't be written in full: {}", target.string(), reason()));
}

// Removes the temporary file unless it was moved to its place.
struct Remover {
    fs::path file;
    ~Remover() {
        std::error_code ignored;
        if (!file.empty()) fs::remove(file, ignored);
    }
};

}  // namespace

void replace_aside(const fs::path& target, const std::function<void(const fs::path&)>& write) {
    const auto destination = real_target(target);
    require_folder(destination);
    Remover remover{temporary_beside(destination)};
    write(remover.file);
    flush_to_disk(remover.file, target);
    std::error_code error;
    fs::rename(remover.file, destination, error);
    if (error) throw IoError(fmt::format("{}: can't be replaced: {}", target.string(), error.message()));
    remover.file.clear();
}

void write_aside(const fs::path& target, const std::function<void(std::ostream&)>& write) {
    if (is_device(target)) return write_stream(target, target, write);
    replace_aside(target, [&](const fs::path& temporary) { write_stream(temporary, target, write); });
}

}  // namespace stratareeb
