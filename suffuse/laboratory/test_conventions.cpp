#include "suffuse/laboratory/test_conventions.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/laboratory/strain_conventions.hpp"
#include "suffuse/laboratory/stress_conventions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::laboratory {
namespace {

void check_not_negative(const RecordReview& review, Quantity quantity) {
    const TestColumn* column = review.record.find(quantity);
    if (column != nullptr && std::ranges::any_of(column->values, [](double v) { return v < 0; })) {
        review.refuse(fmt::format(
            "column \"{}\" has negative values: it may be the direction of flow; write the amount of the gradient",
            column->heading
        ));
    }
}

void check_void_ratio(const RecordReview& review) {
    const TestColumn* e = review.record.find(Quantity::VoidRatio);
    if (e != nullptr && std::ranges::any_of(e->values, [](double v) { return v <= 0; })) {
        review.refuse(fmt::format("column \"{}\" has void ratios of 0 or less; correct its numbers", e->heading));
    }
}

/// What was carried out until each reading, or since the one before.
void settle_mass(const RecordReview& review) {
    TestColumn* mass = review.record.find(Quantity::Mass);
    if (mass == nullptr) {
        return;
    }
    bool falls = false;
    review.for_each_row([&](std::size_t k, std::size_t first) {
        falls = falls || (k > first && mass->values[k] < mass->values[k - 1]);
    });
    if (falls && mass->is_cumulative) {
        review.refuse(fmt::format("column \"{}\" is cumulative, and falls; check its numbers", mass->heading));
    }
    if (falls) {
        review.decided(fmt::format("\"{}\" counts from one reading to the next: it falls", mass->heading));
        review.for_each_row([&](std::size_t k, std::size_t first) {
            mass->values[k] += k > first ? mass->values[k - 1] : 0;
        });
    } else if (mass->is_cumulative) {
        review.decided(fmt::format("\"{}\" counts from the beginning: by its heading", mass->heading));
    } else {
        review.assumed(fmt::format("\"{}\" counts from the beginning: it never falls", mass->heading));
    }
}

void check_time(const RecordReview& review) {
    const TestColumn* time = review.record.find(Quantity::Time);
    if (time == nullptr) {
        return;
    }
    for (const NamedTest& test : review.record.tests) {
        for (std::size_t k = test.begin + 1; k < test.end; ++k) {
            if (time->values[k] < time->values[k - 1]) {
                review.refuse(fmt::format(
                    "test \"{}\": the time of reading {} is before that of the reading above; sort the rows, or name "
                    "the tests in a column \"test\"",
                    shown(test.name), k - test.begin + 1
                ));
            }
        }
    }
}

} // namespace

void find_conventions(TestRecord& record, const std::string& file, std::optional<bool> contraction_is_positive) {
    const RecordReview review{record, file};
    check_stresses_are_compressive(review);
    check_void_ratio(review);
    switch (record.kind) {
    case TestKind::Triaxial:
        settle_halves(review);
        settle_volumetric_strain(review, contraction_is_positive);
        settle_triaxial_axial_strain(review);
        settle_triaxial_stresses(review);
        break;
    case TestKind::Oedometer:
        settle_oedometer_stress(review);
        settle_oedometer_strain(review);
        break;
    case TestKind::Permeameter:
        check_not_negative(review, Quantity::Gradient);
        check_not_negative(review, Quantity::HeadDifference);
        settle_mass(review);
        break;
    }
    check_time(review);
}

} // namespace suffuse::laboratory
