#include "suffuse/laboratory/stress_conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::laboratory {
namespace {

constexpr double stress_match = 0.02; // relative, of stresses that are rounded

void settle_by_radial_stress(const RecordReview& review, TestColumn& p, const TestColumn& q, TestColumn& radial) {
    const TestColumn* u = review.record.find(Quantity::PorePressure);
    const double size = std::sqrt(review.sum([&](std::size_t k, std::size_t) { return std::pow(p.values[k], 2); }));
    const auto is_close = [&](double share_of_q, double share_of_u) {
        const double off = std::sqrt(review.sum([&](std::size_t k, std::size_t) {
            const double pore = u != nullptr ? u->values[k] : 0;
            return std::pow(p.values[k] - radial.values[k] - share_of_q * q.values[k] - share_of_u * pore, 2);
        }));
        return off <= stress_match * size;
    };
    const auto expect_heading = [&](const TestColumn& stress, bool is_effective) {
        if (stress.is_effective.value_or(is_effective) != is_effective) {
            review.refuse(fmt::format(
                "column \"{}\" is {} by its heading, and {} by \"{}\" and the pore pressure; correct one of them",
                stress.heading, is_effective ? "total" : "effective", is_effective ? "effective" : "total",
                &stress == &p ? radial.heading : p.heading
            ));
        }
    };
    if (is_close(1.0 / 3, 0)) {
        if (u != nullptr && p.is_effective && radial.is_effective &&
            !is_close(1.0 / 3, *radial.is_effective ? 1 : -1)) {
            expect_heading(radial, *p.is_effective);
        }
        review.decided(fmt::format(
            "\"{0}\" is \"{1}\" + \"{2}\"/3: \"{2}\" is axial minus radial stress, and \"{0}\" is effective where "
            "\"{1}\" is",
            p.heading, radial.heading, q.heading
        ));
        if (!p.is_effective) {
            p.is_effective = radial.is_effective;
        } else if (!radial.is_effective) {
            radial.is_effective = p.is_effective;
        }
        return;
    }
    if (u != nullptr && (is_close(1.0 / 3, 1) || is_close(1.0 / 3, -1))) {
        const bool p_is_total = is_close(1.0 / 3, 1);
        expect_heading(p, !p_is_total);
        expect_heading(radial, p_is_total);
        review.decided(fmt::format(
            "\"{}\" is {} and \"{}\" is {}: they differ by the pore pressure", p.heading,
            p_is_total ? "total" : "effective", radial.heading, p_is_total ? "effective" : "total"
        ));
        p.is_effective = !p_is_total;
        radial.is_effective = p_is_total;
        return;
    }
    review.refuse(fmt::format(
        "columns \"{}\", \"{}\" and \"{}\" contradict one another{}; expected p = radial stress + q/3 with q = axial "
        "minus radial stress",
        p.heading, q.heading, radial.heading,
        is_close(1, 0) ? ": they are s and t of the Massachusetts Institute of Technology, half the sum and half the "
                         "difference of axial and radial stress; q = 2 t and p = s - t/3"
                       : ""
    ));
}

/// Three of axial stress a, radial stress r, q = a - r and p = (a + 2 r)/3 agree; some of them may be total.
void check_three_stresses(const RecordReview& review) {
    struct Sum {
        Quantity first, second, third;
        double of_first, of_second, of_third; ///< add up to 0
        const char* words;
    };

    using enum Quantity;
    constexpr std::array sums{
        Sum{AxialStress, RadialStress, DeviatorStress, 1, -1, -1, "q = axial minus radial stress"},
        Sum{AxialStress, RadialStress, MeanStress, 1, 2, -3, "p = (axial + 2 radial stress)/3"},
        Sum{AxialStress, DeviatorStress, MeanStress, 3, -2, -3, "p = axial stress - 2 q/3"}};
    const TestColumn* u = review.record.find(PorePressure);
    for (const Sum& sum : sums) {
        const TestColumn *a = review.record.find(sum.first), *b = review.record.find(sum.second),
                         *c = review.record.find(sum.third);
        if (a == nullptr || b == nullptr || c == nullptr) {
            continue;
        }
        const auto norm = [&](double with_a, double with_b, double with_c, double with_u) {
            return std::sqrt(review.sum([&](std::size_t k, std::size_t) {
                const double pore = u != nullptr ? u->values[k] : 0;
                return std::pow(
                    with_a * a->values[k] + with_b * b->values[k] + with_c * c->values[k] + with_u * pore, 2
                );
            }));
        };
        const double size = std::abs(sum.of_first) * norm(1, 0, 0, 0);
        const bool agree = std::ranges::any_of(std::array{0, -1, 1, -2, 2, -3, 3}, [&](int times) {
            return norm(sum.of_first, sum.of_second, sum.of_third, times) <= stress_match * size;
        });
        if (!agree) {
            review.refuse(fmt::format(
                "columns \"{}\", \"{}\" and \"{}\" contradict one another; expected {}", a->heading, b->heading,
                c->heading, sum.words
            ));
        }
    }
}

/// Whether water leaves or enters: the volume changes.
bool is_drained(const RecordReview& review) {
    constexpr double no_volume = 1e-3; // of strain, of an apparatus that gives way
    const TestColumn* strain = review.record.find(Quantity::VolumetricStrain);
    bool changes = false;
    review.for_each_row([&](std::size_t k, std::size_t first) {
        changes = changes || (strain != nullptr && std::abs(strain->values[k] - strain->values[first]) > no_volume);
    });
    return changes;
}

/// In a drained test at a constant cell pressure q rises by 3 as p rises by 1.
void settle_by_slope(const RecordReview& review, const TestColumn& p, const TestColumn& q) {
    double pp = 0, pq = 0;
    for (const NamedTest& test : review.record.tests) {
        double mean_p = 0, mean_q = 0;
        const auto rows = static_cast<double>(test.end - test.begin);
        for (std::size_t k = test.begin; k < test.end; ++k) {
            mean_p += p.values[k] / rows;
            mean_q += q.values[k] / rows;
        }
        for (std::size_t k = test.begin; k < test.end; ++k) {
            pp += std::pow(p.values[k] - mean_p, 2);
            pq += (p.values[k] - mean_p) * (q.values[k] - mean_q);
        }
    }
    constexpr double tolerance = 0.1;
    const double slope = pp > 0 ? pq / pp : 0;
    const auto is_near = [&](double wanted) { return std::abs(slope - wanted) <= tolerance * wanted; };
    if (!is_drained(review) || !(is_near(3) || is_near(1) || is_near(2) || is_near(1.5))) {
        review.assumed(fmt::format(
            "\"{}\" and \"{}\" are read as q = axial minus radial stress and p = (axial + 2 radial stress)/3; q rises "
            "by "
            "{:.2g} with p, and by 3 in a drained test at a constant radial stress",
            q.heading, p.heading, slope
        ));
        return;
    }
    if (is_near(3)) {
        review.decided(fmt::format(
            "\"{}\" and \"{}\", read as q = axial minus radial stress and p = the mean of three stresses, agree: q "
            "rises by 3 with p",
            q.heading, p.heading
        ));
        return;
    }
    review.refuse(fmt::format(
        "\"{}\" rises by {:.2g} with \"{}\", and by 3 if they are axial minus radial stress and the mean of three "
        "stresses: {}; or add the radial stress, which decides",
        q.heading, slope, p.heading,
        is_near(1)
            ? "they may be half the difference and half the sum of axial and radial stress, t and s; write q = 2 "
              "t and p = s - t/3"
        : is_near(2) ? "the second may be half the sum of axial and radial stress, s; write p = s - q/6"
                     : "the first may be half the difference of axial and radial stress, t; write q = 2 t"
    ));
}

void settle_effective(const RecordReview& review, TestColumn& stress) {
    if (stress.is_effective) {
        return;
    }
    if (review.record.find(Quantity::PorePressure) != nullptr) {
        review.refuse(fmt::format(
            "column \"{0}\" may be effective or total, as there is a pore pressure; write \"effective {0}\" or \"total "
            "{0}\"",
            stress.heading
        ));
    }
    review.assumed(fmt::format("\"{}\" is effective", stress.heading));
    stress.is_effective = true;
}

} // namespace

