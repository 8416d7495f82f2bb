#include "suffuse/stokes/held_forces.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/stokes/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::stokes {
namespace {

template <class Real>
FaceValues<Real> values_like(const std::array<HeldFaces, 3>& faces) {
    return {std::vector<Real>(faces[0].size()), std::vector<Real>(faces[1].size()), std::vector<Real>(faces[2].size())};
}

/// Two sums of the inverse squares of the spacings: the diagonal of minus the Laplacian.
double laplacian_diagonal(const Vec3& spacing) {
    return 2 / (spacing.x * spacing.x) + 2 / (spacing.y * spacing.y) + 2 / (spacing.z * spacing.z);
}

/// Rows of a field around one along z, and what minus the Laplacian weighs them with.
struct Neighborhood {
    const float *here, *left, *right, *front, *back;
    float diagonal, wx, wy, wz;
};

SUFFUSE_CLONES void laplacian_of_row(const Neighborhood at, std::size_t n, float* __restrict result) {
    const auto of = [&at](std::size_t z, std::size_t below, std::size_t above) {
        return at.diagonal * at.here[z] - at.wx * (at.left[z] + at.right[z]) - at.wy * (at.front[z] + at.back[z]) -
               at.wz * (at.here[below] + at.here[above]);
    };
    result[0] = of(0, n - 1, 1);
    for (std::size_t z = 1; z + 1 < n; ++z) {
        result[z] = of(z, z - 1, z + 1);
    }
    result[n - 1] = of(n - 1, n - 2, 0);
}

/// Single precision makes good velocities of a residual, but what it rounds adds up, and where forces move nothing
/// (pressure in a grain) nothing takes it away: residuals are found anew before they have fallen so far [-].
constexpr double worn_below = 1e-4;

/// How far along a step, and the velocities that it makes.
struct Advance {
    double length, drift;
    const float *step, *velocity;
};

SUFFUSE_CLONES void
advance(const Advance& by, std::size_t first, std::size_t last, double* __restrict force, double* __restrict residual) {
    const double length = by.length, drift = by.drift;
    for (std::size_t f = first; f < last; ++f) {
        force[f] -= length * static_cast<double>(by.step[f]);
        residual[f] -= length * (static_cast<double>(by.velocity[f]) - drift);
    }
}

} // namespace

/// Where conjugate gradients are.
struct HeldForces::Iterate {
    FaceValues<double> force, residual;
    FaceValues<float> step, work;
    Vec3 velocity{};    ///< mean that the forces leave
    double power = 0;   ///< of the forces: theirs times the velocities
    double product = 0; ///< of the residual and the preconditioned one
    Vec3 away{};        ///< means of the preconditioned residual
    double ratio = 0;   ///< of that product to the last
    double gain = 0;    ///< of the last iteration: what it took off the square of the error
};

HeldForces::HeldForces(const Grid& grid, std::span<const Vec3> position, std::span<const double> radius)
    : grid_(grid), grains_(radius.size()), faces_(find_held_faces(grid, position, radius)),
      scale_(values_like<float>(faces_)), partial_(3 * grid.boxes[0]), response_(grid) {
    const double d = laplacian_diagonal(grid.spacing);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const HeldFaces& faces = faces_[axis];
        if (faces.size() == 0 || faces.size() == grid.size()) {
            throw GeometryError(fmt::format(
                "resolved flow: the grains hold {} of the {} faces of the grid normal to an axis; some, but not all, "
                "are expected: use more boxes across a diameter",
                faces.size(), grid.size()
            ));
        }
        for (std::size_t f = 0; f < faces.size(); ++f) {
            scale_[axis][f] = static_cast<float>(1 / std::sqrt(1 + faces.mobility[f] * d));
        }
        field_[axis].resize(grid.size());
    }
}

/// Calls `act(axis, x, first row, last row)`, planes of one axis after those of another.
template <class Act>
void HeldForces::for_each_plane(const Act& act) {
    const std::size_t nx = grid_.boxes[0], ny = grid_.boxes[1];
    parallel_for(3 * nx, 1, [&](std::size_t i, std::size_t) {
        partial_[i] = {};
        act(i / nx, i % nx, faces_[i / nx].row_begin[i % nx * ny], faces_[i / nx].row_begin[(i % nx + 1) * ny]);
    });
}

HeldForces::Sums HeldForces::add_up() const {
    Sums sums;
    const std::size_t nx = grid_.boxes[0];
    for (std::size_t i = 0; i < 3 * nx; ++i) {
        sums.values[static_cast<int>(i / nx)] += partial_[i].values;
        sums.product += partial_[i].product;
    }
    return sums;
}

/// Over the held faces of each axis.
Vec3 HeldForces::mean(const Vec3& sums) const {
    return {
        sums.x / static_cast<double>(faces_[0].size()), sums.y / static_cast<double>(faces_[1].size()),
        sums.z / static_cast<double>(faces_[2].size())};
}

