#pragma once
// A record while its conventions are found out: what decided, what was assumed, and sums over the rows of its tests.

#include "suffuse/base/error.hpp"
#include "suffuse/laboratory/test_record.hpp"

#include <string>
#include <utility>

namespace suffuse::laboratory {

struct RecordReview {
    TestRecord& record;
    const std::string& file; ///< for messages

    void decided(std::string text) const { record.findings.push_back({false, std::move(text)}); }

    void assumed(std::string text) const { record.findings.push_back({true, std::move(text)}); }

    /// @throws CaseError
    [[noreturn]] void refuse(const std::string& text) const { throw CaseError(file + ": " + text, file); }

    /// Calls f(row, first row of its test).
    template <class Visit>
    void for_each_row(const Visit& visit) const {
        for (const NamedTest& test : record.tests) {
            for (std::size_t k = test.begin; k < test.end; ++k) {
                visit(k, test.begin);
            }
        }
    }

    /// Sum of f(row, first row of its test).
    template <class Term>
    [[nodiscard]] double sum(const Term& term) const {
        double total = 0;
        for_each_row([&](std::size_t k, std::size_t first) { total += term(k, first); });
        return total;
    }
};

/// Another unit or sign of a column.
inline void multiply(TestColumn& column, double factor) {
    column.factor *= factor;
    for (double& value : column.values) {
        value *= factor;
    }
}

} // namespace suffuse::laboratory
