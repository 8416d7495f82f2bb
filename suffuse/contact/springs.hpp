#pragma once
// The table of normal springs: a law is one of them, with the slip, rolling and twisting of linear_rolling.hpp. All
// that other rooms want to know of a law is in its row; the hot loop takes the spring itself.

#include "suffuse/contact/hertz_spring.hpp"
#include "suffuse/contact/linear_spring.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace suffuse::contact {

/// All there are, in the order of their numbers.
using SpringList = std::tuple<LinearSpring, HertzSpring>;

template <class S>
constexpr Spring row_of(const S&) {
    return {
        .law = S::law,
        .words = S::words,
        .stiffens = S::stiffens,
        .may_adhere = S::may_adhere,
        .constants = &S::constants,
        .exponent = &S::exponent,
        .shear_ratio = &S::shear_ratio,
        .most_stress = &S::most_stress,
        .force = &S::force,
        .tangent = &S::tangent,
        .energy = &S::energy,
        .overlap_under = &S::overlap_under,
        .overlap_of_impact = &S::overlap_of_impact,
        .stiffness_to_pressure = &S::stiffness_to_pressure};
}

inline constexpr auto springs =
    std::apply([](const auto&... spring) { return std::array{row_of(spring)...}; }, SpringList{});

static_assert(
    [] {
        for (std::size_t k = 0; k < springs.size(); ++k) {
            if (springs[k].law != static_cast<grains::ContactLaw>(k)) {
                return false;
            }
        }
        return true;
    }(),
    "a law's number is its place in the list"
);

inline const Spring& spring_of(grains::ContactLaw law) {
    return springs.at(static_cast<std::size_t>(law));
}

inline const Spring& spring_of(const grains::Material& material) {
    return spring_of(material.law);
}

/// Calls `visit` with the spring of a law, whose lanes are templates; to be done once, outside loops over contacts.
template <std::size_t K = 0, class Visit>
[[gnu::always_inline]] inline decltype(auto) visit_spring(grains::ContactLaw law, Visit&& visit) {
    using S = std::tuple_element_t<K, SpringList>;
    if constexpr (K + 1 < std::tuple_size_v<SpringList>) {
        if (law != S::law) {
            return visit_spring<K + 1>(law, std::forward<Visit>(visit));
        }
    }
    return visit(S{});
}

/// Whether a member of Material is of the law's own: read and written under it only.
inline bool has_own(const Spring& spring, std::string_view key) {
    return key == spring.words.shear_key || std::ranges::count(spring.words.more_keys, key) > 0;
}

/// Names of the laws for which a claim holds.
template <class Claim>
std::vector<std::string_view> laws_where(const Claim& claim) {
    std::vector<std::string_view> names;
    for (const Spring& spring : springs) {
        if (claim(spring)) {
            names.push_back(spring.words.name);
        }
    }
    return names;
}

/// For advice, to stand in quotes.
std::string laws_that_adhere();

/// Mean overlap over radius of equal spheres under an isotropic pressure [Pa].
double mean_overlap_at(const grains::Material& material, double pressure);

/// The linear law that is as stiff as `material` at an overlap of this share of the smaller radius: pairs of unequal
/// grains are less stiff, under Hertz's law by the root of two at most. The linear law itself is.
grains::Material linearized(const grains::Material& material, double relative_overlap);

} // namespace suffuse::contact
