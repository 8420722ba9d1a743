// SPDX-License-Identifier: MIT
#pragma once

/// Reading whole files under a limit, and writing them so that a reader sees the old file or the
/// new one and never a part.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/pixel_memory.h"
#include "core/result.h"

namespace patina {

using Bytes = std::vector<std::byte>;

/// The limit that Patina sets on any single file it reads: 2 GiB.
inline constexpr std::uint64_t kFileLimitBytes = std::uint64_t{2} << 30;

/// A regular file, opened to be read in parts. A directory, FIFO, socket or device, or a file
/// larger than `limit_bytes`, is an error that names the path; so is a part that cannot be read.
class OpenedFile {
  public:
    static Result<OpenedFile> open(const std::filesystem::path& path,
                                   std::uint64_t limit_bytes = kFileLimitBytes);
    ~OpenedFile();
    OpenedFile(OpenedFile&& other) noexcept;
    OpenedFile& operator=(OpenedFile&& other) noexcept;

    std::uint64_t size() const { return size_; }
    /// Fills `to` with what lies at `offset`.
    Status read(std::uint64_t offset, std::span<std::byte> to) const;

  private:
    OpenedFile(std::filesystem::path path, int descriptor)
        : path_(std::move(path)), descriptor_(descriptor) {}

    std::filesystem::path path_;
    int descriptor_;
    std::uint64_t size_ = 0;
};

/// Reads a regular file whole. A directory, FIFO, socket or device, a file larger than
/// `limit_bytes`, or one that becomes shorter while it is read is an error that names the path.
Result<Bytes> read_file(const std::filesystem::path& path,
                        std::uint64_t limit_bytes = kFileLimitBytes);
Result<std::string> read_text_file(const std::filesystem::path& path,
                                   std::uint64_t limit_bytes = kFileLimitBytes);

/// The same into memory for pixels: for files that are as large as what they hold.
Result<PixelVector<std::byte>> read_large_file(const std::filesystem::path& path,
                                               std::uint64_t limit_bytes = kFileLimitBytes);

/// Writes the concatenation of `pieces` to `path` all or nothing: a temporary file in the same
/// folder, written, flushed to disk (fsync), renamed over the target, the folder flushed. A
/// symbolic link is followed and stays a link; the mode of an existing target is kept. On any
/// failure (disk full, no permission) the old file is intact and the temporary is gone.
Status write_file_atomically(const std::filesystem::path& path,
                             std::span<const std::span<const std::byte>> pieces);
Status write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
Status write_file_atomically(const std::filesystem::path& path, std::string_view text);

inline std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace patina
