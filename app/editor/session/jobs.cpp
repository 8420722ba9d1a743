// SPDX-License-Identifier: MIT
#include "editor/session/jobs.h"

#include <utility>

namespace patina::editor {

Jobs::~Jobs() {
    for (const auto& job : jobs_) job->progress.cancel();
    for (const auto& job : jobs_) job->thread.join();
}

int Jobs::start(std::string stage, Work work) {
    auto job = std::make_unique<Job>();
    job->id = next_id_++;
    job->stage = std::move(stage);
    job->begun = std::chrono::steady_clock::now();
    Job& running = *job;
    jobs_.push_back(std::move(job));
    running.thread = std::thread([this, &running, work = std::move(work)] {
        running.delivery = work(running.progress);
        running.done.store(true, std::memory_order_release);
        wake_();
    });
    return running.id;
}

void Jobs::cancel(int id) {
    for (const auto& job : jobs_)
        if (job->id == id) job->progress.cancel();
}

void Jobs::deliver() {
    std::vector<std::unique_ptr<Job>> ended;
    std::erase_if(jobs_, [&](std::unique_ptr<Job>& job) {
        if (!job->done.load(std::memory_order_acquire)) return false;
        ended.push_back(std::move(job));
        return true;
    });
    for (const auto& job : ended) {
        job->thread.join();
        if (job->delivery) job->delivery();
    }
}

std::vector<JobShown> Jobs::shown() const {
    std::vector<JobShown> result;
    const auto now = std::chrono::steady_clock::now();
    for (const auto& job : jobs_) {
        const std::string stage = job->progress.stage();
        result.push_back({.id = job->id,
                          .stage = stage.empty() ? job->stage : stage,
                          .fraction = job->progress.fraction(),
                          .seconds = std::chrono::duration<double>(now - job->begun).count()});
    }
    return result;
}

}  // namespace patina::editor
