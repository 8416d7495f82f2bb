#include "suffuse/flow/pressure.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

WeightedGraph graph_of(const pores::PoreNetwork& network, std::span<const double> conductance, double unit) {
    std::vector<GraphEdge> edges;
    edges.reserve(conductance.size());
    for (std::size_t t = 0; t < conductance.size(); ++t) {
        const auto [p, q] = network.throats.side[t];
        edges.push_back({network.pores.body[p], network.pores.body[q], conductance[t] / unit});
    }
    return make_graph(network.bodies, edges);
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
            "asked; look for throats whose conductances differ by more than twelve orders of magnitude",
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
      multigrid_(graph_of(network, conductance, unit_)) {
    expects(conductance.size() == network.throats.size(), "one conductance a throat");
}

PressureSolver::Source PressureSolver::source(const Vec3& gradient) const {
    Source source{std::vector<double>(network_.bodies, 0.0), std::vector<double>(network_.bodies, 0.0)};
    for (std::size_t t = 0; t < network_.throats.size(); ++t) {
        const std::uint32_t a = network_.pores.body[network_.throats.side[t][0]];
        const std::uint32_t b = network_.pores.body[network_.throats.side[t][1]];
        const double flux = conductance_[t] / unit_ * dot(gradient, across(network_, t));
        source.net[a] += flux;
        source.net[b] -= flux;
        source.all[a] += std::abs(flux);
        source.all[b] += std::abs(flux);
    }
    return source;
}

FlowField PressureSolver::solve(const Vec3& gradient) const {
    // Unknown is the deviation from the mean gradient: periodic, and zero in a perfect lattice. Convergence is measured
    // against the fluxes themselves, because their net may be nothing but rounding.
    const Source source = this->source(gradient);
    const double whole = multigrid_.size(source.all);
    const GraphMultigrid::Result result = multigrid_.solve(source.net, spec_.tolerance * whole, spec_.iteration_limit);
    const pores::Pores& pores = network_.pores;
    FlowField field;
    field.iterations = result.iterations;
    field.residual = whole > 0 ? result.imbalance / whole : 0;
    check_convergence(field, spec_, pores.size());
    field.pressure.resize(pores.size());
    for (std::size_t p = 0; p < pores.size(); ++p) {
        field.pressure[p] = result.x[pores.body[p]];
    }
    const double level = mean(field.pressure);
    for (std::size_t p = 0; p < pores.size(); ++p) {
        field.pressure[p] += dot(gradient, pores.center[p]) - level;
    }
    field.flux.resize(network_.throats.size());
    std::vector<double> outflow(network_.bodies, 0.0);
    for (std::size_t t = 0; t < network_.throats.size(); ++t) {
        const std::uint32_t a = pores.body[network_.throats.side[t][0]], b = pores.body[network_.throats.side[t][1]];
        field.flux[t] = conductance_[t] * (result.x[a] - result.x[b] - dot(gradient, across(network_, t)));
        outflow[a] += field.flux[t];
        outflow[b] -= field.flux[t];
    }
    for (const double net : outflow) {
        field.net_outflow = std::max(field.net_outflow, std::abs(net));
    }
    return field;
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
    for (double& p : field.pressure) {
        p *= factor;
    }
    for (double& q : field.flux) {
        q *= factor;
    }
    field.net_outflow *= std::abs(factor);
}

} // namespace suffuse::flow
