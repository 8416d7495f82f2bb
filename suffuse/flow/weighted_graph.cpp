#include "suffuse/flow/weighted_graph.hpp"

#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
// Share of its strongest coupling that a node needs to a free partner. Measured on packings of sand: 0.25 takes a third
// more iterations, 1 needs larger graphs.
constexpr double worth_joining = 0.8;

constexpr std::size_t block = 1024; // nodes of one loop of a thread

/// Couplings of a run of nodes, one node after the other.
struct Run {
    std::vector<std::uint32_t> neighbor;
    std::vector<double> weight;
};

/// Appends the row of node i, sorted, entries of one neighbor added up. Where it ends counts from the begin of the run.
void append(std::uint32_t i, GraphRow& row, Run& run, WeightedGraph& graph) {
    std::erase_if(row, [i](const auto& entry) { return entry.first == i || !(entry.second > 0); });
    std::sort(row.begin(), row.end());
    const std::size_t begin = run.neighbor.size();
    double sum = graph.ground[i];
    for (const auto& [neighbor, weight] : row) {
        sum += weight;
        if (run.neighbor.size() > begin && run.neighbor.back() == neighbor) {
            run.weight.back() += weight;
            continue;
        }
        run.neighbor.push_back(neighbor);
        run.weight.push_back(weight);
    }
    const auto middle =
        std::lower_bound(run.neighbor.begin() + static_cast<std::ptrdiff_t>(begin), run.neighbor.end(), i);
    graph.middle[i] = static_cast<std::uint32_t>(middle - run.neighbor.begin());
    graph.first[i + 1] = static_cast<std::uint32_t>(run.neighbor.size());
    graph.sum[i] = sum;
    graph.inverse_sum[i] = sum > 0 ? 1 / sum : 0;
}

/// Puts the runs of `block` nodes one after the other.
void join_runs(const std::vector<Run>& runs, WeightedGraph& graph) {
    std::vector<std::uint32_t> begin(runs.size() + 1, 0);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        begin[r + 1] = begin[r] + static_cast<std::uint32_t>(runs[r].neighbor.size());
    }
    resize_columns(begin.back(), graph.neighbor, graph.weight);
    parallel_for(graph.size(), block, [&](std::size_t first, std::size_t last) {
        const std::size_t r = first / block;
        for (std::size_t i = first; i < last; ++i) {
            graph.middle[i] += begin[r];
            graph.first[i + 1] += begin[r];
        }
        std::copy(runs[r].neighbor.begin(), runs[r].neighbor.end(), graph.neighbor.begin() + begin[r]);
        std::copy(runs[r].weight.begin(), runs[r].weight.end(), graph.weight.begin() + begin[r]);
    });
}

/// The lowest node of each connected part.
std::vector<std::uint8_t> lowest_of_parts(const WeightedGraph& graph) {
    std::vector<std::uint8_t> is_reached(graph.size(), 0), is_lowest(graph.size(), 0);
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t start = 0; start < graph.size(); ++start) {
        if (is_reached[start] != 0) {
            continue;
        }
        is_reached[start] = is_lowest[start] = 1;
        waiting.push_back(start);
        while (!waiting.empty()) {
            const std::uint32_t i = waiting.back();
            waiting.pop_back();
            for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
                if (is_reached[graph.neighbor[k]] != 0) {
                    continue;
                }
                is_reached[graph.neighbor[k]] = 1;
                waiting.push_back(graph.neighbor[k]);
            }
        }
    }
    return is_lowest;
}

} // namespace

WeightedGraph make_graph(std::vector<double> ground, const std::function<void(std::uint32_t, GraphRow&)>& gather) {
    WeightedGraph graph;
    graph.ground = std::move(ground);
    const std::size_t nodes = graph.ground.size();
    graph.first.assign(nodes + 1, 0);
    resize_columns(nodes, graph.middle, graph.sum, graph.inverse_sum);
    std::vector<Run> runs((nodes + block - 1) / block);
    parallel_for(nodes, block, [&](std::size_t first, std::size_t last) {
        GraphRow row;
        for (std::size_t i = first; i < last; ++i) {
            row.clear();
            gather(static_cast<std::uint32_t>(i), row);
            append(static_cast<std::uint32_t>(i), row, runs[first / block], graph);
        }
    });
    join_runs(runs, graph);
    return graph;
}

WeightedGraph grounded(WeightedGraph graph) {
    const std::vector<std::uint8_t> is_ground = lowest_of_parts(graph);
    std::uint32_t read = 0, write = 0;
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        const std::uint32_t begin = write;
        graph.middle[i] = begin;
        for (const std::uint32_t end = graph.first[i + 1]; read < end; ++read) {
            const std::uint32_t j = graph.neighbor[read];
            if (is_ground[i] != 0) {
                continue;
            }
            if (is_ground[j] != 0) {
                graph.ground[i] += graph.weight[read];
                continue;
            }
            graph.neighbor[write] = j;
            graph.weight[write++] = graph.weight[read];
            graph.middle[i] = j < i ? write : graph.middle[i];
        }
        graph.first[i + 1] = write;
        graph.sum[i] = std::accumulate(graph.weight.begin() + begin, graph.weight.begin() + write, graph.ground[i]);
        graph.inverse_sum[i] = graph.sum[i] > 0 ? 1 / graph.sum[i] : 0;
    }
    graph.neighbor.resize(write), graph.weight.resize(write);
    return graph;
}

Grouping join_pairs(const WeightedGraph& graph) {
    Grouping result{std::vector<std::uint32_t>(graph.size(), none), 0};
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        if (result.group[i] != none) {
            continue;
        }
        double strongest = 0, strongest_free = 0;
        std::uint32_t taken = none, free = none;
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
            const std::uint32_t j = graph.neighbor[k];
            const bool is_free = result.group[j] == none;
            if (graph.weight[k] > strongest) {
                strongest = graph.weight[k], taken = is_free ? none : j;
            }
            if (is_free && graph.weight[k] > strongest_free) {
                strongest_free = graph.weight[k], free = j;
            }
        }
        if (taken != none && strongest_free < worth_joining * strongest) {
            result.group[i] = result.group[taken];
            continue;
        }
        result.group[i] = result.groups;
        if (free != none) {
            result.group[free] = result.groups;
        }
        ++result.groups;
    }
    return result;
}

WeightedGraph contracted(const WeightedGraph& graph, const Grouping& grouping) {
    const std::vector<std::uint32_t>& group = grouping.group;
    const Members members = members_of(graph.size(), grouping.groups, [&](std::size_t i) { return group[i]; });
    std::vector<double> ground(grouping.groups, 0.0);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        ground[group[i]] += graph.ground[i];
    }
    return make_graph(std::move(ground), [&](std::uint32_t g, GraphRow& row) {
        for (const std::uint32_t i : members.of(g)) {
            for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
                row.emplace_back(group[graph.neighbor[k]], graph.weight[k]);
            }
        }
    });
}

void multiply(const WeightedGraph& graph, std::span<const double> x, std::span<double> y) {
    multiply(graph, x, y, 0, graph.size());
}

void multiply(
    const WeightedGraph& graph, std::span<const double> x, std::span<double> y, std::size_t begin, std::size_t end
) {
    for (std::size_t i = begin; i < end; ++i) {
        // By differences: between nodes whose pore centers almost coincide a small number times a huge weight.
        double sum = graph.ground[i] * x[i];
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
            sum += graph.weight[k] * (x[i] - x[graph.neighbor[k]]);
        }
        y[i] = sum;
    }
}

} // namespace suffuse::flow
