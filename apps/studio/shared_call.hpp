#pragma once
// One call of the program whose answer several requests share: at most one is at work, whatever the number of reloads.
// What has arrived meanwhile waits for the call after it, so that no answer is older than its request.

#include "apps/studio/program.hpp"
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>

namespace suffuse::studio {

class SharedCall {
public:
    explicit SharedCall(std::function<ProgramCall()> call) : call_(std::move(call)) {}

    /// The answer of a call that begins after this one has arrived. @throws what that call throws
    ProgramCall answer();

    /// How many requests wait for a call of another one.
    [[nodiscard]] int waiting();

private:
    std::function<ProgramCall()> call_;
    std::mutex lock_;
    std::condition_variable has_ended_;
    long begun_ = 0, ended_ = 0; ///< calls
    int waiting_ = 0;            ///< requests
    ProgramCall last_;
    std::exception_ptr error_; ///< of the last call
};

} // namespace suffuse::studio
