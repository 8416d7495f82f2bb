#pragma once
// The SHA-256 of a file that stands within this file: of all its bytes, where its own digits count as zeros.

#include "suffuse/base/sha256.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace suffuse::io {

class DigestWithin {
public:
    static constexpr std::size_t digits = 64;

    /// @param place offset of the digits in the file
    explicit DigestWithin(std::size_t place) : place_(place) {}

    /// The next bytes of the file.
    void add(std::string_view bytes);

    /// The digits that stood in the bytes.
    [[nodiscard]] const std::string& recorded() const { return recorded_; }

    /// The digits that belong there; no more bytes may follow.
    std::string found() { return hash_.hex(); }

private:
    Sha256 hash_;
    std::size_t place_, at_ = 0;
    std::string recorded_;
};

} // namespace suffuse::io
