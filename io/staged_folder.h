// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stratareeb {

//! A folder written aside: files go into a temporary folder beside the target and take their places there
//! only when all of them are whole. If it is never committed, the target stays as it was.
class StagedFolder {
 public:
    //! \throw IoError if the target is a file, or holds anything already and `overwrite` is false.
    StagedFolder(std::filesystem::path target, bool overwrite);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    //! Where to write a file of this name ("layers/01_clay.ply"); makes its folder and puts it on the list.
    std::filesystem::path add(const std::string& relative);
    const std::vector<std::string>& files() const { return files_; }

    //! Move everything into place. Files that an earlier run left (`stale`, relative) go first; anything else
    //! of the user's in the target stays.
    void commit(const std::vector<std::string>& stale);

 private:
    std::filesystem::path target_, staging_;
    std::vector<std::string> files_;
};

//! The files that an earlier run listed: in `files` of a JSON object (`list` ends in .json), or one a line. Empty if there is no such
//! list or it can't be read.
std::vector<std::string> listed_files(const std::filesystem::path& list);

}  // namespace stratareeb