void HeldForces::find_velocities(const FaceValues<double>& force, FaceValues<double>& velocity) {
    std::fill(partial_.begin(), partial_.end(), Partial{});
    const auto fill = [&](std::size_t axis, std::size_t row, std::span<double> values) {
        const HeldFaces& faces = faces_[axis];
        for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
            values[faces.z[f]] = force[axis][f];
        }
    };
    const auto take = [&](std::size_t axis, std::size_t row, std::span<double> values) {
        const HeldFaces& faces = faces_[axis];
        Partial& sums = partial_[axis * grid_.boxes[0] + row / grid_.boxes[1]];
        for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
            const double u = values[faces.z[f]] + faces.mobility[f] * force[axis][f];
            velocity[axis][f] = u;
            sums.values += u;
            sums.product += u * force[axis][f];
        }
    };
    response_.apply(RowWork<double>(std::ref(fill)), RowWork<double>(std::ref(take)));
}

/// Puts the residual of a row, scaled, onto its field.
void HeldForces::put(std::size_t axis, std::size_t row, const std::vector<double>& residual) {
    const HeldFaces& faces = faces_[axis];
    float* const values = field_[axis].data() + row * grid_.boxes[2];
    for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
        values[faces.z[f]] = scale_[axis][f] * static_cast<float>(residual[f]);
    }
}

void HeldForces::precondition_plane(
    std::size_t axis, std::size_t x, const std::vector<double>& residual, std::vector<float>& result
) {
    thread_local std::vector<float> line;
    const std::size_t nx = grid_.boxes[0], ny = grid_.boxes[1], nz = grid_.boxes[2];
    line.resize(nz);
    const Vec3& h = grid_.spacing;
    const HeldFaces& faces = faces_[axis];
    const std::vector<float>& field = field_[axis];
    Partial& sums = partial_[axis * nx + x];
    const auto row_at = [&](std::size_t i, std::size_t j) { return &field[(i * ny + j) * nz]; };
    for (std::size_t y = 0; y < ny; ++y) {
        const Neighborhood around{
            row_at(x, y),
            row_at(x == 0 ? nx - 1 : x - 1, y),
            row_at(x + 1 == nx ? 0 : x + 1, y),
            row_at(x, y == 0 ? ny - 1 : y - 1),
            row_at(x, y + 1 == ny ? 0 : y + 1),
            static_cast<float>(laplacian_diagonal(h)),
            static_cast<float>(1 / (h.x * h.x)),
            static_cast<float>(1 / (h.y * h.y)),
            static_cast<float>(1 / (h.z * h.z))};
        laplacian_of_row(around, nz, line.data());
        const std::size_t row = x * ny + y;
        for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
            const float value = scale_[axis][f] * line[faces.z[f]];
            result[f] = value;
            sums.values += static_cast<double>(value);
            sums.product += static_cast<double>(value) * residual[f];
        }
    }
}

void HeldForces::precondition(const FaceValues<double>& residual, FaceValues<float>& result) {
    for_each_plane([&](std::size_t axis, std::size_t x, std::size_t, std::size_t) {
        for (std::size_t y = 0; y < grid_.boxes[1]; ++y) {
            put(axis, x * grid_.boxes[1] + y, residual[axis]);
        }
    });
    for_each_plane([&](std::size_t axis, std::size_t x, std::size_t, std::size_t) {
        precondition_plane(axis, x, residual[axis], result[axis]);
    });
}

double HeldForces::product(const FaceValues<float>& force, const FaceValues<double>& velocity) {
    for_each_plane([&](std::size_t axis, std::size_t x, std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) {
            partial_[axis * grid_.boxes[0] + x].product += static_cast<double>(force[axis][f]) * velocity[axis][f];
        }
    });
    return add_up().product;
}

/// Velocities of the forces in double precision, after making the forces add up to what drives the water.
void HeldForces::refresh(Iterate& i, const Vec3& direction) {
    for_each_plane([&](std::size_t axis, std::size_t x, std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) {
            partial_[axis * grid_.boxes[0] + x].values += i.force[axis][f];
        }
    });
    const Vec3 excess = mean(add_up().values - static_cast<double>(grid_.size()) * direction);
    for_each_plane([&](std::size_t axis, std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) {
            i.force[axis][f] -= excess[static_cast<int>(axis)];
        }
    });
    find_velocities(i.force, i.residual);
    const Sums sums = add_up();
    i.velocity = mean(sums.values);
    i.power = sums.product;
    for_each_plane([&](std::size_t axis, std::size_t x, std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) {
            i.residual[axis][f] -= i.velocity[static_cast<int>(axis)];
        }
        for (std::size_t y = 0; y < grid_.boxes[1]; ++y) {
            put(axis, x * grid_.boxes[1] + y, i.residual[axis]);
        }
    });
}

/// The preconditioned residual in `work`, without its means: the mean velocity is free, and forces that add up to
/// nothing leave it so.
void HeldForces::find_direction(Iterate& i) {
    for_each_plane([&](std::size_t axis, std::size_t x, std::size_t, std::size_t) {
        precondition_plane(axis, x, i.residual[axis], i.work[axis]);
    });
    const Sums sums = add_up();
    i.away = mean(sums.values);
    i.ratio = i.product > 0 ? sums.product / i.product : 0;
    i.product = sums.product;
}

