#pragma once
// What the heading of a column of a laboratory test says: "Mean effective stress p' [kPa]", "eps1 (%)", "Q, mL/min".

#include "suffuse/laboratory/test_quantities.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::laboratory {

struct TestHeading {
    std::optional<Quantity> quantity; ///< none where it is not known
    bool names_tests = false;
    std::string unit;           ///< as written; empty where there is none
    bool is_effective = false;  ///< "p'", "effective"
    bool is_total = false;      ///< "total"
    bool is_cumulative = false; ///< "cumulative"
    bool is_half = false;       ///< "t [kPa]", "s' [kPa]": half the difference, half the sum of axial and radial stress
    bool expands = false;       ///< "dilation", "extension", "contraction negative": positive where the soil grows
    bool contracts = false;     ///< "contraction", "compression positive"
};

TestHeading read_test_heading(std::string_view text, TestKind kind);

/// What a unit stands for in SI; 1 for "-". None where it is no unit of this dimension.
std::optional<double> unit_in_si(std::string_view unit, Dimension wanted);

} // namespace suffuse::laboratory
