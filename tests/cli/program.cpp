// SPDX-License-Identifier: MIT
#include "cli/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include "support/triangle_with_cameras.h"

namespace patina::cli_tests {
namespace {

namespace fs = std::filesystem;

/// A file whose name is nobody else's; gone at the end.
class TemporaryFile {
  public:
    TemporaryFile() { ::close(::mkstemp(path_.data())); }
    ~TemporaryFile() { fs::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_ = (fs::temp_directory_path() / "patina-output-XXXXXX").string();
};

int exit_status(pid_t child) {
    int status = 0;
    if (::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

}  // namespace

Outcome run_executable(const std::string& executable, const std::vector<std::string>& arguments) {
    const TemporaryFile out;
    const TemporaryFile errors;
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.path().c_str(), O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.path().c_str(), O_WRONLY, 0);
    std::vector<std::string> words = {executable};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    const int error =
        ::posix_spawnp(&child, executable.c_str(), &actions, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return {.status = -1, .out = {}, .errors = std::strerror(error)};
    const int status = exit_status(child);
    return {.status = status, .out = file_text(out.path()), .errors = file_text(errors.path())};
}

Outcome patina(const std::vector<std::string>& arguments) {
    return run_executable(PATINA_PROGRAM, arguments);
}

std::string file_text(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

nlohmann::json glb_json(const fs::path& path) {
    const std::string glb = file_text(path);
    if (glb.size() < 20) return {};
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, sizeof length);
    return nlohmann::json::parse(glb.substr(20, length), nullptr, false);
}

ProgramTest::ProgramTest() {
    std::string pattern = (fs::temp_directory_path() / "patina-cli-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
}

ProgramTest::~ProgramTest() {
    fs::remove_all(folder_);
}

std::string ProgramTest::sample() const {
    EXPECT_TRUE(succeeded(patina({"sample", "-o", at("sample.glb")})));
    return at("sample.glb");
}

std::string ProgramTest::triangle_with_cameras() const {
    std::ofstream(at("triangle.gltf")) << tests::kTriangleWithCameras;
    return at("triangle.gltf");
}

std::size_t ProgramTest::files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
}

testing::AssertionResult failed_with_one_line(const Outcome& outcome) {
    const auto lines = std::count(outcome.errors.begin(), outcome.errors.end(), '\n');
    if (outcome.status == 1 && outcome.out.empty() && lines == 1 &&
        outcome.errors.starts_with("patina: "))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "status " << outcome.status << ", output: " << outcome.out
                                       << "\nerrors: " << outcome.errors;
}

testing::AssertionResult succeeded(const Outcome& outcome) {
    if (outcome.status == 0) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "status " << outcome.status << ", errors: " << outcome.errors;
}

}  // namespace patina::cli_tests
