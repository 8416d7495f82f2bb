#pragma once
// Triaxial, oedometer and permeameter tests out of tables of laboratories: a heading, perhaps titles above it and a
// line of units below, a row a reading. Units and signs are found out, not guessed: test_conventions.hpp.

#include "suffuse/base/place.hpp"
#include "suffuse/laboratory/test_record.hpp"

#include <filesystem>
#include <memory>

namespace suffuse::laboratory {

struct TestRequest {
    TestKind kind = TestKind::Triaxial;
    std::optional<bool> contraction_is_positive = {}; ///< of volumetric strains; found out unless given
};

/// @throws CaseError with file, line and column where the table is not understood.
TestRecord parse_test(const std::shared_ptr<const Source>& source, const TestRequest& request);

/// The same of a file. @throws IoError where it cannot be read.
TestRecord read_test(const std::filesystem::path& path, const TestRequest& request);

} // namespace suffuse::laboratory
