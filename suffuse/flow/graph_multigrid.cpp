#include "suffuse/flow/graph_multigrid.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"

#include <cmath>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::size_t block = 4096; // nodes of one loop of a thread

} // namespace

// The graph without ground goes before the smaller ones come: they need the room.
GraphMultigrid::GraphMultigrid(WeightedGraph graph) : graph_(grounded(std::exchange(graph, {}))), cycle_(graph_) {}

double GraphMultigrid::size(std::span<const double> b) const {
    const double sum = parallel_sum(graph_.size(), block, 0.0, [&](std::size_t begin, std::size_t end) {
        double part = 0;
        for (std::size_t i = begin; i < end; ++i) {
            part += b[i] * b[i] * graph_.inverse_sum(i);
        }
        return part;
    });
    return std::sqrt(sum);
}

/// Columns of a solution by conjugate gradients, a place a node.
struct GraphMultigrid::Descent {
    Descent(std::vector<double>&& b, AggregationCycle::Columns&& scratch)
        : residual(std::move(b)), x(residual.size()), direction(x.size()), image(x.size()),
          columns(std::move(scratch)) {
        parallel_for(x.size(), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                x[i] = direction[i] = image[i] = 0;
            }
        });
    }

    std::vector<double> residual;
    RawColumn<double> x, direction;
    RawColumn<double> image; ///< A direction
    AggregationCycle::Columns columns;
    double descent = 1; ///< correction . residual of the last iteration
    double step = 0;    ///< along the last direction
};

/// Fills in the correction that one cycle gives to the residual, over `scale`: brought to the size of 1, single
/// precision holds it.
void GraphMultigrid::precondition(double scale, Descent& d) const {
    parallel_for(graph_.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            d.columns.source()[cycle_.row(i)] = static_cast<float>(d.residual[i] / scale);
        }
    });
    cycle_.apply(d.columns);
}

/// Turns the direction. The cycle is not quite the same map each time: the flexible form of conjugate gradients
/// subtracts what has changed since, residual - residual before = -step * image.
void GraphMultigrid::turn(double scale, Descent& d) const {
    struct Sums {
        double residual = 0, image = 0; // each times the correction

        Sums operator+(const Sums& other) const { return {residual + other.residual, image + other.image}; }
    };

    const auto correction = [&](std::size_t i) {
        return static_cast<double>(d.columns.correction()[cycle_.row(i)]) * scale;
    };
    const Sums sums = parallel_sum(graph_.size(), block, Sums{}, [&](std::size_t begin, std::size_t end) {
        Sums part;
        for (std::size_t i = begin; i < end; ++i) {
            part.residual += correction(i) * d.residual[i];
            part.image += correction(i) * d.image[i];
        }
        return part;
    });
    const double kept = -d.step * sums.image / d.descent;
    parallel_for(graph_.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            d.direction[i] = correction(i) + kept * d.direction[i];
        }
    });
    d.descent = sums.residual;
}

/// Goes along the direction to the least energy; false where there is no way down.
bool GraphMultigrid::go_down(Descent& d) const {
    struct Sums {
        double curvature = 0, slope = 0;

        Sums operator+(const Sums& other) const { return {curvature + other.curvature, slope + other.slope}; }
    };

    const Sums sums = parallel_sum(graph_.size(), block, Sums{}, [&](std::size_t begin, std::size_t end) {
        multiply(graph_, d.direction, d.image, begin, end);
        Sums part;
        for (std::size_t i = begin; i < end; ++i) {
            part.curvature += d.direction[i] * d.image[i];
            part.slope += d.direction[i] * d.residual[i];
        }
        return part;
    });
    if (!(sums.curvature > 0)) {
        return false;
    }
    d.step = sums.slope / sums.curvature;
    parallel_for(graph_.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            d.x[i] += d.step * d.direction[i];
            d.residual[i] -= d.step * d.image[i];
        }
    });
    return true;
}

GraphMultigrid::Result GraphMultigrid::solve(std::vector<double> b, double wanted, int iteration_limit) const {
    expects(b.size() == graph_.size(), "one source a node");
    Descent descent(std::move(b), cycle_.columns());
    Result result{{}, 0, size(descent.residual)};
    for (; result.imbalance > wanted && result.iterations < iteration_limit; ++result.iterations) {
        const double scale = result.imbalance;
        precondition(scale, descent);
        turn(scale, descent);
        if (!go_down(descent)) {
            break;
        }
        result.imbalance = size(descent.residual);
    }
    result.x = std::move(descent.x);
    return result;
}

} // namespace suffuse::flow
