// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/staged_folder.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "boreholes/errors.h"

namespace stratareeb {

namespace fs = std::filesystem;

namespace {

//! A name from an earlier run's list may only point into the folder.
bool stays_inside(const fs::path& relative) {
    return relative.is_relative() && !relative.empty() &&
           std::ranges::none_of(relative, [](const fs::path& part) { return part == ".."; });
}

//! Folders that hold nothing more go too.
void remove_with_empty_folders(const fs::path& target, const fs::path& name) {
    std::error_code error;
    fs::remove(target / name, error);
    for (fs::path folder = name.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        if (!fs::is_directory(target / folder, error) || !fs::is_empty(target / folder, error)) return;
        fs::remove(target / folder, error);
    }
}

}  // namespace

StagedFolder::StagedFolder(fs::path target, bool overwrite) : target_(std::move(target)) {
    if (!target_.has_filename()) target_ = target_.parent_path();  // "out/"
    if (target_.empty()) throw IoError("the output folder has no name");
    if (fs::exists(target_) && !fs::is_directory(target_))
        throw IoError(target_.string() + ": is a file, not a folder");
    if (fs::exists(target_) && !fs::is_empty(target_) && !overwrite)
        throw IoError(target_.string() + ": is there already; give another name or --overwrite");
    const fs::path absolute = fs::absolute(target_).lexically_normal();
    staging_ = absolute.parent_path() /
               ("." + absolute.filename().string() + "." + std::to_string(::getpid()) + ".part");
    std::error_code error;
    fs::remove_all(staging_, error);
    fs::create_directories(staging_, error);
    if (error) throw IoError(target_.string() + ": can't be made: " + error.message());
}

StagedFolder::~StagedFolder() {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
}

fs::path StagedFolder::add(const std::string& relative) {
    fs::path file = staging_ / relative;
    fs::create_directories(file.parent_path());
    files_.push_back(relative);
    return file;
}

void StagedFolder::commit(const std::vector<std::string>& stale) {
    std::error_code error;
    if (!fs::exists(target_) || (fs::is_directory(target_) && fs::is_empty(target_))) {
        fs::remove(target_, error);
        fs::rename(staging_, target_, error);
        if (error) throw IoError(target_.string() + ": can't be made: " + error.message());
        return;
    }
    for (const std::string& name : stale)
        if (stays_inside(name)) remove_with_empty_folders(target_, name);
    for (const std::string& name : files_) {
        fs::create_directories((target_ / name).parent_path());
        fs::rename(staging_ / name, target_ / name, error);
        if (error) throw IoError((target_ / name).string() + ": can't be replaced: " + error.message());
    }
}

std::vector<std::string> listed_files(const fs::path& list) {
    std::vector<std::string> files;
    std::ifstream stream(list);
    if (!stream) return files;
    if (list.extension() != ".json") {
        for (std::string line; std::getline(stream, line);)
            if (!line.empty()) files.push_back(line);
        return files;
    }
    const auto json = nlohmann::json::parse(stream, nullptr, false);
    if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) return files;
    for (const auto& name : json["files"])
        if (name.is_string()) files.push_back(name.get<std::string>());
    return files;
}

}  // namespace stratareeb
