// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_aside.h"

#include <gtest/gtest.h>

#include <ostream>

#include "boreholes/errors.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

TEST(WriteAside, leaves_the_content_and_nothing_else) {
    const TemporaryFolder folder;
    write_aside(folder / "a.txt", [](std::ostream& out) { out << "one"; });
    write_aside(folder / "a.txt", [](std::ostream& out) { out << "two"; });
    EXPECT_EQ(content_of(folder / "a.txt"), "two");
    EXPECT_EQ(folder.size(), 1u);
}

TEST(WriteAside, keeps_the_old_file_if_writing_fails) {
    const TemporaryFolder folder;
    const auto file = folder.file("a.txt", "old");
    EXPECT_THROW(write_aside(file,
                             [&](std::ostream& out) {
                                 out << "half";
                                 EXPECT_EQ(content_of(file), "old");
                                 throw InvalidInput("stop");
                             }),
                 InvalidInput);
    EXPECT_THROW(write_aside(file, [](std::ostream& out) { out.setstate(std::ios::badbit); }), IoError);
    EXPECT_EQ(content_of(file), "old");
    EXPECT_EQ(folder.size(), 1u);
}

TEST(WriteAside, names_file_and_folder_that_are_in_the_way) {
    const TemporaryFolder folder;
    const auto never = [](std::ostream&) { FAIL(); };
    try {
        write_aside(folder / "missing/a.txt", never);
        FAIL();
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("missing does not exist"), std::string::npos)
            << error.what();
    }
    EXPECT_THROW(write_aside(folder.path(), never), IoError);
}

TEST(WriteAside, reports_a_full_disk) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    EXPECT_THROW(write_aside("/dev/full", [](std::ostream& out) { out << "text"; }), IoError);
    EXPECT_TRUE(fs::is_character_file("/dev/full"));  // a device is not replaced
}

TEST(WriteAside, follows_a_link) {
    const TemporaryFolder folder;
    const auto file = folder.file("real.txt", "old");
    fs::create_symlink("real.txt", folder / "link.txt");
    write_aside(folder / "link.txt", [](std::ostream& out) { out << "new"; });
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
    EXPECT_EQ(content_of(file), "new");
}

TEST(WriteAside, hands_libraries_a_name_with_the_same_extension) {
    const TemporaryFolder folder;
    replace_aside(folder / "a.step", [&](const fs::path& temporary) {
        EXPECT_EQ(temporary.extension(), ".step");
        EXPECT_EQ(temporary.parent_path(), folder.path());
        std::ofstream(temporary) << "solid";
    });
    EXPECT_EQ(content_of(folder / "a.step"), "solid");
    EXPECT_THROW(replace_aside(folder / "b.step", [](const fs::path&) {}), IoError);  // nothing was written
    EXPECT_EQ(folder.size(), 1u);
}

TEST(WriteAside, takes_names_without_folder_and_long_ones) {
    const TemporaryFolder folder;
    const auto name = std::string(240, 'x') + ".txt";
    write_aside(folder / name, [](std::ostream& out) { out << "text"; });
    EXPECT_EQ(content_of(folder / name), "text");
}

}  // namespace
}  // namespace stratareeb
