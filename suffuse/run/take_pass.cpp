#include "suffuse/run/take_pass.hpp"

#include "suffuse/erosion/loop.hpp"

#include <fmt/format.h>

namespace suffuse::run {

bool take_pass(const std::function<bool()>& pass) {
    try {
        return pass();
    } catch (const erosion::NoSkeleton& error) {
        throw StateError(fmt::format("{}; leave this fines content out (key `only`)", error.what()));
    }
}

} // namespace suffuse::run
