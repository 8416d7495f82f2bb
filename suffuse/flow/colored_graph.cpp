#include "suffuse/flow/colored_graph.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace suffuse::flow {
namespace {

constexpr std::size_t block = 32;      // groups of one loop of a thread
constexpr std::size_t sum_block = 256; // groups that are summed one after the other: sums depend on it
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t stretch = 1024; // rows within which those of equal length come together

/// First color that no neighbor has, node by node.
std::vector<std::uint32_t> choose_colors(const WeightedGraph& graph) {
    std::vector<std::uint32_t> color(graph.size());
    std::vector<std::uint32_t> taken_by; // the node whose neighbor has the color
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
            if (graph.neighbor[k] < i) {
                taken_by[color[graph.neighbor[k]]] = i;
            }
        }
        std::uint32_t c = 0;
        while (c < taken_by.size() && taken_by[c] == i) {
            ++c;
        }
        if (c == taken_by.size()) {
            taken_by.push_back(0);
        }
        color[i] = c;
    }
    return color;
}

/// A row: couplings of its node to earlier colors, and all of them.
struct Row {
    std::uint32_t before = 0, all = 0, node = none;

    auto operator<=>(const Row&) const = default;
};

Row row_of(const WeightedGraph& graph, const std::vector<std::uint32_t>& color, std::uint32_t i) {
    Row row{0, graph.first[i + 1] - graph.first[i], i};
    for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
        row.before += color[graph.neighbor[k]] < color[i] ? 1 : 0;
    }
    return row;
}

/// Rows in order of colors, then nodes; each color begins a group. Within a stretch of a color rows of equal length
/// come together, so that little has to be filled up.
std::vector<Row>
number_rows(const WeightedGraph& graph, const std::vector<std::uint32_t>& color, ColoredGraph& result) {
    const std::uint32_t colors = color.empty() ? 0 : *std::max_element(color.begin(), color.end()) + 1;
    std::vector<std::uint32_t> next(colors + 1, 0);
    for (const std::uint32_t c : color) {
        ++next[c + 1];
    }
    result.color.assign(colors + 1, 0);
    for (std::uint32_t c = 0; c < colors; ++c) {
        const std::uint32_t rows = next[c + 1] + (c + 1 == colors ? 1 : 0); // the last row stays free
        result.color[c + 1] = result.color[c] + static_cast<std::uint32_t>((rows + lanes - 1) / lanes);
        next[c] = result.color[c] * lanes;
    }
    std::vector<Row> rows(result.color.back() * lanes);
    for (std::uint32_t i = 0; i < color.size(); ++i) {
        rows[next[color[i]]++].node = i;
    }
    result.row.resize(color.size());
    for (std::uint32_t c = 0; c < colors; ++c) {
        const std::size_t first = result.color[c] * lanes;
        parallel_for(next[c] - first, stretch, [&](std::size_t begin, std::size_t end) {
            for (std::size_t r = first + begin; r < first + end; ++r) {
                rows[r] = row_of(graph, color, rows[r].node);
            }
            const auto from = rows.begin() + static_cast<std::ptrdiff_t>(first);
            std::sort(from + static_cast<std::ptrdiff_t>(begin), from + static_cast<std::ptrdiff_t>(end));
            for (std::size_t r = first + begin; r < first + end; ++r) {
                result.row[rows[r].node] = static_cast<std::uint32_t>(r);
            }
        });
    }
    return rows;
}

/// Opens the rows of couplings to earlier and to later colors, all filled up.
void open_rows(const std::vector<Row>& rows, ColoredGraph& result) {
    parallel_for(2, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t side = begin; side < end; ++side) {
            LaneRows& couplings = side == 0 ? result.before : result.after;
            couplings.first.assign(rows.size() / lanes + 1, 0);
            for (std::size_t r = 0; r < rows.size(); ++r) {
                std::uint32_t& longest = couplings.first[r / lanes + 1];
                longest = std::max(longest, side == 0 ? rows[r].before : rows[r].all - rows[r].before);
            }
            std::partial_sum(couplings.first.begin(), couplings.first.end(), couplings.first.begin());
            couplings.column.assign(couplings.first.back() * lanes, static_cast<std::uint32_t>(rows.size() - 1));
            couplings.weight.assign(couplings.first.back() * lanes, 0.0F);
        }
    });
}

