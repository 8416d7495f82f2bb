#include "suffuse/flow/pressure.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/raw_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::size_t block = 4096;

/// Displacement of the center of side 1 from that of side 0 [m].
Vec3 across(const pores::PoreNetwork& network, std::size_t t) {
    const auto [p, q] = network.throats.side[t];
    return network.pores.center[q] + cell::shift(network.h, network.throats.image[t]) - network.pores.center[p];
}

double mean(std::span<const double> values) {
    double sum = 0;
    for (const double v : values) {
        sum += v;
    }
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// The ends of throats at each body of water: rows 2 t + side. Sums over them add in the order of the throats.
Members ends_of_throats(const pores::PoreNetwork& network) {
    const pores::Pores& pores = network.pores;
    Members ends = members_of(pores.size(), network.bodies, [&](std::size_t p) { return pores.body[p]; });
    const std::vector<std::uint32_t> pore = std::move(ends.row);
    resize_columns(4 * pore.size(), ends.row);
    parallel_for(pore.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t m = begin; m < end; ++m) {
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t p = pore[m], t = pores.throat[p][k];
                ends.row[4 * m + k] = 2 * t + static_cast<std::uint32_t>(side_of(network, p, k));
            }
        }
    });
    for (std::uint32_t& first : ends.first) {
        first *= 4;
    }
    parallel_for(network.bodies, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            std::sort(ends.row.begin() + ends.first[b], ends.row.begin() + ends.first[b + 1]);
        }
    });
    return ends;
}

WeightedGraph graph_of(const pores::PoreNetwork& network, std::span<const double> conductance, double unit) {
    expects(conductance.size() == network.throats.size(), "one conductance a throat");
    const Members ends = ends_of_throats(network);
    return make_graph(network.bodies, [&](std::uint32_t b, GraphRow& row) {
        for (const std::uint32_t end : ends.of(b)) {
            const std::uint32_t other_side = network.throats.side[end / 2][1 - end % 2];
            row.emplace_back(network.pores.body[other_side], conductance[end / 2] / unit);
        }
        return 0.0;
    });
}

/// Sum of the fluxes out of a body.
double outflow(const Members& ends, std::size_t body, std::span<const double> flux) {
    double sum = 0;
    for (const std::uint32_t end : ends.of(body)) {
        sum += end % 2 == 0 ? flux[end / 2] : -flux[end / 2];
    }
    return sum;
}

double positive_mean(std::span<const double> conductance) {
    const double value = mean(conductance);
    return value > 0 ? value : 1;
}

void check_convergence(const FlowField& field, const SolverSpec& spec, std::size_t pores) {
    if (field.residual <= spec.tolerance) {
        return;
    }
    throw SolverError(
        fmt::format(
            "flow: the pressures of {} pores did not converge: residual {:.3g} after {} iterations, at most {:.3g} is "
            "allowed; look for throats whose conductances differ by more than twelve orders of magnitude",
            pores, field.residual, field.iterations, spec.tolerance
        ),
        field.iterations, field.residual
    );
}

} // namespace

PressureSolver::PressureSolver(
    const pores::PoreNetwork& network, std::span<const double> conductance, const SolverSpec& spec
)
    : network_(network), conductance_(conductance), spec_(spec), unit_(positive_mean(conductance)),
      multigrid_(graph_of(network, conductance, unit_)) {}

PressureSolver::Source PressureSolver::source(const Vec3& gradient) const {
    const Members ends = ends_of_throats(network_); // found again where needed: memory is scarce between
    RawColumn<double> flux(network_.throats.size());
    parallel_for(flux.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            flux[t] = conductance_[t] / unit_ * dot(gradient, across(network_, t));
        }
    });
    Source source{std::vector<double>(network_.bodies), 0};
    RawColumn<double> all(network_.bodies);
    parallel_for(network_.bodies, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            source.net[b] = outflow(ends, b, flux);
            all[b] = 0;
            for (const std::uint32_t e : ends.of(b)) {
                all[b] += std::abs(flux[e / 2]);
            }
        }
    });
    source.whole = multigrid_.size(all);
    return source;
}

FlowField PressureSolver::solve(const Vec3& gradient) const {
    // Unknown is the deviation from the mean gradient: periodic, and zero in a perfect lattice. Convergence is measured
    // against the fluxes themselves, because their net may be nothing but rounding.
    Source source = this->source(gradient);
    const double whole = source.whole;
    const GraphMultigrid::Result result =
        multigrid_.solve(std::move(source.net), spec_.tolerance * whole, spec_.iteration_limit);
    FlowField field;
    field.iterations = result.iterations;
    field.residual = whole > 0 ? result.imbalance / whole : 0;
    check_convergence(field, spec_, network_.pores.size());
    set_pressures(result.x, gradient, field);
    set_fluxes(result.x, gradient, field);
    return field;
}

void PressureSolver::set_pressures(std::span<const double> deviation, const Vec3& gradient, FlowField& field) const {
    const pores::Pores& pores = network_.pores;
    resize_columns(pores.size(), field.pressure);
    parallel_for(pores.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            field.pressure[p] = deviation[pores.body[p]];
        }
    });
    const double level = mean(field.pressure);
    parallel_for(pores.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            field.pressure[p] += dot(gradient, pores.center[p]) - level;
        }
    });
}

void PressureSolver::set_fluxes(std::span<const double> deviation, const Vec3& gradient, FlowField& field) const {
    resize_columns(network_.throats.size(), field.flux);
    parallel_for(field.flux.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto [p, q] = network_.throats.side[t];
            const double between = deviation[network_.pores.body[p]] - deviation[network_.pores.body[q]];
            field.flux[t] = conductance_[t] * (between - dot(gradient, across(network_, t)));
        }
    });
    const Members ends = ends_of_throats(network_);
    const auto larger = [](double one, double other) { return std::max(one, other); };
    const auto largest_of = [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (std::size_t b = begin; b < end; ++b) {
            largest = std::max(largest, std::abs(outflow(ends, b, field.flux)));
        }
        return largest;
    };
    field.net_outflow = parallel_sum(network_.bodies, block, 0.0, largest_of, larger);
}

FlowField solve_pressure(
    const pores::PoreNetwork& network, std::span<const double> conductance, const Vec3& gradient, const SolverSpec& spec
) {
    return PressureSolver(network, conductance, spec).solve(gradient);
}

Vec3 mean_velocity(const pores::PoreNetwork& network, std::span<const double> flux) {
    expects(flux.size() == network.throats.size(), "one flux a throat");
    const Vec3 sum = parallel_sum(flux.size(), block, Vec3{}, [&](std::size_t begin, std::size_t end) {
        Vec3 part;
        for (std::size_t t = begin; t < end; ++t) {
            part += flux[t] * across(network, t);
        }
        return part;
    });
    return sum / determinant(network.h);
}

void scale(FlowField& field, double factor) {
    for (std::vector<double>* const column : {&field.pressure, &field.flux}) {
        parallel_for(column->size(), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                (*column)[i] *= factor;
            }
        });
    }
    field.net_outflow *= std::abs(factor);
}

} // namespace suffuse::flow
