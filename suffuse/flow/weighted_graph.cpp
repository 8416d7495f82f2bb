#include "suffuse/flow/weighted_graph.hpp"

#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/prefix_sum.hpp"

#include <algorithm>
#include <atomic>
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
    graph.first[i + 1] = static_cast<std::uint32_t>(run.neighbor.size());
    graph.sum[i] = sum;
}

/// Puts the runs of `block` nodes one after the other.
void join_runs(std::vector<Run>& runs, WeightedGraph& graph) {
    std::vector<std::uint32_t> begin(runs.size() + 1, 0);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        begin[r + 1] = begin[r] + static_cast<std::uint32_t>(runs[r].neighbor.size());
    }
    graph.neighbor.resize(begin.back()), graph.weight.resize(begin.back());
    parallel_for(graph.size(), block, [&](std::size_t first, std::size_t last) {
        const std::size_t r = first / block;
        for (std::size_t i = first; i < last; ++i) {
            graph.first[i + 1] += begin[r];
        }
        const Run run = std::move(runs[r]); // done with
        std::copy(run.neighbor.begin(), run.neighbor.end(), graph.neighbor.begin() + begin[r]);
        std::copy(run.weight.begin(), run.weight.end(), graph.weight.begin() + begin[r]);
    });
}

/// For each node a lower one of the same connected part, or the node itself where it is the lowest. Threads hang the
/// higher end of two such ways below the lower one: in whatever order they come, all ways of a part end at its lowest
/// node.
class ConnectedParts {
public:
    explicit ConnectedParts(std::size_t nodes) : lower_(nodes) {
        parallel_for(nodes, block, [&](std::size_t begin, std::size_t end) {
            std::iota(
                lower_.begin() + static_cast<std::ptrdiff_t>(begin), lower_.begin() + static_cast<std::ptrdiff_t>(end),
                static_cast<std::uint32_t>(begin)
            );
        });
    }

    void join(std::uint32_t i, std::uint32_t j) {
        for (;;) {
            i = lowest(i), j = lowest(j);
            if (i == j) {
                return;
            }
            std::uint32_t high = std::max(i, j);
            if (std::atomic_ref(lower_[high])
                    .compare_exchange_strong(high, std::min(i, j), std::memory_order_relaxed)) {
                return;
            }
        }
    }

    [[nodiscard]] bool is_lowest(std::uint32_t i) const { return lower_[i] == i; }

private:
    /// The end of the way, which is made shorter as it is gone.
    std::uint32_t lowest(std::uint32_t i) {
        for (;;) {
            const std::uint32_t next = std::atomic_ref(lower_[i]).load(std::memory_order_relaxed);
            if (next == i) {
                return i;
            }
            const std::uint32_t after = std::atomic_ref(lower_[next]).load(std::memory_order_relaxed);
            std::atomic_ref(lower_[i]).store(after, std::memory_order_relaxed);
            i = after;
        }
    }

    RawColumn<std::uint32_t> lower_;
};

ConnectedParts find_parts(const WeightedGraph& graph) {
    ConnectedParts parts(graph.size());
    parallel_for(graph.size(), block, [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1] && graph.neighbor[k] < i; ++k) {
                parts.join(i, graph.neighbor[k]);
            }
        }
    });
    return parts;
}

/// Lets node i, which is free, choose among its neighbors in [begin, end). Where the strongest of all is not among them
/// it stays free. `leader`: the node that opened the group of each, or none.
void choose_partner(
    const WeightedGraph& graph, std::uint32_t i, std::size_t begin, std::size_t end, std::span<std::uint32_t> leader
) {
    const auto is_here = [&](std::uint32_t j) { return begin <= j && j < end; };
    double strongest = 0, strongest_free = 0;
    std::uint32_t nearest = none, free = none;
    for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
        const std::uint32_t j = graph.neighbor[k];
        if (graph.weight[k] > strongest) {
            strongest = graph.weight[k], nearest = j;
        }
        if (graph.weight[k] > strongest_free && is_here(j) && leader[j] == none) {
            strongest_free = graph.weight[k], free = j;
        }
    }
    if (nearest != none && !is_here(nearest)) {
        return;
    }
    if (nearest != none && leader[nearest] != none && strongest_free < worth_joining * strongest) {
        leader[i] = leader[nearest];
        return;
    }
    leader[i] = i;
    if (free != none) {
        leader[free] = i;
    }
}