/// Writes the couplings of row r, whose node is `i`. Rows of one color couple to no other of it: earlier rows are of
/// earlier colors.
void fill_row(const WeightedGraph& graph, std::uint32_t i, std::size_t r, ColoredGraph& result) {
    std::size_t before = result.before.first[r / lanes] * lanes + r % lanes;
    std::size_t after = result.after.first[r / lanes] * lanes + r % lanes;
    for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
        const std::uint32_t other = result.row[graph.neighbor[k]];
        LaneRows& couplings = other < r ? result.before : result.after;
        std::size_t& place = other < r ? before : after;
        couplings.column[place] = other;
        couplings.weight[place] = static_cast<float>(graph.weight[k]);
        place += lanes;
    }
    result.inverse_sum[r] = static_cast<float>(graph.inverse_sum[i]);
    result.ground[r] = static_cast<float>(graph.ground[i]);
}

/// Raw columns of LaneRows, for kernels.
struct Couplings {
    explicit Couplings(const LaneRows& rows)
        : first(rows.first.data()), column(rows.column.data()), weight(rows.weight.data()) {}

    const std::uint32_t* first;
    const std::uint32_t* column;
    const float* weight;
};

using Lanes = std::array<float, lanes>;

/// sum += couplings of group q times x.
inline __attribute__((always_inline)) void
add_couplings(const Couplings& couplings, std::size_t q, const float* x, Lanes& sum) {
    for (std::size_t s = couplings.first[q] * lanes; s < couplings.first[q + 1] * lanes; s += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) {
            sum[l] += couplings.weight[s + l] * x[couplings.column[s + l]];
        }
    }
}

/// sum += couplings of group q times the differences of x to that of the row.
inline __attribute__((always_inline)) void
add_differences(const Couplings& couplings, std::size_t q, const Lanes& own, const float* x, Lanes& sum) {
    for (std::size_t s = couplings.first[q] * lanes; s < couplings.first[q + 1] * lanes; s += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) {
            sum[l] += couplings.weight[s + l] * (own[l] - x[couplings.column[s + l]]);
        }
    }
}

inline __attribute__((always_inline)) Lanes group(const float* x, std::size_t q) {
    Lanes values;
    for (std::size_t l = 0; l < lanes; ++l) {
        values[l] = x[q * lanes + l];
    }
    return values;
}

inline __attribute__((always_inline)) void store(const Lanes& values, std::size_t q, float* x) {
    for (std::size_t l = 0; l < lanes; ++l) {
        x[q * lanes + l] = values[l];
    }
}

SUFFUSE_CLONES void sweep_up_groups(
    const Couplings before, const float* inverse_sum, const float* b, float* x, std::size_t q, std::size_t end
) {
    for (; q < end; ++q) {
        Lanes sum = group(b, q);
        add_couplings(before, q, x, sum);
        for (std::size_t l = 0; l < lanes; ++l) {
            sum[l] *= inverse_sum[q * lanes + l];
        }
        store(sum, q, x);
    }
}

SUFFUSE_CLONES void
residual_of_groups(const Couplings after, const float* x, float* residual, std::size_t q, std::size_t end) {
    for (; q < end; ++q) {
        Lanes sum{};
        add_couplings(after, q, x, sum);
        store(sum, q, residual);
    }
}

SUFFUSE_CLONES void sweep_down_groups(
    const Couplings before, const Couplings after, const float* inverse_sum, const float* b, float* x, std::size_t q,
    std::size_t end
) {
    for (; q < end; ++q) {
        Lanes sum = group(b, q);
        add_couplings(before, q, x, sum);
        add_couplings(after, q, x, sum);
        for (std::size_t l = 0; l < lanes; ++l) {
            sum[l] *= inverse_sum[q * lanes + l];
        }
        store(sum, q, x);
    }
}

