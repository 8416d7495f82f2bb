#pragma once
// The readings of one test of a laboratory, and the stresses that follow from its columns.

#include "suffuse/casefile/calibrate_spec.hpp"
#include "suffuse/laboratory/test_record.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

using Values = std::vector<double>;

class Readings {
public:
    /// Refers to both as long as it lives. @throws CaseError where the record does not hold the test of the target
    Readings(const laboratory::TestRecord& record, const casefile::CalibrateTarget& target);

    [[nodiscard]] const laboratory::TestColumn* find(laboratory::Quantity quantity) const {
        return record_.find(quantity);
    }

    /// @throws CaseError where there is none
    [[nodiscard]] Values of(laboratory::Quantity quantity) const;

    [[noreturn]] void complain(const std::string& what) const;

private:
    const laboratory::TestRecord& record_;
    const casefile::CalibrateTarget& target_;
    laboratory::NamedTest range_;
};

Values since_start(Values values);

/// A stress, less the pore pressure where its heading calls it total and `as_effective` is wanted.
Values stress_of(const Readings& readings, laboratory::Quantity quantity, bool as_effective);

/// Of stresses of which one is effective and the other total, both are taken as effective.
Values deviator_of(const Readings& readings);

/// Effective mean stress: measured; else of the radial or axial stress and q; else what water leaves of the pressure of
/// the start, at a constant total radial stress.
Values mean_of(const Readings& readings, double pressure);

/// Effective, as far as the record has it.
std::optional<Values> lateral_stress_of(const Readings& readings);

} // namespace suffuse::job
