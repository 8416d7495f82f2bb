#include "apps/process_limits.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pthread.h>
#include <sys/resource.h>

namespace suffuse::apps {
namespace {

/// @return what is allowed then
rlim_t raise_limit(decltype(RLIMIT_STACK) kind, rlim_t wanted) {
    rlimit limit{};
    if (getrlimit(kind, &limit) != 0 || limit.rlim_cur >= wanted) {
        return wanted;
    }
    limit.rlim_cur = std::min(wanted, limit.rlim_max); // without a limit it is the largest number
    return setrlimit(kind, &limit) == 0 ? limit.rlim_cur : 0;
}

} // namespace

void raise_stack_limit() {
    constexpr rlim_t usual = 8U << 20U, least = 512U << 10U; // [bytes]
    rlimit before{};
    getrlimit(RLIMIT_STACK, &before);
    const rlim_t allowed = raise_limit(RLIMIT_STACK, usual);
    if (allowed < least) {
        throw IoError(fmt::format(
            "the stack may only take {} kB (ulimit -s), and suffuse needs {}; raise the limit: ulimit -s 8192",
            allowed >> 10U, least >> 10U
        ));
    }
    if (before.rlim_cur < allowed) { // threads have as much as the limit was at the start
        pthread_attr_t usual_thread;
        pthread_attr_init(&usual_thread);
        pthread_attr_setstacksize(&usual_thread, allowed);
        pthread_setattr_default_np(&usual_thread);
        pthread_attr_destroy(&usual_thread);
    }
}

void raise_file_limit() {
    constexpr rlim_t usual = 256, least = 16;
    if (const rlim_t allowed = raise_limit(RLIMIT_NOFILE, usual); allowed < least) {
        throw IoError(fmt::format(
            "only {} files may be open at once (ulimit -n), and suffuse needs {}; raise the limit: ulimit -n {}",
            allowed, least, usual
        ));
    }
}

} // namespace suffuse::apps
