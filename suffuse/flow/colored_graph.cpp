#include "suffuse/flow/colored_graph.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/prefix_sum.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::size_t block = 32;      // groups of one loop of a thread
constexpr std::size_t sum_block = 256; // groups that are summed one after the other: sums depend on it
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t stretch = 1024; // rows within which those of equal length come together

/// Chooses the first color that no neighbor in [begin, end) has.
class ColorChoice {
public:
    explicit ColorChoice(const WeightedGraph& graph) : graph_(graph) {}

    std::uint32_t choose(std::span<const std::uint32_t> color, std::uint32_t i, std::size_t begin, std::size_t end) {
        for (std::uint32_t k = graph_.first[i]; k < graph_.first[i + 1]; ++k) {
            const std::uint32_t j = graph_.neighbor[k];
            if (begin <= j && j < end) {
                taken_by_.resize(std::max(taken_by_.size(), color[j] + std::size_t{1}), none);
                taken_by_[color[j]] = i;
            }
        }
        return static_cast<std::uint32_t>(
            std::ranges::find_if(taken_by_, [&](std::uint32_t by) { return by != i; }) - taken_by_.begin()
        );
    }

private:
    const WeightedGraph& graph_;
    std::vector<std::uint32_t> taken_by_; ///< the node whose neighbor has the color
};

/// Whether a neighbor before `begin` has the color of node i.
bool is_doubled(const WeightedGraph& graph, std::span<const std::uint32_t> color, std::uint32_t i, std::size_t begin) {
    for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1] && graph.neighbor[k] < begin; ++k) {
        if (color[graph.neighbor[k]] == color[i]) {
            return true;
        }
    }
    return false;
}

RawColumn<std::uint32_t> choose_colors(const WeightedGraph& graph) {
    RawColumn<std::uint32_t> color(graph.size());
    parallel_for(graph.size(), nodes_together, [&](std::size_t begin, std::size_t end) {
        ColorChoice choice(graph);
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            color[i] = choice.choose(color, i, begin, i);
        }
    });
    std::vector<std::vector<std::uint32_t>> doubled((graph.size() + nodes_together - 1) / nodes_together);
    parallel_for(graph.size(), nodes_together, [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            if (is_doubled(graph, color, i, begin)) {
                doubled[begin / nodes_together].push_back(i);
            }
        }
    });
    ColorChoice choice(graph);
    for (const std::vector<std::uint32_t>& some : doubled) {
        for (const std::uint32_t i : some) {
            color[i] = choice.choose(color, i, 0, graph.size());
        }
    }
    return color;
}

/// A row: couplings of its node to earlier colors, and all of them.
struct Row {
    std::uint32_t before = 0, all = 0, node = none;

    auto operator<=>(const Row&) const = default;
};

Row row_of(const WeightedGraph& graph, std::span<const std::uint32_t> color, std::uint32_t i) {
    Row row{0, graph.first[i + 1] - graph.first[i], i};
    for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
        row.before += color[graph.neighbor[k]] < color[i] ? 1 : 0;
    }
    return row;
}

/// Where the nodes of each color begin among the rows, block of nodes by block: colors side by side. Each color begins
/// a group.
class ColorPlaces {
public:
    ColorPlaces(std::span<const std::uint32_t> color, ColoredGraph& result)
        : next_((color.size() + counted - 1) / counted) {
        parallel_for(color.size(), counted, [&](std::size_t begin, std::size_t end) {
            std::vector<std::uint32_t>& count = next_[begin / counted];
            for (std::size_t i = begin; i < end; ++i) {
                count.resize(std::max(count.size(), color[i] + std::size_t{1}), 0);
                ++count[color[i]];
            }
        });
        std::size_t colors = 0;
        for (const std::vector<std::uint32_t>& count : next_) {
            colors = std::max(colors, count.size());
        }
        result.color.assign(colors + 1, 0);
        for (std::size_t c = 0; c < colors; ++c) {
            std::uint32_t place = result.color[c] * lanes;
            for (std::vector<std::uint32_t>& count : next_) {
                count.resize(colors, 0);
                place += std::exchange(count[c], place);
            }
            end_.push_back(place);
            place += c + 1 == colors ? 1 : 0; // the last row stays free
            result.color[c + 1] = static_cast<std::uint32_t>((place + lanes - 1) / lanes);
        }
    }

