#include "suffuse/flow/aggregation_cycle.hpp"

#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/prefix_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::size_t dense_size = 48; // nodes for which a dense factor is cheaper than another level
constexpr std::size_t block = 512;     // rows of one loop of a thread

/// Rows that a column of `nodes` needs so that one at least is free.
std::size_t with_filler(std::size_t nodes) {
    return (nodes / lanes + 1) * lanes;
}

/// x = from + s * y
void add(std::span<const float> from, double s, std::span<const float> y, std::span<float> x) {
    const auto factor = static_cast<float>(s);
    parallel_for(x.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            x[i] = from[i] + factor * y[i];
        }
    });
}

/// x = s * y
void set(double s, std::span<const float> y, std::span<float> x) {
    const auto factor = static_cast<float>(s);
    parallel_for(x.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            x[i] = factor * y[i];
        }
    });
}

void set_zero(std::span<float> x) {
    parallel_for(x.size(), block, [&](std::size_t begin, std::size_t end) {
        std::fill(x.data() + begin, x.data() + end, 0.0F);
    });
}

/// Steps on a level that corrects another: two on every other level, one on those between. (Two on all levels cost more
/// than they save.)
bool takes_two_steps(std::size_t l) {
    return l % 2 == 0;
}

/// Which rows of the finer level belong to each of `rows` rows of the coarser one; rows that fill up belong to its
/// last.
LaneRows members_of(std::span<const std::uint32_t> coarse, std::size_t rows) {
    const Members of_row = suffuse::members_of(coarse.size(), rows, [&](std::size_t r) { return coarse[r]; });
    const auto count = [&](std::size_t c) { return c + 1 == rows ? 0 : of_row.of(c).size(); };
    LaneRows members;
    members.first.assign(rows / lanes + 1, 0);
    parallel_for(rows / lanes, block / lanes, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin * lanes; c < end * lanes; ++c) {
            std::uint32_t& most = members.first[c / lanes];
            most = std::max(most, static_cast<std::uint32_t>(count(c)));
        }
    });
    members.column.resize(sum_before(std::span(members.first)) * lanes);
    parallel_for(rows / lanes, block / lanes, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin * lanes; c < end * lanes; ++c) {
            std::size_t k = 0;
            for (std::size_t s = members.first[c / lanes]; s < members.first[c / lanes + 1]; ++s, ++k) {
                members.column[s * lanes + c % lanes] =
                    k < count(c) ? of_row.of(c)[k] : static_cast<std::uint32_t>(coarse.size() - 1);
            }
        }
    });
    return members;
}

/// Sums over the members of each coarse row.
void restrict_to(const LaneRows& members, std::span<const float> x, std::span<float> coarse) {
    parallel_for(coarse.size() / lanes, block / lanes, [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) {
            std::array<float, lanes> sum{};
            for (std::size_t s = members.first[q] * lanes; s < members.first[q + 1] * lanes; s += lanes) {
                for (std::size_t l = 0; l < lanes; ++l) {
                    sum[l] += x[members.column[s + l]];
                }
            }
            std::copy(sum.begin(), sum.end(), coarse.begin() + static_cast<std::ptrdiff_t>(q * lanes));
        }
    });
}

double stored(const WeightedGraph& graph) {
    return static_cast<double>(graph.neighbor.size() + graph.size());
}

} // namespace

AggregationCycle::AggregationCycle(const WeightedGraph& graph) {
    WeightedGraph coarser;
    const WeightedGraph* current = &graph;
    std::vector<RawColumn<std::uint32_t>> group; // of each node of each level
    double all = stored(graph);
    while (current->size() > dense_size) {
        Grouping grouping = join_pairs(*current);
        WeightedGraph next = contracted(*current, grouping);
        if (next.size() == current->size()) {
            break;
        } // isolated nodes only
        levels_.push_back({color_graph(*current), {}, {}});
        group.push_back(std::move(grouping.group));
        coarser = std::move(next);
        current = &coarser;
        all += stored(coarser);
    }
    complexity_ = all / stored(graph);
    last_nodes_ = current->size();
    if (last_nodes_ <= dense_size) {
        factor(*current);
    }
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        link(l, group[l]);
        group[l] = RawColumn<std::uint32_t>();
    }
}

