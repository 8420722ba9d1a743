// SPDX-License-Identifier: MIT

/// The composite of stack-10 against the yardsticks `touch` and `naive`. Each name runs by itself;
/// `composite/ratios` interleaves them, takes the least of several runs of each and prints the
/// ratios that are promised. One thread each; CPU time.

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <limits>
#include <string>

#include "composite/composite.h"
#include "core/parallel.h"
#include "document/choices.h"
#include "stack10.h"

namespace patina::bench {
namespace {

constexpr int kRuns = 9;
constexpr int kNaiveRuns = 3;

const std::vector<BakedMap> kMaps = {BakedMap::BaseColor, BakedMap::OcclusionRoughnessMetalness};

StackOutput output_for(const Stack10& stack) {
    return {.base_color = std::vector<std::uint8_t>(stack.texels() * 3),
            .packed = std::vector<std::uint8_t>(stack.texels() * 3)};
}

MapSet composite(BlendSpace space, int size) {
    const Program program = Program::compile(stack10_material(space));
    return bake_maps(program, stack10_images(), size, kMaps).value();
}

/// The material with the opacity of one layer changed, as a slider's drag does.
Program edited_program(int layer, int step) {
    Material material = stack10_material(BlendSpace::SrgbEncoded);
    Layer copy = *material.stack[static_cast<std::size_t>(layer)];
    copy.opacity = 0.5f + 0.001f * static_cast<float>(step % 100);
    material.stack[static_cast<std::size_t>(layer)] =
        std::make_shared<const Layer>(std::move(copy));
    return Program::compile(material);
}

/// An editor in the middle of dragging the opacity of one layer of ten.
class Drag {
  public:
    Drag(int layer, int size, TexelRect within) : layer_(layer), size_(size), within_(within) {
        for (int i = 0; i < 3; ++i)
            (void)live_.update(edited_program(layer_, step_++), stack10_images(), size_);
    }
    void move() {
        (void)live_.update_within(within_, edited_program(layer_, step_++), stack10_images(),
                                  size_);
    }

