#include "suffuse/flow/weighted_graph.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
// Share of its strongest coupling that a node asks of a free partner. Measured on packings of sand: 0.25 takes a third
// more iterations, 1 needs larger graphs.
constexpr double worth_joining = 0.8;

/// Sorts every row and adds up entries of one neighbor; `end[i]` is where row i ends as filled.
void tidy_rows(WeightedGraph& graph, std::span<const std::uint32_t> end) {
    const std::size_t nodes = end.size();
    graph.middle.resize(nodes), graph.sum.resize(nodes), graph.inverse_sum.resize(nodes);
    std::vector<std::pair<std::uint32_t, double>> row;
    std::uint32_t write = 0;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        row.clear();
        for (std::uint32_t k = graph.first[i]; k < end[i]; ++k) {
            row.emplace_back(graph.neighbor[k], graph.weight[k]);
        }
        std::sort(row.begin(), row.end());
        graph.first[i] = graph.middle[i] = write;
        double sum = graph.ground[i];
        for (std::size_t k = 0; k < row.size(); ++k) {
            sum += row[k].second;
            if (k > 0 && row[k].first == row[k - 1].first) {
                graph.weight[write - 1] += row[k].second;
                continue;
            }
            graph.neighbor[write] = row[k].first;
            graph.weight[write++] = row[k].second;
            if (row[k].first < i) {
                graph.middle[i] = write;
            }
        }
        graph.sum[i] = sum;
        graph.inverse_sum[i] = sum > 0 ? 1 / sum : 0;
    }
    graph.first[nodes] = write;
    graph.neighbor.resize(write), graph.weight.resize(write);
    graph.neighbor.shrink_to_fit(), graph.weight.shrink_to_fit();
}

} // namespace

namespace {

WeightedGraph make_graph(std::span<const GraphEdge> edges, std::vector<double> ground) {
    const auto counts = [](const GraphEdge& e) { return e.i != e.j && e.weight > 0; };
    const std::size_t nodes = ground.size();
    WeightedGraph graph;
    graph.ground = std::move(ground);
    graph.first.assign(nodes + 1, 0);
    for (const GraphEdge& e : edges) {
        if (!counts(e)) {
            continue;
        }
        ++graph.first[e.i + 1];
        ++graph.first[e.j + 1];
    }
    for (std::size_t i = 0; i < nodes; ++i) {
        graph.first[i + 1] += graph.first[i];
    }
    graph.neighbor.resize(graph.first[nodes]), graph.weight.resize(graph.first[nodes]);
    std::vector<std::uint32_t> end(graph.first.begin(), graph.first.end() - 1);
    for (const GraphEdge& e : edges) {
        if (!counts(e)) {
            continue;
        }
        graph.neighbor[end[e.i]] = e.j, graph.weight[end[e.i]++] = e.weight;
        graph.neighbor[end[e.j]] = e.i, graph.weight[end[e.j]++] = e.weight;
    }
    tidy_rows(graph, end);
    return graph;
}

} // namespace

WeightedGraph make_graph(std::size_t nodes, std::span<const GraphEdge> edges) {
    return make_graph(edges, std::vector<double>(nodes, 0.0));
}

WeightedGraph grounded(const WeightedGraph& graph) {
    std::vector<std::uint8_t> is_reached(graph.size(), 0), is_ground(graph.size(), 0);
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t start = 0; start < graph.size(); ++start) {
        if (is_reached[start] != 0) {
            continue;
        }
        is_reached[start] = is_ground[start] = 1;
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
    std::vector<GraphEdge> edges;
    edges.reserve(graph.neighbor.size() / 2);
    std::vector<double> ground = graph.ground;
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        for (std::uint32_t k = graph.first[i]; k < graph.middle[i]; ++k) {
            const std::uint32_t j = graph.neighbor[k];
            if (is_ground[i] != 0) {
                ground[j] += graph.weight[k];
            } else if (is_ground[j] != 0) {
                ground[i] += graph.weight[k];
            } else {
                edges.push_back({i, j, graph.weight[k]});
            }
        }
    }
    return make_graph(edges, std::move(ground));
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
    std::vector<GraphEdge> edges;
    edges.reserve(graph.neighbor.size() / 2);
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        for (std::uint32_t k = graph.first[i]; k < graph.middle[i]; ++k) {
            const std::uint32_t a = grouping.group[i], b = grouping.group[graph.neighbor[k]];
            if (a != b) {
                edges.push_back({a, b, graph.weight[k]});
            }
        }
    }
    std::vector<double> ground(grouping.groups, 0.0);
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        ground[grouping.group[i]] += graph.ground[i];
    }
    return make_graph(edges, std::move(ground));
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
