#pragma once
// What laboratory tests measure: tests, quantities, and the words that name them in headings. docs/laboratory-tests.md
// has the rows of the table; a test compares them.

#include "suffuse/base/units.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace suffuse::laboratory {

enum class TestKind { Triaxial, Oedometer, Permeameter };

/// "triaxial", "oedometer", "permeameter", in the order of the enumeration.
std::span<const std::string_view> test_kind_names();
std::optional<TestKind> test_kind_named(std::string_view name);

enum class Quantity {
    AxialStrain,
    VolumetricStrain,
    VoidRatio,
    DeviatorStress, ///< axial minus radial stress
    MeanStress,     ///< (axial + 2 radial stress) / 3
    AxialStress,
    RadialStress,
    PorePressure,
    Time,
    Gradient,
    HeadDifference,
    Discharge,
    Velocity, ///< discharge / cross section
    Mass,     ///< of the soil that was carried out
};

struct QuantityRow {
    Quantity quantity;
    std::string_view key;  ///< in JSON
    std::string_view name; ///< in texts
    Dimension dimension;
    std::string_view usual_unit;         ///< for texts
    std::vector<TestKind> tests;         ///< which measure it
    std::vector<std::string_view> words; ///< small letters and digits alone
};

/// In the order of the enumeration.
std::span<const QuantityRow> quantity_rows();
const QuantityRow& row_of(Quantity quantity);

/// Columns that name tests: "test", "sample".
std::span<const std::string_view> name_words();

} // namespace suffuse::laboratory
