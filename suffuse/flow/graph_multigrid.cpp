#include "suffuse/flow/graph_multigrid.hpp"

#include "suffuse/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::size_t dense_size = 48; // nodes for which a dense factor is cheaper than another level

double product(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

/// x += s * y
void add(double s, std::span<const double> y, std::span<double> x) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] += s * y[i];
    }
}

/// Gauss-Seidel from x = 0, first node first.
void sweep_up(const WeightedGraph& graph, std::span<const double> b, std::span<double> x) {
    for (std::size_t i = 0; i < graph.size(); ++i) {
        double sum = b[i];
        for (std::uint32_t k = graph.first[i]; k < graph.middle[i]; ++k) {
            sum += graph.weight[k] * x[graph.neighbor[k]];
        }
        x[i] = sum * graph.inverse_sum[i];
    }
}

/// Gauss-Seidel, last node first.
void sweep_down(const WeightedGraph& graph, std::span<const double> b, std::span<double> x) {
    for (std::size_t i = graph.size(); i-- > 0;) {
        double sum = b[i];
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
            sum += graph.weight[k] * x[graph.neighbor[k]];
        }
        x[i] = sum * graph.inverse_sum[i];
    }
}

} // namespace

struct GraphMultigrid::Work {
    explicit Work(std::size_t n) : b(n), x(n), r(n), c1(n), v1(n), c2(n), v2(n) {}

    std::vector<double> b, x, r, c1, v1, c2, v2;
};

GraphMultigrid::GraphMultigrid(const WeightedGraph& graph) {
    levels_.push_back({grounded(graph), {}});
    while (levels_.back().graph.size() > dense_size) {
        Level& fine = levels_.back();
        Grouping grouping = join_pairs(fine.graph);
        WeightedGraph next = contracted(fine.graph, grouping);
        if (next.size() == fine.graph.size()) {
            break;
        } // isolated nodes only
        fine.coarse = std::move(grouping.group);
        levels_.push_back({std::move(next), {}});
    }
    if (levels_.back().graph.size() <= dense_size) {
        factor_last();
    }
}

double GraphMultigrid::complexity() const {
    const auto stored = [](const Level& level) {
        return static_cast<double>(level.graph.neighbor.size() + level.graph.size());
    };
    double sum = 0;
    for (const Level& level : levels_) {
        sum += stored(level);
    }
    return sum / stored(levels_.front());
}

void GraphMultigrid::factor_last() {
    const WeightedGraph& graph = levels_.back().graph;
    const std::size_t n = graph.size();
    factor_.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        factor_[i * n + i] = graph.sum[i];
        for (std::uint32_t k = graph.first[i]; k < graph.middle[i]; ++k) {
            factor_[i * n + graph.neighbor[k]] = -graph.weight[k];
        }
        for (std::size_t j = 0; j <= i; ++j) {
            double value = factor_[i * n + j];
            for (std::size_t k = 0; k < j; ++k) {
                value -= factor_[i * n + k] * factor_[j * n + k];
            }
            const double pivot = factor_[j * n + j];
            if (j < i) {
                factor_[i * n + j] = pivot > 0 ? value / pivot : 0;
            } else {
                factor_[i * n + j] = value > 0 ? std::sqrt(value) : 0; // 0: a node alone
            }
        }
    }
}

void GraphMultigrid::solve_last(std::span<const double> b, std::span<double> x) const {
    const std::size_t n = x.size();
    if (factor_.empty()) { // isolated nodes
        std::fill(x.begin(), x.end(), 0.0);
        return;
    }
    for (std::size_t i = 0; i < n; ++i) {
        double value = b[i];
        for (std::size_t k = 0; k < i; ++k) {
            value -= factor_[i * n + k] * x[k];
        }
        x[i] = factor_[i * n + i] > 0 ? value / factor_[i * n + i] : 0;
    }
    for (std::size_t i = n; i-- > 0;) {
        double value = x[i];
        for (std::size_t k = i + 1; k < n; ++k) {
            value -= factor_[k * n + i] * x[k];
        }
        x[i] = factor_[i * n + i] > 0 ? value / factor_[i * n + i] : 0;
    }
}

