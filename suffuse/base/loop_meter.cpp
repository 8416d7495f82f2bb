#include "suffuse/base/loop_meter.hpp"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <numeric>
#include <queue>
#include <utility>

namespace suffuse {
namespace {

thread_local LoopMeter* meter = nullptr;

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

LoopMeter::LoopMeter(int threads, double (*clock)())
    : threads_(threads), clock_(clock != nullptr ? clock : processor_seconds), since_(clock_()) {
    meter = this;
    begin("rest");
}

LoopMeter::~LoopMeter() {
    meter = nullptr;
}

LoopMeter* LoopMeter::of_this_thread() {
    return meter;
}

void LoopMeter::charge() {
    const double now = clock_();
    if (!phases_.empty()) {
        phases_[now_].serial += now - since_;
    }
    since_ = now;
}

std::vector<LoopMeter::Phase> LoopMeter::phases() {
    charge();
    return phases_;
}

void LoopMeter::measure(std::size_t blocks, const std::function<void(std::size_t, std::size_t)>& body) {
    charge();
    std::vector<double> durations(blocks);
    double before = clock_();
    for (std::size_t b = 0; b < blocks; ++b) {
        body(b, b + 1);
        const double after = clock_();
        durations[b] = after - std::exchange(before, after);
    }
    Phase& phase = phases_[now_];
    ++phase.loops;
    phase.parallel += std::accumulate(durations.begin(), durations.end(), 0.0);
    phase.shared += shared_time(durations, threads_);
    since_ = clock_(); // what has just been worked out is nobody's
}

std::size_t LoopMeter::begin(const char* name) {
    charge();
    const std::size_t before = now_;
    const auto found =
        std::ranges::find_if(phases_, [&](const Phase& phase) { return std::strcmp(phase.name, name) == 0; });
    now_ = static_cast<std::size_t>(found - phases_.begin());
    if (found == phases_.end()) {
        phases_.push_back({name, 0, 0, 0, 0});
    }
    return before;
}

void LoopMeter::resume(std::size_t phase) {
    charge();
    now_ = phase;
}

MeteredPhase::MeteredPhase(const char* name) : meter_(meter) {
    if (meter_ != nullptr) {
        before_ = meter_->begin(name);
    }
}

MeteredPhase::~MeteredPhase() {
    if (meter_ != nullptr) {
        meter_->resume(before_);
    }
}

void MeteredPhase::next(const char* name) {
    if (meter_ != nullptr) {
        meter_->begin(name);
    }
}

double shared_time(std::span<const double> blocks, int threads) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
    for (int t = 0; t < threads; ++t) {
        free_at.push(0);
    }
    double end = 0;
    for (const double duration : blocks) {
        const double done = free_at.top() + duration;
        free_at.pop();
        free_at.push(done);
        end = std::max(end, done);
    }
    return end;
}

} // namespace suffuse
