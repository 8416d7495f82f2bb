#include "apps/studio/shared_call.hpp"

namespace suffuse::studio {

ProgramCall SharedCall::answer() {
    std::unique_lock held(lock_);
    const long fresh = begun_ + 1; // the first call that begins from now on
    while (ended_ < fresh) {
        if (begun_ > ended_) {
            ++waiting_;
            has_ended_.wait(held);
            --waiting_;
            continue;
        }
        ++begun_;
        held.unlock();
        ProgramCall made;
        std::exception_ptr error;
        try {
            made = call_();
        } catch (...) {
            error = std::current_exception();
        }
        held.lock();
        last_ = std::move(made);
        error_ = error;
        ++ended_;
        has_ended_.notify_all();
    }
    if (error_) {
        std::rethrow_exception(error_);
    }
    return last_;
}

int SharedCall::waiting() {
    const std::scoped_lock held(lock_);
    return waiting_;
}

} // namespace suffuse::studio