  private:
    LiveComposite live_;
    int layer_;
    int size_;
    TexelRect within_;
    int step_ = 0;
};

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// One side of a ratio: how often it has run and the least CPU time that it took.
struct Contestant {
    std::string name;
    std::function<void()> run;
    int runs = kRuns;
    double least_seconds = std::numeric_limits<double>::infinity();
};

void run_interleaved(std::vector<Contestant>& contestants) {
    for (int round = 0; round < kRuns; ++round)
        for (Contestant& contestant : contestants) {
            if (round >= contestant.runs) continue;
            const double start = cpu_seconds();
            contestant.run();
            contestant.least_seconds = std::min(contestant.least_seconds, cpu_seconds() - start);
        }
}

double seconds_of(const std::vector<Contestant>& contestants, const std::string& name) {
    for (const Contestant& contestant : contestants)
        if (contestant.name == name) return contestant.least_seconds;
    return std::numeric_limits<double>::quiet_NaN();
}

void print_ratio(const std::vector<Contestant>& contestants, const std::string& numerator,
                 const std::string& denominator, const char* target) {
    std::printf("%-34s %8.2f ms / %-26s %8.2f ms = %6.3f   target %s\n", numerator.c_str(),
                seconds_of(contestants, numerator) * 1e3, denominator.c_str(),
                seconds_of(contestants, denominator) * 1e3,
                seconds_of(contestants, numerator) / seconds_of(contestants, denominator), target);
}

/// The greatest difference from the double-precision reference, in steps of 1/255.
int greatest_error(const Stack10& stack, int stride) {
    StackOutput reference = output_for(stack);
    composite_reference(stack, stride, reference);
    const MapSet maps = composite(BlendSpace::SrgbEncoded, stack.size);
    const auto* const color =
        reinterpret_cast<const std::uint8_t*>(maps[BakedMap::BaseColor]->data.data());
    const auto* const packed = reinterpret_cast<const std::uint8_t*>(
        maps[BakedMap::OcclusionRoughnessMetalness]->data.data());
    int worst = 0;
    const auto size = static_cast<std::size_t>(stack.size);
    for (std::size_t i = 0; i < stack.texels(); ++i) {
        if ((i / size) % static_cast<std::size_t>(stride) != 0) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            worst = std::max(worst, std::abs(color[4 * i + c] - reference.base_color[3 * i + c]));
            worst = std::max(worst, std::abs(packed[4 * i + c] - reference.packed[3 * i + c]));
        }
    }
    return worst;
}

void set_channel(Layer& layer, Channel channel, Source source) {
    at(layer.channels, channel) = {.enabled = true, .source = std::move(source)};
}

std::string named(const char* name, int size) {
    return name + std::to_string(size);
}

/// The narrower instruction sets that this machine has too, and how many times `touch` the
/// composite may take there.
struct NarrowerTarget {
    const char* name;
    std::int64_t target;
    const char* at_most;
};
constexpr NarrowerTarget kNarrowerTargets[] = {{"composite/stack10/2048/AVX2", HWY_AVX2, "3"},
                                               {"composite/stack10/2048/SSE4", HWY_SSE4, "6"}};

bool is_there(const NarrowerTarget& narrower) {
    return (hwy::SupportedTargets() & narrower.target) != 0;
}

void add_narrower_targets(std::vector<Contestant>& contestants, int size) {
    for (const NarrowerTarget& narrower : kNarrowerTargets)
        if (is_there(narrower))
            contestants.push_back({narrower.name, [=] {
                                       hwy::SetSupportedTargetsForTest(narrower.target);
                                       composite(BlendSpace::SrgbEncoded, size);
                                       hwy::SetSupportedTargetsForTest(0);
                                   }});
}

/// The composite of one size against its yardsticks; at 2048 also what an edit costs.
void composite_ratios(benchmark::State& state, int size) {
    const ThreadLimit one_thread(1);
    const Stack10& stack = stack10(size);
    const int worst = greatest_error(stack, size / 256);
    if (worst > 1) {
        state.SkipWithError("the composite differs from the reference by more than 1/255");
        return;
    }
    StackOutput out = output_for(stack);
    std::vector<Contestant> contestants = {
        {named("touch/stack10/", size), [&] { touch(stack, out); }},
        {named("composite/stack10/", size), [&] { composite(BlendSpace::SrgbEncoded, size); }},
        {named("naive/stack10/", size), [&] { composite_naively(stack, out); }, kNaiveRuns}};
    const bool with_edits = size == 2048;
    if (with_edits) {
        const TexelRect whole{0, 0, size, size};
        const auto drag = [&](const char* name, int layer, int side, TexelRect within) {
            auto session = std::make_shared<Drag>(layer, side, within);
            contestants.push_back({name, [session] { session->move(); }});
        };
        contestants.push_back(
            {"composite-linear/stack10/2048", [&] { composite(BlendSpace::Linear, size); }});
        drag("edit/layer5of10/2048", 5, size, whole);
        drag("edit/layer9of10/2048", 9, size, whole);
        drag("edit/tile256/2048", 5, size, {512, 768, 768, 1024});
        drag("preview/1024of2048", 5, 1024, {0, 0, 1024, 1024});
        add_narrower_targets(contestants, size);
    }
    for (auto _ : state) run_interleaved(contestants);

    const std::string composite_name = named("composite/stack10/", size);
    std::printf(
        "stack10 at %d, one thread, least CPU time of %d; at most %d/255 from the "
        "reference\n",
        size, kRuns, worst);
    print_ratio(contestants, composite_name, named("touch/stack10/", size), "2");
    print_ratio(contestants, named("naive/stack10/", size), composite_name, "at least 15");
    if (!with_edits) return;
    for (const NarrowerTarget& narrower : kNarrowerTargets)
        if (is_there(narrower))
            print_ratio(contestants, narrower.name, named("touch/stack10/", size),
                        narrower.at_most);
    print_ratio(contestants, "composite-linear/stack10/2048", composite_name, "1.5");
    print_ratio(contestants, "edit/layer5of10/2048", composite_name, "0.7");
    print_ratio(contestants, "edit/layer9of10/2048", composite_name, "0.35");
    print_ratio(contestants, "edit/tile256/2048", composite_name, "0.05");
    print_ratio(contestants, "preview/1024of2048", composite_name, "0.3");
}

void per_texel(benchmark::State& state, std::size_t texels) {
    state.counters["per_texel"] = benchmark::Counter(
        static_cast<double>(texels),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void register_stack10(int size) {
    const auto add = [&](const std::string& name, std::function<void(StackOutput&)> work) {
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
            const ThreadLimit one_thread(1);
            StackOutput out = output_for(stack10(size));
            for (auto _ : state) work(out);
            per_texel(state, stack10(size).texels());
        })->Unit(benchmark::kMillisecond);
    };
    add(named("touch/stack10/", size), [=](StackOutput& out) { touch(stack10(size), out); });
    add(named("naive/stack10/", size),
        [=](StackOutput& out) { composite_naively(stack10(size), out); });
    add(named("composite/stack10/", size),
        [=](StackOutput&) { composite(BlendSpace::SrgbEncoded, size); });
    benchmark::RegisterBenchmark(named("composite/ratios/", size).c_str(),
                                 [=](benchmark::State& state) { composite_ratios(state, size); })
        ->Iterations(1);
}

/// One procedural with its standard numbers as a map: of a million texels, so that a millisecond is
/// a nanosecond a texel. 30 are the most that any may take with AVX2.
void procedural(benchmark::State& state, ProceduralKind kind) {
    const ThreadLimit one_thread(1);
    Material material;
    Layer layer{.id = {1}, .name = "Noise"};
    set_channel(layer, Channel::Roughness, ProceduralSource{.kind = kind});
    material.stack = {std::make_shared<const Layer>(std::move(layer))};
    const Program program = Program::compile(material);
    constexpr int kSize = 1000;
    hwy::SetSupportedTargetsForTest(HWY_AVX2);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            bake_maps(program, stack10_images(), kSize, {BakedMap::OcclusionRoughnessMetalness}));
    hwy::SetSupportedTargetsForTest(0);
    per_texel(state, std::size_t{kSize} * kSize);
}

