// SPDX-License-Identifier: MIT
#pragma once

/// The built program, run as a child process, and a folder to run it in.

#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace patina::cli_tests {

struct Outcome {
    int status = -1;     ///< exit status; -1 when it was ended by a signal
    std::string out;     ///< the standard output
    std::string errors;  ///< the standard error stream
};

/// Runs an executable (found along PATH) with its arguments and waits for it to end.
Outcome run_executable(const std::string& executable, const std::vector<std::string>& arguments);

/// Runs the program under test.
Outcome patina(const std::vector<std::string>& arguments);

std::string file_text(const std::filesystem::path& path);

/// The JSON of a .glb.
nlohmann::json glb_json(const std::filesystem::path& path);

/// A folder of its own for each test, gone afterwards.
class ProgramTest : public testing::Test {
  protected:
    ProgramTest();
    ~ProgramTest() override;

    /// A path in the folder.
    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    /// Writes the sample scene into the folder and returns its path.
    std::string sample() const;
    /// Writes the scene of support/triangle_with_cameras.h into the folder and returns its path.
    std::string triangle_with_cameras() const;
    std::size_t files() const;

    std::filesystem::path folder_;
};

/// A failure as the program has to report it: status 1, nothing on the standard output and one line
/// on the standard error stream.
testing::AssertionResult failed_with_one_line(const Outcome& outcome);
testing::AssertionResult succeeded(const Outcome& outcome);

}  // namespace patina::cli_tests
