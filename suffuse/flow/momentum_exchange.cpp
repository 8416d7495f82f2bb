#include "suffuse/flow/momentum_exchange.hpp"

#include "suffuse/base/arctangent.hpp"
#include "suffuse/base/clones.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/pores/tile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace suffuse::flow {
namespace {

constexpr std::size_t block = 2048; // pores or throats of one loop of a thread

/// Exchange between two throats of a pore over void area and distance; fitted to resolved flows.
constexpr double strength = 1.2;

/// Four throats that exchange with each other by pairs do so, nearly, as through the pore with this part of the sum of
/// their pairs; exactly where all pairs are alike.
constexpr double star_of_four = 4.0 / 3;

/// Middles of throats count as no closer than this share of the edge between them.
constexpr double least_distance = 1e-6;

/// Pores side by side, with their own centers and those across their facets [m].
struct alignas(64) StarTile {
    pores::PoreTile spheres;
    std::array<pores::TileRow3, 4> beyond;
    pores::TileRow3 center;
    std::array<pores::TileRow, 4> leg;
};

/// Part of the triangle (a, b, c) outside the spheres around a and b, 0 where they overlap it all.
[[gnu::always_inline]] inline double
void_of_triangle(const Vec3& a, double ra, const Vec3& b, double rb, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, bc = c - b;
    const double twice = norm(cross(ab, ac));
    const double at_a = arctangent(twice, dot(ab, ac)), at_b = arctangent(twice, -dot(ab, bc));
    return std::max(0.0, 0.5 * (twice - ra * ra * at_a - rb * rb * at_b));
}

/// Of the four throats of each pore.
SUFFUSE_CLONES void measure_legs(StarTile& tile) {
    constexpr std::size_t pairs[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                                         {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}; // two throats, their edge
#pragma GCC ivdep
    for (std::size_t p = 0; p < pores::tile_rows; ++p) {
        // Throat k lies opposite to corner k; its middle is the mean of three corners and two pore centers. Less what
        // is common to the four it is (other center - corner k) / 5.
        std::array<Vec3, 4> x, middle;
        std::array<double, 4> leg{};
#pragma GCC unroll 4
        for (std::size_t k = 0; k < 4; ++k) {
            x[k] = tile.spheres.center[k][p];
            middle[k] = (tile.beyond[k][p] - x[k]) / 5;
        }
#pragma GCC unroll 6
        for (std::size_t i = 0; i < 6; ++i) {
            const std::size_t k = pairs[i][0], l = pairs[i][1], a = pairs[i][2], b = pairs[i][3];
            const double ra = tile.spheres.radius[a][p], rb = tile.spheres.radius[b][p];
            const double area = void_of_triangle(x[a], ra, x[b], rb, tile.center[p]);
            const double distance = std::max(norm(middle[k] - middle[l]), least_distance * norm(x[a] - x[b]));
            leg[k] += area / distance;
            leg[l] += area / distance;
        }
#pragma GCC unroll 4
        for (std::size_t k = 0; k < 4; ++k) {
            tile.leg[k][p] = strength * star_of_four * leg[k];
        }
    }
}

/// Equation of a pore: what it exchanges with its neighbors, through the throats between, and with the grains of these.
struct Row {
    std::array<double, 4> exchange{};
    double grains = 0;
    std::array<std::uint32_t, 4> neighbor{};

    /// Of the sum of them all; 0 where there is none.
    [[nodiscard]] double inverse() const {
        const double sum = exchange[0] + exchange[1] + exchange[2] + exchange[3] + grains;
        return sum > 0 ? 1 / sum : 0;
    }
};

/// Columns of a solution by conjugate gradients, preconditioned by the sums of the rows. T: one direction, or three at
/// once with common steps, so that nothing depends on how the axes lie.
template <class T>
class Descent {
public:
    explicit Descent(std::size_t pores) : partial_((pores + block - 1) / block) {
        row_.resize(pores), inverse_.resize(pores), x_.resize(pores);
        residual_.resize(pores), direction_.resize(pores), image_.resize(pores);
    }

    /// Gives pore p its equation.
    void set(std::size_t p, const Row& row, const T& source) {
        row_[p] = row, inverse_[p] = row.inverse(), residual_[p] = source;
        x_[p] = direction_[p] = T{};
    }

    /// The residual's size, squared.
    double size2() {
        return sum([&](std::size_t p) { return inner(residual_[p], residual_[p]) * inverse_[p]; });
    }

    void turn(double kept) {
        each([&](std::size_t p) { direction_[p] = inverse_[p] * residual_[p] + kept * direction_[p]; });
    }

    double curvature() {
        return sum([&](std::size_t p) {
            const Row& row = row_[p];
            T image = row.grains * direction_[p];
            for (std::size_t k = 0; k < 4; ++k) {
                image += row.exchange[k] * (direction_[p] - direction_[row.neighbor[k]]);
            }
            image_[p] = image;
            return inner(direction_[p], image);
        });
    }

    /// The residual's size after the step, squared.
    double go_down(double step) {
        return sum([&](std::size_t p) {
            x_[p] += step * direction_[p];
            residual_[p] -= step * image_[p];
            return inner(residual_[p], residual_[p]) * inverse_[p];
        });
    }

    RawColumn<T> take() { return std::move(x_); }

private:
    static double inner(double a, double b) { return a * b; }

    static double inner(const Vec3& a, const Vec3& b) { return dot(a, b); }

    template <class Body>
    void each(Body&& body) {
        parallel_for(row_.size(), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                body(p);
            }
        });
    }

