#pragma once
// Numbers of a chart: six digits are more than a line shows, and half the bytes; the run's own files hold all of them.

#include <fmt/format.h>

#include <cstdlib>

namespace suffuse::figures {

inline double six_digits(double value) {
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

} // namespace suffuse::figures
