// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/staged_folder.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

std::string refusal(const fs::path& target, bool overwrite) {
    try {
        StagedFolder folder(target, overwrite);
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

TEST(StagedFolder, shows_nothing_before_commit_and_everything_after) {
    const TemporaryFolder home;
    {
        StagedFolder folder(home / "out", false);
        write(folder.add("model.json"), "model");
        write(folder.add("layers/01_clay.ply"), "clay");
        EXPECT_FALSE(fs::exists(home / "out"));
        EXPECT_EQ(folder.files(), (std::vector<std::string>{"model.json", "layers/01_clay.ply"}));
        folder.commit({});
    }
    EXPECT_EQ(content_of(home / "out/model.json"), "model");
    EXPECT_EQ(content_of(home / "out/layers/01_clay.ply"), "clay");
    EXPECT_EQ(home.size(), 1u) << "the temporary folder stays behind";
}

TEST(StagedFolder, makes_the_folders_above_the_target) {
    const TemporaryFolder home;
    StagedFolder folder(home / "a/b/out", false);
    write(folder.add("x"), "x");
    folder.commit({});
    EXPECT_EQ(content_of(home / "a/b/out/x"), "x");
}

TEST(StagedFolder, takes_an_empty_folder_and_a_trailing_slash) {
    const TemporaryFolder home;
    fs::create_directories(home / "out");
    StagedFolder folder((home / "out").string() + "/", false);
    write(folder.add("x"), "x");
    folder.commit({});
    EXPECT_EQ(content_of(home / "out/x"), "x");
}

TEST(StagedFolder, abandoned_leaves_the_target_untouched) {
    const TemporaryFolder home;
    fs::create_directories(home / "out/layers");
    write(home / "out/layers/01.ply", "old");
    {
        StagedFolder folder(home / "out", true);
        write(folder.add("layers/01.ply"), "new");
        write(folder.add("layers/02.ply"), "new");
    }
    EXPECT_EQ(content_of(home / "out/layers/01.ply"), "old");
    EXPECT_FALSE(fs::exists(home / "out/layers/02.ply"));
    EXPECT_EQ(home.size(), 1u);
    { StagedFolder folder(home / "new", false); }
    EXPECT_FALSE(fs::exists(home / "new"));
    EXPECT_EQ(home.size(), 1u);
}

TEST(StagedFolder, overwrites_its_files_removes_stale_ones_and_keeps_the_users_own) {
    const TemporaryFolder home;
    fs::create_directories(home / "out/layers");
    write(home / "out/layers/01_clay.ply", "old");
    write(home / "out/layers/02_gone.ply", "old");
    write(home / "out/notes.txt", "mine");
    StagedFolder folder(home / "out", true);
    write(folder.add("layers/01_clay.ply"), "new");
    folder.commit({"layers/01_clay.ply", "layers/02_gone.ply", "layers/03_never_there.ply"});
    EXPECT_EQ(content_of(home / "out/layers/01_clay.ply"), "new");
    EXPECT_FALSE(fs::exists(home / "out/layers/02_gone.ply"));
    EXPECT_EQ(content_of(home / "out/notes.txt"), "mine");
}

TEST(StagedFolder, removes_nothing_outside_the_target_whatever_a_list_says) {
    const TemporaryFolder home;
    fs::create_directories(home / "out");
    write(home / "precious.txt", "mine");
    write(home / "out/x", "old");
    {
        StagedFolder folder(home / "out", true);
        write(folder.add("x"), "new");
        folder.commit(
            {"../precious.txt", (home / "precious.txt").string(), "layers/../../precious.txt", "", ".."});
    }
    EXPECT_EQ(content_of(home / "precious.txt"), "mine");
    EXPECT_EQ(content_of(home / "out/x"), "new");
}

TEST(StagedFolder, refuses_what_is_there_unless_told) {
    const TemporaryFolder home;
    fs::create_directories(home / "out");
    write(home / "out/x", "old");
    EXPECT_NE(refusal(home / "out", false).find("is there already; give another name or --overwrite"),
              std::string::npos);
    EXPECT_EQ(refusal(home / "out", true), "");
    EXPECT_EQ(content_of(home / "out/x"), "old");
}

TEST(StagedFolder, refuses_a_file_and_a_name_of_nothing) {
    const TemporaryFolder home;
    write(home / "file", "old");
    EXPECT_NE(refusal(home / "file", false).find("is a file, not a folder"), std::string::npos);
    EXPECT_NE(refusal(home / "file", true).find("is a file, not a folder"), std::string::npos);
    EXPECT_NE(refusal("", true).find("has no name"), std::string::npos);
    EXPECT_NE(refusal(home / "file/out", true).find("can't be made"), std::string::npos);
    EXPECT_EQ(content_of(home / "file"), "old");
}

}  // namespace
}  // namespace stratareeb