/// One step along the direction.
void HeldForces::follow(Iterate& i) {
    std::fill(partial_.begin(), partial_.end(), Partial{});
    const auto fill = [&](std::size_t axis, std::size_t row, std::span<float> values) {
        const HeldFaces& faces = faces_[axis];
        const auto ratio = static_cast<float>(i.ratio), away = static_cast<float>(i.away[static_cast<int>(axis)]);
        for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
            const float step = ratio * i.step[axis][f] + (i.work[axis][f] - away);
            i.step[axis][f] = step;
            values[faces.z[f]] = step;
        }
    };
    const auto take = [&](std::size_t axis, std::size_t row, std::span<float> values) {
        const HeldFaces& faces = faces_[axis];
        Partial& sums = partial_[axis * grid_.boxes[0] + row / grid_.boxes[1]];
        for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
            const float step = i.step[axis][f];
            const float u = values[faces.z[f]] + faces.mobility[f] * step;
            i.work[axis][f] = u;
            sums.values += static_cast<double>(u);
            sums.product += static_cast<double>(u) * static_cast<double>(step);
        }
    };
    response_.apply(RowWork<float>(std::ref(fill)), RowWork<float>(std::ref(take)));
    const Sums sums = add_up();
    const Vec3 drift = mean(sums.values);
    const double length = i.product / sums.product;
    for_each_plane([&](std::size_t axis, std::size_t x, std::size_t first, std::size_t last) {
        const Advance by{length, drift[static_cast<int>(axis)], i.step[axis].data(), i.work[axis].data()};
        advance(by, first, last, i.force[axis].data(), i.residual[axis].data());
        for (std::size_t y = 0; y < grid_.boxes[1]; ++y) {
            put(axis, x * grid_.boxes[1] + y, i.residual[axis]);
        }
    });
    i.gain = length * i.product;
    i.power -= i.gain;
}

UnitFlow HeldForces::solve_one(Iterate& i, const Vec3& direction, const SolverLimits& limits, const Pulse& pulse) {
    UnitFlow flow;
    flow.residual = 1;
    ErrorEstimate error(limits.iterations);
    refresh(i, direction); // all that drives the water ends in the grains: evenly, to begin with
    find_direction(i);
    double expected = 0; // product where the tolerance seems to be reached
    double refreshed = i.product;
    while (i.product > 0 && !(expected > 0 && i.product < 4 * expected)) {
        if (flow.iterations == limits.iterations) {
            throw SolverError(
                fmt::format(
                    "resolved flow: after {} iterations the residual is {:.1e}; at most {:.1e} is expected",
                    flow.iterations, flow.residual, limits.tolerance
                ),
                flow.iterations, flow.residual
            );
        }
        beat(pulse, "resolve the flow", flow.iterations);
        follow(i);
        error.add(i.gain);
        ++flow.iterations;
        flow.residual = std::min(1.0, error.square() / i.power);
        const bool reached = flow.residual <= limits.tolerance, worn = i.product < worn_below * refreshed;
        const double product = i.product;
        if (reached || worn) {
            refresh(i, direction);
        }
        find_direction(i);
        expected = reached ? product : 0;
        refreshed = worn ? i.product : std::max(refreshed, i.product);
    }
    flow.velocity = i.velocity + (i.power / static_cast<double>(grid_.size()) - dot(i.velocity, direction)) * direction;
    flow.force = grain_forces(i.force);
    return flow;
}

std::vector<Vec3> HeldForces::grain_forces(const FaceValues<double>& force) const {
    std::vector<Vec3> sums(grains_);
    const double box = grid_.spacing.x * grid_.spacing.y * grid_.spacing.z;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        for (std::size_t f = 0; f < faces_[a].size(); ++f) {
            sums[faces_[a].grain[f]][axis] += box * force[a][f];
        }
    }
    return sums;
}

std::vector<UnitFlow>
HeldForces::solve(std::span<const Vec3> directions, const SolverLimits& limits, const Pulse& pulse) {
    std::vector<UnitFlow> flows;
    std::vector<FaceValues<float>> forces;
    for (const Vec3& direction : directions) {
        Iterate i{
            values_like<double>(faces_), values_like<double>(faces_), values_like<float>(faces_),
            values_like<float>(faces_)};
        UnitFlow flow = solve_one(i, direction, limits, pulse);
        for (std::size_t a = 0; a < forces.size(); ++a) {
            const double across =
                dot(flow.velocity, directions[a]) + product(forces[a], i.residual) / static_cast<double>(grid_.size());
            flow.velocity += (across - dot(flow.velocity, directions[a])) * directions[a];
            flows[a].velocity += (across - dot(flows[a].velocity, direction)) * direction;
        }
        flows.push_back(std::move(flow));
        if (flows.size() < directions.size()) {
            forces.push_back(values_like<float>(faces_));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                std::transform(i.force[axis].begin(), i.force[axis].end(), forces.back()[axis].begin(), [](double f) {
                    return static_cast<float>(f);
                });
            }
        }
    }
    return flows;
}

} // namespace suffuse::stokes