    /// Adds up in fixed blocks, and allocates nothing.
    template <class Body>
    double sum(Body&& body) {
        parallel_for(row_.size(), block, [&](std::size_t begin, std::size_t end) {
            double part = 0;
            for (std::size_t p = begin; p < end; ++p) {
                part += body(p);
            }
            partial_[begin / block] = part;
        });
        double whole = 0;
        for (const double part : partial_) {
            whole += part;
        }
        return whole;
    }

    RawColumn<Row> row_;
    RawColumn<double> inverse_; ///< of each row: two of three loops over rows need no more of them
    RawColumn<T> x_, residual_, direction_;
    RawColumn<T> image_; ///< A direction
    std::vector<double> partial_;
};

/// A push in no direction, or a pressure on the facet of throat t.
template <class T>
T push_on(const pores::PoreNetwork& network, std::span<const double> push, std::size_t t) {
    if constexpr (std::is_same_v<T, Vec3>) {
        return push[t] * network.throats.area[t];
    } else {
        return push[t];
    }
}

[[noreturn]] void refuse(std::size_t pores, int iterations, double left, double tolerance) {
    throw SolverError(
        fmt::format(
            "flow: the exchange of momentum between {} pores did not converge: {:.3g} of it is out of balance after {} "
            "iterations, at most {:.3g} is allowed; look for grains that overlap or coincide",
            pores, left, iterations, tolerance
        ),
        iterations, left
    );
}

} // namespace

ExchangeLegs
exchange_legs(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    ExchangeLegs leg(network.throats.size());
    const pores::Pores& pores = network.pores;
    parallel_for(pores.size(), block, [&](std::size_t begin, std::size_t end) {
        StarTile tile{};
        for (std::size_t first = begin; first < end; first += pores::tile_rows) {
            const std::size_t last = std::min(first + pores::tile_rows, end);
            pores::load_pores(network.h, pores, position, radius, first, last, tile.spheres);
            for (std::size_t row = 0; row < pores::tile_rows; ++row) {
                const auto p = static_cast<std::uint32_t>(std::min(first + row, last - 1));
                tile.center.set(row, pores.center[p]);
                for (std::size_t k = 0; k < 4; ++k) {
                    const pores::PlacedPore beyond = pores::pore_beyond(network, p, k);
                    tile.beyond[k].set(row, pores.center[beyond.pore] + shift(network.h, beyond.image));
                }
            }
            measure_legs(tile);
            for (auto p = static_cast<std::uint32_t>(first); p < last; ++p) {
                for (std::size_t k = 0; k < 4; ++k) {
                    leg[pores.throat[p][k]][pores::side_of(network, p, k)] = static_cast<float>(tile.leg[k][p - first]);
                }
            }
        }
    });
    return leg;
}

