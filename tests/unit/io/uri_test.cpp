// SPDX-License-Identifier: MIT
#include "io/uri.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace patina::io {
namespace {

std::string text_of(const Result<DataUri>& data) {
    if (!data) return "failure: " + data.error().message;
    return std::string(reinterpret_cast<const char*>(data->bytes.data()), data->bytes.size());
}

TEST(DataUri, IsDecodedWithAndWithoutBase64) {
    EXPECT_EQ(text_of(decode_data_uri("data:text/plain;base64,UGF0aW5h")), "Patina");
    EXPECT_EQ(text_of(decode_data_uri("data:;base64,UGF0aW4=")), "Patin");
    EXPECT_EQ(text_of(decode_data_uri("data:;base64,UGF0aW4")), "Patin");
    EXPECT_EQ(text_of(decode_data_uri("data:;base64,UGF0aW4%3D")), "Patin");
    EXPECT_EQ(text_of(decode_data_uri("data:,a%20b")), "a b");
    EXPECT_EQ(decode_data_uri("data:image/png;charset=x;base64,AAAA")->mime_type, "image/png");
}

TEST(DataUri, ThatIsBrokenIsRefused) {
    for (const char* uri : {"data:", "data:;base64", "data:;base64,A", "data:;base64,AA!A"})
        EXPECT_FALSE(decode_data_uri(uri).has_value()) << uri;
}

TEST(Uri, IsPercentDecodedOnce) {
    EXPECT_EQ(relative_path_of_uri("my%20texture.png"), "my texture.png");
    EXPECT_EQ(relative_path_of_uri("a%2520b.png"), "a%20b.png");
    EXPECT_EQ(relative_path_of_uri("100%.png"), "100%.png");
    EXPECT_EQ(relative_path_of_uri("textures/./wood.png"), "textures/./wood.png");
    EXPECT_EQ(relative_path_of_uri("a..b/..c.png"), "a..b/..c.png");
}

TEST(Uri, ThatLeadsElsewhereIsRefused) {
    for (const std::string& uri :
         {std::string(""), std::string("/etc/passwd"), std::string("../a.png"),
          std::string("a/../../b.png"), std::string("%2e%2e/a.png"), std::string("a/%2E%2E/b"),
          std::string("..%2fa.png"), std::string("%2fetc%2fpasswd"), std::string("..\\a.png"),
          std::string("a%5cb.png"), std::string("a%00.png"), std::string("a\0b", 3),
          std::string("a%0a.png"), std::string("http://example.org/a.png"),
          std::string("HTTPS://example.org/a.png"), std::string("file:///etc/passwd"),
          std::string("file:a.png"), std::string("C:/a.png"), std::string("ftp://a/b")}) {
        const auto path = relative_path_of_uri(uri);
        EXPECT_FALSE(path.has_value()) << uri;
        if (path) continue;
        EXPECT_EQ(path.error().message.find('\n'), std::string::npos);
    }
}

TEST(FileUnder, FollowsLinksOnlyInsideTheFolder) {
    const TemporaryFolder outside;
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "textures");
    ASSERT_TRUE(write_file_atomically(folder.path() / "textures" / "a.png", "a"));
    ASSERT_TRUE(write_file_atomically(outside.path() / "secret", "s"));
    std::filesystem::create_symlink("textures/a.png", folder.path() / "inside.png");
    std::filesystem::create_symlink(outside.path() / "secret", folder.path() / "link.png");
    std::filesystem::create_directory_symlink(outside.path(), folder.path() / "linked");

    EXPECT_TRUE(file_under(folder.path(), "textures/a.png")->has_value());
    EXPECT_TRUE(file_under(folder.path(), "inside.png")->has_value());
    EXPECT_FALSE(file_under(folder.path(), "missing.png")->has_value());
    EXPECT_FALSE(file_under(folder.path(), "link.png").has_value());
    EXPECT_FALSE(file_under(folder.path(), "linked/secret").has_value());
    EXPECT_FALSE(file_under(folder.path(), "textures").has_value());
    EXPECT_FALSE(file_under(folder.path(), ".").has_value());
}

}  // namespace
}  // namespace patina::io