/// Assigns the rows of level l those of the next they belong to, and these the reverse. `group`: of each node of level
/// l.
void AggregationCycle::link(std::size_t l, std::span<const std::uint32_t> group) {
    Level& level = levels_[l];
    const bool is_last = l + 1 == levels_.size();
    const std::size_t rows = level.graph.rows();
    level.coarse.resize(rows);
    parallel_for(rows, block, [&](std::size_t begin, std::size_t end) {
        std::fill(
            level.coarse.begin() + static_cast<std::ptrdiff_t>(begin),
            level.coarse.begin() + static_cast<std::ptrdiff_t>(end), static_cast<std::uint32_t>(this->rows(l + 1) - 1)
        );
    });
    parallel_for(group.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            level.coarse[level.graph.row[i]] = is_last ? group[i] : levels_[l + 1].graph.row[group[i]];
        }
    });
    level.members = members_of(level.coarse, this->rows(l + 1));
}

std::size_t AggregationCycle::rows(std::size_t l) const {
    return l < levels_.size() ? levels_[l].graph.rows() : with_filler(last_nodes_);
}

void AggregationCycle::factor(const WeightedGraph& graph) {
    const std::size_t n = graph.size();
    factor_.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        factor_[i * n + i] = graph.sum[i];
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1] && graph.neighbor[k] < i; ++k) {
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

void AggregationCycle::solve_last(std::span<const float> b, std::span<float> x) const {
    const std::size_t n = last_nodes_;
    std::fill(x.begin(), x.end(), 0.0F);
    if (factor_.empty()) { // isolated nodes
        return;
    }
    std::array<double, dense_size> y{};
    for (std::size_t i = 0; i < n; ++i) {
        double value = static_cast<double>(b[i]);
        for (std::size_t k = 0; k < i; ++k) {
            value -= factor_[i * n + k] * y[k];
        }
        y[i] = factor_[i * n + i] > 0 ? value / factor_[i * n + i] : 0;
    }
    for (std::size_t i = n; i-- > 0;) {
        double value = y[i];
        for (std::size_t k = i + 1; k < n; ++k) {
            value -= factor_[k * n + i] * y[k];
        }
        y[i] = factor_[i * n + i] > 0 ? value / factor_[i * n + i] : 0;
        x[i] = static_cast<float>(y[i]);
    }
}

/// One cycle on level l from x = 0: smooth, correct by the smaller graph, smooth.
void AggregationCycle::cycle(std::size_t l, std::span<const float> b, std::span<float> x, std::vector<Work>& work)
    const {
    if (l == levels_.size()) {
        return solve_last(b, x);
    }
    const Level& level = levels_[l];
    Work &here = work[l], &next = work[l + 1];
    sweep_up(level.graph, b, x);
    residual_after_sweep(level.graph, x, here.v2);
    restrict_to(level.members, here.v2, next.b);
    solve_coarse(l + 1, work);
    parallel_for(x.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            x[i] += next.x[level.coarse[i]];
        }
    });
    sweep_down(level.graph, b, x);
}

/// Solves level l for work[l].b into work[l].x, roughly: one step of conjugate gradients, which is a cycle, or two.
void AggregationCycle::solve_coarse(std::size_t l, std::vector<Work>& work) const {
    Work& w = work[l];
    if (l == levels_.size()) {
        return solve_last(w.b, w.x);
    }
    const ColoredGraph& graph = levels_[l].graph;
    cycle(l, w.b, w.c1, work);
    const Products first = multiply(graph, w.c1, w.b, w.b, w.v1);
    if (!(first.xy > 0)) {
        return set_zero(w.x);
    }
    const double rho1 = first.xy, alpha1 = first.xb;
    set(alpha1 / rho1, w.c1, w.x);
    if (!takes_two_steps(l)) {
        return;
    }
    add(w.b, -alpha1 / rho1, w.v1, w.r);
    cycle(l, w.r, w.c2, work);
    const Products second = multiply(graph, w.c2, w.r, w.c1, w.v2);
    const double gamma = second.yc, alpha2 = second.xb;
    const double rho2 = second.xy - gamma * gamma / rho1;
    if (!(rho2 > 0)) {
        return;
    }
    add(w.x, -gamma * alpha2 / (rho1 * rho2), w.c1, w.x);
    add(w.x, alpha2 / rho2, w.c2, w.x);
}

AggregationCycle::Columns AggregationCycle::columns() const {
    Columns result;
    for (std::size_t l = 0; l <= levels_.size(); ++l) {
        Work& work = result.levels.emplace_back();
        const auto open = [&](RawColumn<float>& column) {
            column.resize(rows(l));
            set_zero(column);
        };
        open(work.b), open(work.x), open(work.v2);
        if (l > 0 && l < levels_.size()) {
            open(work.c1), open(work.v1);
            if (takes_two_steps(l)) {
                open(work.r), open(work.c2);
            }
        }
    }
    return result;
}

void AggregationCycle::apply(Columns& columns) const {
    cycle(0, columns.levels[0].b, columns.levels[0].x, columns.levels);
}

} // namespace suffuse::flow