/// The greatest memory of the process since it was last asked to start anew.
double peak_mib() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (double kib = 0; word == "VmHWM:" && status >> kib) return kib / 1024.0;
    return 0.0;
}

/// A layer whose mask is what the heights below are like, as far as sources reach.
LayerPtr relief_layer(std::uint64_t id, ReliefKind kind, float radius_permille) {
    Layer layer{.id = {id}, .name = "Relief"};
    layer.mask.entries = {
        {.id = {id + 100},
         .source = ReliefSource{.kind = kind, .radius_permille = radius_permille}}};
    set_channel(layer, Channel::BaseColor, ConstantSource{glm::vec3(0.3f)});
    set_channel(layer, Channel::Height, ConstantSource{glm::vec3(0.1f)});
    return std::make_shared<const Layer>(std::move(layer));
}

/// What a bake takes beside the maps that it makes, where layers go by the relief below them.
void peak_memory(benchmark::State& state, int size) {
    Layer bumps{.id = {1}, .name = "Bumps"};
    set_channel(bumps, Channel::Height, ProceduralSource{});
    Material material;
    material.height_scale = 0.01f;
    material.stack = {std::make_shared<const Layer>(std::move(bumps)),
                      relief_layer(2, ReliefKind::Cavity, 50.0f),
                      relief_layer(3, ReliefKind::Edge, 5.0f)};
    const Program program = Program::compile(material);
    const std::vector<BakedMap> maps = maps_of(program);
    const double maps_mib = static_cast<double>(maps.size()) * size * size * 4.0 / 1048576.0;
    double most = 0.0;
    for (auto _ : state) {
        std::ofstream("/proc/self/clear_refs") << "5";
        const double before = peak_mib();
        benchmark::DoNotOptimize(bake_maps(program, stack10_images(), size, maps));
        most = std::max(most, peak_mib() - before - maps_mib);
    }
    std::printf("bake-relief/%d takes %.1f MiB beside its maps, target at most 64\n", size, most);
}

const bool kRegistered = [] {
    for (const int size : {1024, 2048, 4096}) register_stack10(size);
    benchmark::RegisterBenchmark("composite-linear/stack10/2048", [](benchmark::State& state) {
        const ThreadLimit one_thread(1);
        stack10(2048);
        for (auto _ : state) composite(BlendSpace::Linear, 2048);
    })->Unit(benchmark::kMillisecond);
    const auto add_drag = [](const char* name, int layer, int size, TexelRect within) {
        benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
            const ThreadLimit one_thread(1);
            stack10(2048);
            Drag drag(layer, size, within);
            for (auto _ : state) drag.move();
        })->Unit(benchmark::kMillisecond);
    };
    add_drag("edit/layer5of10/2048", 5, 2048, {0, 0, 2048, 2048});
    add_drag("edit/layer9of10/2048", 9, 2048, {0, 0, 2048, 2048});
    add_drag("edit/tile256/2048", 5, 2048, {512, 768, 768, 1024});
    add_drag("preview/1024of2048", 5, 1024, {0, 0, 1024, 1024});
    benchmark::RegisterBenchmark("bake-relief/4096", [](benchmark::State& state) {
        peak_memory(state, 4096);
    })->Unit(benchmark::kMillisecond);
    if ((hwy::SupportedTargets() & HWY_AVX2) != 0)
        for (std::size_t kind = 0; kind < kProceduralKinds.size(); ++kind)
            benchmark::RegisterBenchmark(
                ("procedural/" + std::string(kProceduralKinds[kind].id) + "/AVX2").c_str(),
                [kind](benchmark::State& state) {
                    procedural(state, static_cast<ProceduralKind>(kind));
                })
                ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace patina::bench