/// Sums of the products, a lane each.
struct LaneProducts {
    std::array<double, lanes> xy{}, xb{}, yc{};
};

SUFFUSE_CLONES void multiply_groups(
    const Couplings before, const Couplings after, const float* ground, const float* x, const float* b, const float* c,
    float* y, std::size_t q, std::size_t end, LaneProducts& sums
) {
    LaneProducts products;
    for (; q < end; ++q) {
        const Lanes own = group(x, q);
        Lanes sum = group(ground, q);
        for (std::size_t l = 0; l < lanes; ++l) {
            sum[l] *= own[l];
        }
        add_differences(before, q, own, x, sum);
        add_differences(after, q, own, x, sum);
        store(sum, q, y);
        for (std::size_t l = 0; l < lanes; ++l) {
            products.xy[l] += static_cast<double>(own[l]) * static_cast<double>(sum[l]);
            products.xb[l] += static_cast<double>(own[l]) * static_cast<double>(b[q * lanes + l]);
            products.yc[l] += static_cast<double>(sum[l]) * static_cast<double>(c[q * lanes + l]);
        }
    }
    sums = products;
}

/// The groups of a color, in blocks.
template <class Body>
void for_color(const ColoredGraph& graph, std::size_t c, Body&& body) {
    const std::size_t first = graph.color[c];
    parallel_for(graph.color[c + 1] - first, block, [&](std::size_t begin, std::size_t end) {
        body(first + begin, first + end);
    });
}

} // namespace

ColoredGraph color_graph(const WeightedGraph& graph) {
    ColoredGraph result;
    const std::vector<Row> rows = number_rows(graph, choose_colors(graph), result);
    open_rows(rows, result);
    result.inverse_sum.assign(rows.size(), 0.0F);
    result.ground.assign(rows.size(), 0.0F);
    parallel_for(rows.size(), lanes * block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            if (rows[r].node != none) {
                fill_row(graph, rows[r].node, r, result);
            }
        }
    });
    return result;
}

void sweep_up(const ColoredGraph& graph, std::span<const float> b, std::span<float> x) {
    for (std::size_t c = 0; c + 1 < graph.color.size(); ++c) {
        for_color(graph, c, [&](std::size_t begin, std::size_t end) {
            sweep_up_groups(Couplings(graph.before), graph.inverse_sum.data(), b.data(), x.data(), begin, end);
        });
    }
}

void residual_after_sweep(const ColoredGraph& graph, std::span<const float> x, std::span<float> residual) {
    parallel_for(graph.rows() / lanes, block, [&](std::size_t begin, std::size_t end) {
        residual_of_groups(Couplings(graph.after), x.data(), residual.data(), begin, end);
    });
}

void sweep_down(const ColoredGraph& graph, std::span<const float> b, std::span<float> x) {
    for (std::size_t c = graph.color.size() - 1; c-- > 0;) {
        for_color(graph, c, [&](std::size_t begin, std::size_t end) {
            sweep_down_groups(
                Couplings(graph.before), Couplings(graph.after), graph.inverse_sum.data(), b.data(), x.data(), begin,
                end
            );
        });
    }
}

Products multiply(
    const ColoredGraph& graph, std::span<const float> x, std::span<const float> b, std::span<const float> c,
    std::span<float> y
) {
    return parallel_sum(graph.rows() / lanes, sum_block, Products{}, [&](std::size_t begin, std::size_t end) {
        LaneProducts sums;
        multiply_groups(
            Couplings(graph.before), Couplings(graph.after), graph.ground.data(), x.data(), b.data(), c.data(),
            y.data(), begin, end, sums
        );
        Products total;
        for (std::size_t l = 0; l < lanes; ++l) {
            total = total + Products{sums.xy[l], sums.xb[l], sums.yc[l]};
        }
        return total;
    });
}

} // namespace suffuse::flow