MomentumExchange::MomentumExchange(
    const pores::PoreNetwork& network, RawColumn<double> drag, ExchangeLegs leg, const ExchangeSpec& spec
)
    : network_(network), drag_(std::move(drag)), leg_(std::move(leg)), spec_(spec) {
    expects(drag_.size() == network.throats.size() && leg_.size() == drag_.size(), "one drag and two legs a throat");
}

template <class T>
T MomentumExchange::velocity(const RawColumn<T>& in_pore, const T& push, std::size_t t) const {
    const auto [p, q] = network_.throats.side[t];
    const auto here = static_cast<double>(leg_[t][0]), beyond = static_cast<double>(leg_[t][1]);
    const double all = drag_[t] + here + beyond;
    return all > 0 ? (1 / all) * (push + here * in_pore[p] + beyond * in_pore[q]) : T{};
}

/// A throat's velocity follows from those of its pores. Put in, each leg goes in part to the grains and in part on to
/// the pore beyond.
template <class T>
RawColumn<T> MomentumExchange::velocities_in_pores(std::span<const double> push) const {
    expects(push.size() == drag_.size(), "one push a throat");
    Descent<T> descent(network_.pores.size());
    parallel_for(network_.pores.size(), block, [&](std::size_t begin, std::size_t end) {
        for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
            Row row;
            T source{};
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t t = network_.pores.throat[p][k];
                const std::size_t side = pores::side_of(network_, p, k);
                const auto here = static_cast<double>(leg_[t][side]), beyond = static_cast<double>(leg_[t][1 - side]);
                row.neighbor[k] = network_.throats.side[t][1 - side];
                if (!(here > 0)) {
                    continue;
                }
                const double part = here / (drag_[t] + here + beyond);
                source += part * push_on<T>(network_, push, t);
                row.grains += part * drag_[t];
                row.exchange[k] = row.neighbor[k] == p ? 0 : part * beyond;
            }
            descent.set(p, row, source);
        }
    });
    double left = descent.size2(), kept = 0;
    const double whole = left, wanted = spec_.tolerance * spec_.tolerance * whole;
    int iterations = 0;
    for (; left > wanted && iterations < spec_.iteration_limit; ++iterations) {
        descent.turn(kept);
        const double before = left, curvature = descent.curvature();
        if (!(curvature > 0)) {
            break;
        }
        left = descent.go_down(before / curvature);
        kept = left / before;
    }
    if (!(left <= wanted)) {
        refuse(network_.pores.size(), iterations, std::sqrt(left / whole), spec_.tolerance);
    }
    return descent.take();
}

std::vector<double> MomentumExchange::velocities(std::span<const double> push) const {
    const RawColumn<double> in_pore = velocities_in_pores<double>(push);
    std::vector<double> speed;
    resize_columns(push.size(), speed);
    parallel_for(push.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            speed[t] = velocity(in_pore, push[t], t);
        }
    });
    return speed;
}

MomentumExchange::Motion MomentumExchange::motion(std::span<const double> pressure) const {
    Motion motion{velocities_in_pores<Vec3>(pressure), RawColumn<Vec3>(network_.pores.size())};
    parallel_for(network_.pores.size(), block, [&](std::size_t begin, std::size_t end) {
        for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
            Vec3 sum;
            double legs = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t t = network_.pores.throat[p][k];
                const auto leg = static_cast<double>(leg_[t][pores::side_of(network_, p, k)]);
                sum += leg * velocity(motion.velocity, push_on<Vec3>(network_, pressure, t), t);
                legs += leg;
            }
            motion.mean[p] = legs > 0 ? sum / legs : Vec3{};
        }
    });
    return motion;
}

Vec3 MomentumExchange::to_grains(const Motion& motion, std::span<const double> pressure, std::size_t t) const {
    const auto [p, q] = network_.throats.side[t];
    const Vec3 push = push_on<Vec3>(network_, pressure, t), here = velocity(motion.velocity, push, t);
    return push + static_cast<double>(leg_[t][0]) * (motion.mean[p] - here) +
           static_cast<double>(leg_[t][1]) * (motion.mean[q] - here);
}

} // namespace suffuse::flow
