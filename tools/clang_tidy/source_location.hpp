#pragma once
// For clang-tidy 14 only (preset tidy): it lacks the builtin behind libstdc++ 12's std::source_location, and would lose the
// type of every error. Never part of a build.
#include <source_location>

#ifndef __cpp_lib_source_location
namespace std { // NOLINT(cert-dcl58-cpp)
struct source_location {
    static constexpr source_location current() noexcept { return {}; }

    [[nodiscard]] constexpr unsigned line() const noexcept { return 0; }

    [[nodiscard]] constexpr unsigned column() const noexcept { return 0; }

    [[nodiscard]] constexpr const char* file_name() const noexcept { return ""; }

    [[nodiscard]] constexpr const char* function_name() const noexcept { return ""; }
};
} // namespace std
#endif
