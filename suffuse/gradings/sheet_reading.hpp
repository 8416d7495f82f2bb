#pragma once
// Which columns a curve came from, and as what they were read.

#include <fmt/format.h>

#include <string>

namespace suffuse::gradings {

struct SheetReading {
    std::string size, size_unit; ///< heading as written, and "mm", "um", "phi"
    std::string share;           ///< heading as written
    std::string kind;            ///< "percent passing", "retained on each sieve alone"
    std::string share_unit;      ///< "%", "mass", "number"
};

/// "sizes: Sieve (mm), in mm; shares: Weight (%), read as retained on each sieve alone, in %".
inline std::string words_of(const SheetReading& reading) {
    return fmt::format(
        "sizes: {}, in {}; shares: {}, read as {}, in {}", reading.size.empty() ? "no heading" : reading.size,
        reading.size_unit, reading.share.empty() ? "no heading" : reading.share, reading.kind, reading.share_unit
    );
}

} // namespace suffuse::gradings