void check_stresses_are_compressive(const RecordReview& review) {
    for (const Quantity q : {Quantity::MeanStress, Quantity::RadialStress, Quantity::AxialStress}) {
        const TestColumn* column = review.record.find(q);
        if (column != nullptr && review.sum([&](std::size_t k, std::size_t) { return column->values[k]; }) < 0) {
            review.refuse(fmt::format(
                "column \"{}\" is negative in the mean: compression seems to be negative, or a total stress below the "
                "pore pressure is meant; write compressive stresses and strains with a positive sign",
                column->heading
            ));
        }
    }
}

void settle_halves(const RecordReview& review) {
    TestColumn *q = review.record.find(Quantity::DeviatorStress), *p = review.record.find(Quantity::MeanStress);
    if (q != nullptr && q->is_half) {
        review.decided(
            fmt::format("\"{}\" is half of axial minus radial stress by its heading: q is twice as large", q->heading)
        );
        multiply(*q, 2);
    }
    if (p == nullptr || !p->is_half) {
        return;
    }
    if (q == nullptr) {
        review.refuse(fmt::format(
            "column \"{}\" is half the sum of axial and radial stress by its heading, and p follows from it and q; add "
            "a "
            "column of q or t",
            p->heading
        ));
    }
    review.decided(fmt::format(
        "\"{}\" is half the sum of axial and radial stress by its heading: p is less by a sixth of q", p->heading
    ));
    for (std::size_t k = 0; k < p->values.size(); ++k) {
        p->values[k] -= q->values[k] / 6;
    }
}

void settle_triaxial_stresses(const RecordReview& review) {
    TestColumn* p = review.record.find(Quantity::MeanStress);
    const TestColumn* q = review.record.find(Quantity::DeviatorStress);
    TestColumn* radial = review.record.find(Quantity::RadialStress);
    check_three_stresses(review);
    if (p != nullptr && q != nullptr && radial != nullptr) {
        settle_by_radial_stress(review, *p, *q, *radial);
    } else if (p != nullptr && q != nullptr) {
        settle_by_slope(review, *p, *q);
    }
    for (const Quantity quantity : {Quantity::MeanStress, Quantity::RadialStress, Quantity::AxialStress}) {
        if (TestColumn* column = review.record.find(quantity)) {
            settle_effective(review, *column);
        }
    }
}

void settle_oedometer_stress(const RecordReview& review) {
    settle_effective(review, *review.record.find(Quantity::AxialStress));
}

} // namespace suffuse::laboratory
