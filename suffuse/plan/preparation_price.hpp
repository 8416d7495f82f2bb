#pragma once
// What preparing a sample takes, besides its strain: one table, written by
//     tools/record_plans.py --preparation RUN...
// from runs that prepared samples.

#include "suffuse/base/range.hpp"

#include <array>
#include <string_view>

namespace suffuse::plan {

struct PreparationPrice {
    std::string_view kind; ///< protocol, and how grains met: stage_kind
    Range steps; ///< over those that the strain takes at the largest rate, of 2,000 median grains if it creeps [-]
};

inline constexpr std::array<PreparationPrice, 12> preparation_prices = {{
    {"faithful, adhesive", {2.2, 5.4}},
    {"faithful, frictionless", {3.3, 17}},
    {"faithful, frictional", {3.1, 6.8}},
    {"slow, adhesive", {3.5, 7.5}},
    {"slow, frictionless", {3.5, 7.5}},
    {"slow, frictional", {3.5, 7.5}},
    {"skeleton first, adhesive", {1.3, 2.6}},
    {"skeleton first, frictionless", {10, 21}},
    {"skeleton first, frictional", {1.6, 3.5}},
    {"wide, adhesive", {3, 5}},
    {"wide, frictionless", {15, 41}},
    {"wide, frictional", {1.9, 6.4}},
}};

} // namespace suffuse::plan