    /// Calls `body(node, row)` for all nodes.
    template <class Body>
    void give(std::span<const std::uint32_t> color, Body&& body) {
        parallel_for(color.size(), counted, [&](std::size_t begin, std::size_t end) {
            for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                body(i, next_[begin / counted][color[i]]++);
            }
        });
    }

    [[nodiscard]] std::size_t end(std::size_t c) const { return end_[c]; } ///< of the rows of nodes of color c

private:
    static constexpr std::size_t counted = 8192; ///< nodes of a block
    std::vector<std::vector<std::uint32_t>> next_;
    std::vector<std::uint32_t> end_;
};

/// Rows in order of colors, then nodes. Within a stretch of a color rows of equal length come together, so that little
/// has to be filled up.
RawColumn<Row> number_rows(const WeightedGraph& graph, std::span<const std::uint32_t> color, ColoredGraph& result) {
    ColorPlaces places(color, result);
    RawColumn<Row> rows(result.color.back() * lanes);
    places.give(color, [&](std::uint32_t i, std::uint32_t r) { rows[r] = row_of(graph, color, i); });
    result.row.resize(color.size());
    for (std::size_t c = 0; c + 1 < result.color.size(); ++c) {
        const std::size_t first = result.color[c] * lanes;
        parallel_for(places.end(c) - first, stretch, [&](std::size_t begin, std::size_t end) {
            const auto from = rows.begin() + static_cast<std::ptrdiff_t>(first);
            std::sort(from + static_cast<std::ptrdiff_t>(begin), from + static_cast<std::ptrdiff_t>(end));
            for (std::size_t r = first + begin; r < first + end; ++r) {
                result.row[rows[r].node] = static_cast<std::uint32_t>(r);
            }
        });
        std::fill(
            rows.begin() + static_cast<std::ptrdiff_t>(places.end(c)),
            rows.begin() + static_cast<std::ptrdiff_t>(result.color[c + 1] * lanes), Row{}
        );
    }
    return rows;
}

/// Opens the rows of couplings to earlier and to later colors.
void open_rows(const RawColumn<Row>& rows, ColoredGraph& result) {
    const std::size_t groups = rows.size() / lanes;
    result.before.first.assign(groups + 1, 0), result.after.first.assign(groups + 1, 0);
    parallel_for(groups, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin * lanes; r < end * lanes; ++r) {
            std::uint32_t &before = result.before.first[r / lanes], &after = result.after.first[r / lanes];
            before = std::max(before, rows[r].before);
            after = std::max(after, rows[r].all - rows[r].before);
        }
    });
    for (LaneRows* const couplings : {&result.before, &result.after}) {
        const std::size_t all = sum_before(std::span(couplings->first)) * lanes;
        couplings->column.resize(all), couplings->weight.resize(all);
    }
}

/// Lets the rows of group q couple to `row`, by nothing.
void fill_up(LaneRows& couplings, std::size_t q, std::size_t row) {
    for (std::size_t s = couplings.first[q] * lanes; s < couplings.first[q + 1] * lanes; ++s) {
        couplings.column[s] = static_cast<std::uint32_t>(row), couplings.weight[s] = 0.0F;
    }
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
    result.inverse_sum[r] = static_cast<float>(graph.inverse_sum(i));
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
    const RawColumn<Row> rows = number_rows(graph, choose_colors(graph), result);
    open_rows(rows, result);
    result.inverse_sum.resize(rows.size()), result.ground.resize(rows.size());
    parallel_for(rows.size() / lanes, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) {
            fill_up(result.before, q, 0), fill_up(result.after, q, rows.size() - 1);
            for (std::size_t r = q * lanes; r < (q + 1) * lanes; ++r) {
                if (rows[r].node != none) {
                    fill_row(graph, rows[r].node, r, result);
                } else {
                    result.inverse_sum[r] = result.ground[r] = 0.0F;
                }
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