/// The leader of each node's group.
RawColumn<std::uint32_t> choose_leaders(const WeightedGraph& graph) {
    RawColumn<std::uint32_t> leader(graph.size());
    std::vector<std::vector<std::uint32_t>> waiting((graph.size() + nodes_together - 1) / nodes_together);
    parallel_for(graph.size(), nodes_together, [&](std::size_t begin, std::size_t end) {
        std::fill(
            leader.begin() + static_cast<std::ptrdiff_t>(begin), leader.begin() + static_cast<std::ptrdiff_t>(end), none
        );
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            if (leader[i] == none) {
                choose_partner(graph, i, begin, end, leader);
            }
            if (leader[i] == none) {
                waiting[begin / nodes_together].push_back(i);
            }
        }
    });
    for (const std::vector<std::uint32_t>& some : waiting) {
        for (const std::uint32_t i : some) {
            if (leader[i] == none) { // nor taken by another since
                choose_partner(graph, i, 0, graph.size(), leader);
            }
        }
    }
    return leader;
}

} // namespace

WeightedGraph make_graph(std::size_t nodes, const std::function<double(std::uint32_t, GraphRow&)>& gather) {
    WeightedGraph graph;
    graph.first.resize(nodes + 1), graph.ground.resize(nodes), graph.sum.resize(nodes);
    graph.first[0] = 0;
    std::vector<Run> runs((nodes + block - 1) / block);
    parallel_for(nodes, block, [&](std::size_t first, std::size_t last) {
        GraphRow row;
        for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
            row.clear();
            graph.ground[i] = gather(i, row);
            append(i, row, runs[first / block], graph);
        }
    });
    join_runs(runs, graph);
    return graph;
}

WeightedGraph grounded(const WeightedGraph& graph) {
    const ConnectedParts parts = find_parts(graph);
    return make_graph(graph.size(), [&](std::uint32_t i, GraphRow& row) {
        double ground = graph.ground[i];
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1] && !parts.is_lowest(i); ++k) {
            if (parts.is_lowest(graph.neighbor[k])) {
                ground += graph.weight[k];
            } else {
                row.emplace_back(graph.neighbor[k], graph.weight[k]);
            }
        }
        return ground;
    });
}

Grouping join_pairs(const WeightedGraph& graph) {
    Grouping result{choose_leaders(graph), 0};
    std::vector<std::uint32_t> leaders((graph.size() + block - 1) / block, 0); // of each block
    const auto for_leaders = [&](auto&& body) {
        parallel_for(graph.size(), block, [&](std::size_t begin, std::size_t end) {
            for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                if (result.group[i] == i) {
                    body(i, leaders[begin / block]);
                }
            }
        });
    };
    for_leaders([](std::uint32_t, std::uint32_t& count) { ++count; });
    result.groups = sum_before(std::span(leaders));
    RawColumn<std::uint32_t> number(graph.size());
    for_leaders([&](std::uint32_t i, std::uint32_t& next) { number[i] = next++; });
    parallel_for(graph.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            result.group[i] = number[result.group[i]];
        }
    });
    return result;
}

WeightedGraph contracted(const WeightedGraph& graph, const Grouping& grouping) {
    const RawColumn<std::uint32_t>& group = grouping.group;
    const Members members = members_of(graph.size(), grouping.groups, [&](std::size_t i) { return group[i]; });
    return make_graph(grouping.groups, [&](std::uint32_t g, GraphRow& row) {
        double ground = 0;
        for (const std::uint32_t i : members.of(g)) {
            ground += graph.ground[i];
            for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
                row.emplace_back(group[graph.neighbor[k]], graph.weight[k]);
            }
        }
        return ground;
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
