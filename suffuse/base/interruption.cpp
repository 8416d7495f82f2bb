#include "suffuse/base/interruption.hpp"

#include <utility>

namespace suffuse {

thread_local Interruption* Interruption::innermost = nullptr;

Interruption::Interruption(std::function<void()> look)
    : look_(std::move(look)), outer_(std::exchange(innermost, this)) {}

Interruption::~Interruption() {
    innermost = outer_;
}

} // namespace suffuse
