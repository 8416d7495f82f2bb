#pragma once
// "Depth (m),1.5,3.0,4.5" and "Sample,1,2,3" in a row: depths and numbers of samples whose sizes stand below each
// other, or a heading of names above sieves that stand across.

#include "suffuse/gradings/sheet.hpp"

#include <cstddef>
#include <vector>

namespace suffuse::gradings {

/// Whether the numbers in these columns of a row of samples or depths are theirs, and none is a sieve. The rows of
/// `values` below begin with a number each, which may be a size or the name of a sample.
bool numbers_samples(
    const Sheet& sheet, std::size_t row, const std::vector<std::size_t>& columns,
    const std::vector<const SheetRow*>& values
);

} // namespace suffuse::gradings