/// One cycle on level l from x = 0: smooth, correct by the smaller graph, smooth.
void GraphMultigrid::cycle(std::size_t l, std::span<const double> b, std::span<double> x, std::vector<Work>& work)
    const {
    const Level& level = levels_[l];
    if (l + 1 == levels_.size()) {
        return solve_last(b, x);
    }
    sweep_up(level.graph, b, x);
    Work& next = work[l + 1];
    std::fill(next.b.begin(), next.b.end(), 0.0);
    for (std::size_t i = 0; i < x.size(); ++i) { // after the sweep only the couplings to later nodes are out of balance
        double residual = 0;
        for (std::uint32_t k = level.graph.middle[i]; k < level.graph.first[i + 1]; ++k) {
            residual += level.graph.weight[k] * x[level.graph.neighbor[k]];
        }
        next.b[level.coarse[i]] += residual;
    }
    solve_coarse(l + 1, work);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] += next.x[level.coarse[i]];
    }
    sweep_down(level.graph, b, x);
}

/// Solves level l for work[l].b into work[l].x, roughly: two steps of conjugate gradients, each a cycle, on every other
/// level, one step on those between. (Two steps on all levels cost more than they save.)
void GraphMultigrid::solve_coarse(std::size_t l, std::vector<Work>& work) const {
    Work& w = work[l];
    if (l + 1 == levels_.size()) {
        return solve_last(w.b, w.x);
    }
    const WeightedGraph& graph = levels_[l].graph;
    cycle(l, w.b, w.c1, work);
    multiply(graph, w.c1, w.v1);
    const double rho1 = product(w.c1, w.v1);
    std::fill(w.x.begin(), w.x.end(), 0.0);
    if (!(rho1 > 0)) {
        return;
    }
    const double alpha1 = product(w.c1, w.b);
    add(alpha1 / rho1, w.c1, w.x);
    if (l % 2 == 1) {
        return;
    }
    w.r = w.b;
    add(-alpha1 / rho1, w.v1, w.r);
    cycle(l, w.r, w.c2, work);
    multiply(graph, w.c2, w.v2);
    const double gamma = product(w.c2, w.v1), alpha2 = product(w.c2, w.r);
    const double rho2 = product(w.c2, w.v2) - gamma * gamma / rho1;
    if (!(rho2 > 0)) {
        return;
    }
    add(-gamma * alpha2 / (rho1 * rho2), w.c1, w.x);
    add(alpha2 / rho2, w.c2, w.x);
}

double GraphMultigrid::size(std::span<const double> b) const {
    double sum = 0;
    for (std::size_t i = 0; i < graph().size(); ++i) {
        sum += b[i] * b[i] * graph().inverse_sum[i];
    }
    return std::sqrt(sum);
}

GraphMultigrid::Result GraphMultigrid::solve(std::span<const double> b, double wanted, int iteration_limit) const {
    const std::size_t n = graph().size();
    expects(b.size() == n, "one source a node");
    Result result{std::vector<double>(n, 0.0), 0, size(b)};
    std::vector<Work> work;
    for (const Level& level : levels_) {
        work.emplace_back(level.graph.size());
    }
    std::vector<double> residual(b.begin(), b.end()), direction(n, 0.0), image(n), correction(n), previous(n, 0.0);
    double before = 1;
    for (; result.imbalance > wanted && result.iterations < iteration_limit; ++result.iterations) {
        cycle(0, residual, correction, work);
        // The cycle is not quite the same map each time: the flexible form of conjugate gradients subtracts its change.
        const double now = product(correction, residual);
        const double beta = result.iterations == 0 ? 0 : (now - product(correction, previous)) / before;
        for (std::size_t i = 0; i < n; ++i) {
            direction[i] = correction[i] + beta * direction[i];
        }
        multiply(graph(), direction, image);
        const double curvature = product(direction, image);
        if (!(curvature > 0)) {
            break;
        }
        const double step = product(direction, residual) / curvature;
        previous = residual;
        add(step, direction, result.x);
        add(-step, image, residual);
        before = now;
        result.imbalance = size(residual);
    }
    return result;
}

} // namespace suffuse::flow
