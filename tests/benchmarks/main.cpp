// SPDX-License-Identifier: MIT
// patina_bench [Google Benchmark's flags]: runs every benchmark seven times, interleaved, and
// prints the least time of each and the ratios of ratios.h between those that ran.
// patina_bench --write-stack10 FOLDER SIZE: writes the work item as files instead.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ratios.h"
#include "write_stack10.h"

namespace patina::bench {
namespace {

/// The name as it was registered: without what the library appends, such as "/real_time".
std::string plain_name(std::string name) {
    for (const std::string_view suffix :
         {"/repeats:", "/iterations:", "/min_time:", "/real_time", "/process_time", "/manual_time"})
        if (const std::size_t at = name.find(suffix); at != std::string::npos) name.resize(at);
    return name;
}

/// Keeps the least time of each benchmark; noise only ever adds.
class LeastTimes : public benchmark::BenchmarkReporter {
  public:
    bool ReportContext(const Context& context) override {
        PrintBasicContext(&GetErrorStream(), context);
        return true;
    }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            const std::string name = plain_name(run.benchmark_name());
            if (run.error_occurred) fmt::print("{}: {}\n", name, run.error_message);
            if (run.error_occurred || run.run_type != Run::RT_Iteration) continue;
            const double to_ms = 1e3 / benchmark::GetTimeUnitMultiplier(run.time_unit);
            auto [entry, fresh] = least_.try_emplace(name);
            if (fresh) order_.push_back(name);
            Least& least = entry->second;
            const double cpu = run.GetAdjustedCPUTime() * to_ms;
            const double wall = run.GetAdjustedRealTime() * to_ms;
            least.cpu_ms = fresh ? cpu : std::min(least.cpu_ms, cpu);
            least.wall_ms = fresh ? wall : std::min(least.wall_ms, wall);
            ++least.runs;
        }
    }

    void Finalize() override {
        fmt::print("{:<44} {:>12} {:>12} {:>5}\n", "least of the runs", "CPU ms", "wall ms",
                   "runs");
        for (const std::string& name : order_) {
            const Least& least = least_.at(name);
            fmt::print("{:<44} {:>12.4f} {:>12.4f} {:>5}\n", name, least.cpu_ms, least.wall_ms,
                       least.runs);
        }
        fmt::print("\n");
        for (const Ratio& ratio : kRatios) print(ratio);
    }

  private:
    struct Least {
        double cpu_ms = 0.0;
        double wall_ms = 0.0;
        int runs = 0;
    };

    void print(const Ratio& ratio) const {
        const auto over = least_.find(std::string(ratio.numerator));
        const auto under = least_.find(std::string(ratio.denominator));
        if (over == least_.end() || under == least_.end()) return;
        const double value = over->second.wall_ms / under->second.wall_ms;
        const bool met = ratio.at_least ? value >= ratio.target : value <= ratio.target;
        fmt::print("{} / {} = {:.3f}, target at {} {}{}\n", ratio.numerator, ratio.denominator,
                   value, ratio.at_least ? "least" : "most", ratio.target, met ? "" : ": MISSED");
    }

    std::map<std::string, Least> least_;
    std::vector<std::string> order_;
};

/// What is passed beside what the caller types, which comes later and so wins.
std::vector<std::string> arguments_with_defaults(int argc, char** argv) {
    std::vector<std::string> arguments = {argv[0], "--benchmark_repetitions=7",
                                          "--benchmark_enable_random_interleaving=true",
                                          "--benchmark_min_time=0.05"};
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    return arguments;
}

int write_files(const char* folder, const char* size) {
    const Status written = write_stack10(folder, std::atoi(size));
    if (!written) fmt::print(stderr, "{}\n", written.error().message);
    return written ? 0 : 1;
}

int run(int argc, char** argv) {
    if (argc == 4 && std::string_view(argv[1]) == "--write-stack10")
        return write_files(argv[2], argv[3]);
    std::vector<std::string> arguments = arguments_with_defaults(argc, argv);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    int count = static_cast<int>(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
    LeastTimes reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return 0;
}

}  // namespace
}  // namespace patina::bench

int main(int argc, char** argv) {
    return patina::bench::run(argc, argv);
}
