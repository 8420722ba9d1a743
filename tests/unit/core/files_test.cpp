// SPDX-License-Identifier: MIT
#include "core/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace patina {
namespace {

class Files : public testing::Test {
  protected:
    Files() {
        folder_ = std::filesystem::temp_directory_path() /
                  fmt::format("patina-files-{}-{}", ::getpid(),
                              testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
    }
    ~Files() override { std::filesystem::remove_all(folder_); }

    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

    std::filesystem::path folder_;
};

TEST_F(Files, WhatIsWrittenIsReadBack) {
    const auto path = folder_ / "a.txt";
    ASSERT_TRUE(write_file_atomically(path, "one"));
    ASSERT_TRUE(write_file_atomically(path, "two"));
    EXPECT_EQ(read_text_file(path).value(), "two");
    EXPECT_EQ(entries(), 1u) << "a temporary file was left behind";
}

TEST_F(Files, ASymbolicLinkStaysALinkAndTheModeIsKept) {
    const auto target = folder_ / "target.txt";
    const auto link = folder_ / "link.txt";
    ASSERT_TRUE(write_file_atomically(target, "old"));
    ASSERT_EQ(::chmod(target.c_str(), 0640), 0);
    std::filesystem::create_symlink("target.txt", link);
    ASSERT_TRUE(write_file_atomically(link, "new"));
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(read_text_file(target).value(), "new");
    struct stat info = {};
    ASSERT_EQ(::stat(target.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST_F(Files, AFullDiskLeavesTheOldFileAndNoTemporary) {
    const auto path = folder_ / "a.bin";
    ASSERT_TRUE(write_file_atomically(path, "old"));
    // A size limit on files makes write fail as a full disk does.
    struct rlimit before = {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit small = {.rlim_cur = 1024, .rlim_max = before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = write_file_atomically(path, std::string(4096, 'x'));
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message.find("the old file is unchanged"), std::string::npos);
    EXPECT_EQ(read_text_file(path).value(), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, AFifoAFolderAndAFileOverTheLimitAreRefusedWithoutWaiting) {
    const auto fifo = folder_ / "fifo";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    EXPECT_FALSE(read_file(fifo));
    EXPECT_FALSE(read_file(folder_));
    const auto path = folder_ / "a.txt";
    ASSERT_TRUE(write_file_atomically(path, "12345"));
    EXPECT_FALSE(read_file(path, 4));
    EXPECT_TRUE(read_file(path, 5));
}

TEST(QuotedForMessage, EscapesControlCharactersAndBrokenUtf8AndKeepsTheRest) {
    EXPECT_EQ(quoted_for_message("é\x1b[31m\n\xff"), "é\\x1b[31m\\x0a\\xff");
    EXPECT_EQ(quoted_for_message("\xC2\x9B"), "\\xc2\\x9b");
    EXPECT_EQ(quoted_for_message("abcdef", 3), "abc…");
}

}  // namespace
}  // namespace patina
