// SPDX-License-Identifier: MIT
#include "core/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace patina {
namespace {

std::string shown(const std::filesystem::path& path) {
    return quoted_for_message(path.string());
}

/// An owned POSIX descriptor.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    explicit operator bool() const { return fd_ >= 0; }
    int get() const { return fd_; }
    /// Closes now and says whether the system accepted all that was written.
    bool close() {
        const int fd = std::exchange(fd_, -1);
        return ::close(fd) == 0;
    }

  private:
    int fd_;
};

template <typename Buffer>
Result<Buffer> read_regular_file(const std::filesystem::path& path, std::uint64_t limit_bytes) {
    const Result<OpenedFile> file = OpenedFile::open(path, limit_bytes);
    if (!file) return passed_on(file);
    Buffer buffer;
    buffer.resize(file->size());
    if (const Status read = file->read(0, std::as_writable_bytes(std::span(buffer))); !read)
        return passed_on(read);
    return buffer;
}

bool write_all(int fd, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(fd, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return true;
}

/// The file that a chain of symbolic links ends at; the path itself where it is no link.
std::filesystem::path resolved_target(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_symlink(path, error)) return path;
    const auto target = std::filesystem::weakly_canonical(path, error);
    return error ? path : target;
}

std::filesystem::path temporary_beside(const std::filesystem::path& target) {
    static std::atomic<unsigned> counter = 0;
    // The name stays short, so that a target whose name is near the limit of 255 bytes still works.
    return target.parent_path() / fmt::format(".patina-{}-{}.tmp", ::getpid(), counter++);
}

std::optional<mode_t> existing_mode(const std::filesystem::path& target) {
    struct stat info = {};
    if (::stat(target.c_str(), &info) != 0) return std::nullopt;
    return info.st_mode & 07777;
}

/// Writes and flushes the temporary file; errno tells the reason of a failure.
bool write_temporary(const std::filesystem::path& temporary, std::optional<mode_t> mode,
                     std::span<const std::span<const std::byte>> pieces) {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file) return false;
    if (mode && ::fchmod(file.get(), *mode) != 0) return false;
    for (const auto piece : pieces)
        if (!write_all(file.get(), piece)) return false;
    return ::fsync(file.get()) == 0 && file.close();
}

void flush_folder(const std::filesystem::path& folder) {
    const Descriptor handle(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    // Some file systems cannot flush a folder; the rename has happened all the same.
    if (handle) ::fsync(handle.get());
}

}  // namespace

Result<OpenedFile> OpenedFile::open(const std::filesystem::path& path, std::uint64_t limit_bytes) {
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    OpenedFile file(path, ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.descriptor_ < 0)
        return failure("{}: cannot open: {}", shown(path), std::strerror(errno));
    struct stat info = {};
    if (::fstat(file.descriptor_, &info) != 0)
        return failure("{}: cannot read its size: {}", shown(path), std::strerror(errno));
    if (!S_ISREG(info.st_mode)) return failure("{}: not a regular file", shown(path));
    file.size_ = static_cast<std::uint64_t>(info.st_size);
    if (file.size_ > limit_bytes)
        return failure("{}: {} bytes, more than the limit of {}", shown(path), file.size_,
                       limit_bytes);
    return file;
}

OpenedFile::~OpenedFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

OpenedFile::OpenedFile(OpenedFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

OpenedFile& OpenedFile::operator=(OpenedFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(size_, other.size_);
    return *this;
}

Status OpenedFile::read(std::uint64_t offset, std::span<std::byte> to) const {
    while (!to.empty()) {
        const ssize_t got = ::pread(descriptor_, to.data(), to.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failure("{}: cannot read: {}", shown(path_), std::strerror(errno));
        if (got == 0) return failure("{}: became shorter while it was read", shown(path_));
        offset += static_cast<std::uint64_t>(got);
        to = to.subspan(static_cast<std::size_t>(got));
    }
    return {};
}

Result<Bytes> read_file(const std::filesystem::path& path, std::uint64_t limit_bytes) {
    return read_regular_file<Bytes>(path, limit_bytes);
}

Result<PixelVector<std::byte>> read_large_file(const std::filesystem::path& path,
                                               std::uint64_t limit_bytes) {
    return read_regular_file<PixelVector<std::byte>>(path, limit_bytes);
}

Result<std::string> read_text_file(const std::filesystem::path& path, std::uint64_t limit_bytes) {
    return read_regular_file<std::string>(path, limit_bytes);
}

Status write_file_atomically(const std::filesystem::path& path,
                             std::span<const std::span<const std::byte>> pieces) {
    const auto target = resolved_target(path);
    const auto mode = existing_mode(target);
    std::error_code error;
    if (std::filesystem::is_directory(target, error))
        return failure("{}: cannot write: it is a folder", shown(path));
    const auto temporary = temporary_beside(target);
    if (!write_temporary(temporary, mode, pieces) ||
        ::rename(temporary.c_str(), target.c_str()) != 0) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        return failure("{}: cannot write: {}{}", shown(path), std::strerror(reason),
                       mode ? "; the old file is unchanged" : "");
    }
    flush_folder(target.parent_path());
    return {};
}

Status write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    const std::array pieces = {bytes};
    return write_file_atomically(path, pieces);
}

Status write_file_atomically(const std::filesystem::path& path, std::string_view text) {
    return write_file_atomically(path, bytes_of(text));
}

}  // namespace patina
