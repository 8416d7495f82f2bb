#pragma once
// The record of laboratory tests as it is understood: columns with their roles, values in SI, compression and
// contraction positive.

#include "suffuse/laboratory/test_quantities.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::laboratory {

struct TestColumn {
    Quantity quantity = Quantity::Time;
    std::string heading;                     ///< as written
    std::string unit;                        ///< of the column; empty where nobody gives it
    double factor = 1;                       ///< from the column to SI, with the sign
    std::optional<bool> is_effective;        ///< of stresses, where it is known
    bool is_cumulative = false;              ///< by its heading
    bool is_half = false;                    ///< by its heading s or t, until its conventions are found
    bool expands = false, contracts = false; ///< by its heading
    std::vector<double> values;              ///< one a row [SI]
};

/// Rows of one test.
struct NamedTest {
    std::string name;
    std::size_t begin = 0, end = 0;
};

/// How something was found out.
struct Finding {
    bool is_assumed = false; ///< else it follows from the file
    std::string text;
};

struct TestRecord {
    TestKind kind = TestKind::Triaxial;
    std::vector<TestColumn> columns;
    std::vector<NamedTest> tests;
    std::vector<std::string> unread; ///< headings of columns that are not read
    std::vector<std::string> titles; ///< lines above the headings
    std::vector<Finding> findings;

    [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }

    [[nodiscard]] TestColumn* find(Quantity quantity);
    [[nodiscard]] const TestColumn* find(Quantity quantity) const;
};

} // namespace suffuse::laboratory
