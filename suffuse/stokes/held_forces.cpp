#include "suffuse/stokes/held_forces.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::stokes {
namespace {

constexpr std::size_t block = 1 << 14; // of faces, fixed: sums have the same bits for any number of threads

FaceValues values_like(const std::array<HeldFaces, 3>& faces) {
    return {
        std::vector<double>(faces[0].size()), std::vector<double>(faces[1].size()),
        std::vector<double>(faces[2].size())};
}

/// Sum of `term(axis, f)` over one axis.
template <class Term>
double sum_of(std::size_t count, const Term& term) {
    return parallel_sum(count, block, 0.0, [&](std::size_t first, std::size_t last) {
        double sum = 0;
        for (std::size_t f = first; f < last; ++f) {
            sum += term(f);
        }
        return sum;
    });
}

double dot(const FaceValues& a, const FaceValues& b) {
    double total = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        total += sum_of(a[axis].size(), [&](std::size_t f) { return a[axis][f] * b[axis][f]; });
    }
    return total;
}

/// a = a + factor b, or factor a + b.
enum class Scale { Second, First };

void add(FaceValues& a, double factor, const FaceValues& b, Scale scale) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        parallel_for(a[axis].size(), block, [&](std::size_t first, std::size_t last) {
            for (std::size_t f = first; f < last; ++f) {
                a[axis][f] =
                    scale == Scale::Second ? a[axis][f] + factor * b[axis][f] : factor * a[axis][f] + b[axis][f];
            }
        });
    }
}

/// Means by axis, taken away: the mean velocity is free, and forces that add up to nothing leave it so.
Vec3 take_mean_away(FaceValues& values) {
    Vec3 mean;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double>& v = values[static_cast<std::size_t>(axis)];
        mean[axis] = sum_of(v.size(), [&](std::size_t f) { return v[f]; }) / static_cast<double>(v.size());
        parallel_for(v.size(), block, [&](std::size_t first, std::size_t last) {
            for (std::size_t f = first; f < last; ++f) {
                v[f] -= mean[axis];
            }
        });
    }
    return mean;
}

/// Two sums of the inverse squares of the spacings: the diagonal of minus the Laplacian.
double laplacian_diagonal(const Vec3& spacing) {
    return 2 / (spacing.x * spacing.x) + 2 / (spacing.y * spacing.y) + 2 / (spacing.z * spacing.z);
}

} // namespace

HeldForces::HeldForces(const Grid& grid, std::span<const Vec3> position, std::span<const double> radius)
    : grid_(grid), grains_(radius.size()), faces_(find_held_faces(grid, position, radius)), response_(grid) {
    for (const HeldFaces& faces : faces_) {
        if (faces.size() == 0 || faces.size() == grid.size()) {
            throw GeometryError(fmt::format(
                "resolved flow: the grains hold {} of the {} faces of the grid normal to an axis; some, and not all, "
                "are expected: ask for more boxes across a diameter",
                faces.size(), grid.size()
            ));
        }
    }
}

/// Onto the fields, zero elsewhere; `scaled` for the preconditioner.
void HeldForces::scatter(const FaceValues& values, bool scaled) {
    const double d = laplacian_diagonal(grid_.spacing);
    const std::size_t length = grid_.row_length();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const HeldFaces& faces = faces_[axis];
        const std::span<double> field = response_.field(axis);
        parallel_for(grid_.rows(), grid_.boxes[1], [&](std::size_t first, std::size_t last) {
            std::fill(
                field.begin() + static_cast<std::ptrdiff_t>(first * length),
                field.begin() + static_cast<std::ptrdiff_t>(last * length), 0.0
            );
            for (std::size_t row = first; row < last; ++row) {
                for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
                    const double scale = scaled ? 1 / std::sqrt(1 + faces.mobility[f] * d) : 1;
                    field[row * length + faces.z[f]] = scale * values[axis][f];
                }
            }
        });
    }
}

/// Of held faces under `force`: response of the water, plus what faces next to a surface may move.
void HeldForces::velocities(const FaceValues& force, FaceValues& velocity) {
    scatter(force, false);
    response_.apply();
    const std::size_t length = grid_.row_length();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const HeldFaces& faces = faces_[axis];
        const std::span<const double> field = response_.field(axis);
        parallel_for(grid_.rows(), grid_.boxes[1], [&](std::size_t first, std::size_t last) {
            for (std::size_t row = first; row < last; ++row) {
                for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
                    velocity[axis][f] = field[row * length + faces.z[f]] + faces.mobility[f] * force[axis][f];
                }
            }
        });
    }
}

/// Nearly the inverse of `velocities`: minus the Laplacian, weaker where a face may move.
void HeldForces::precondition(const FaceValues& residual, FaceValues& result) {
    scatter(residual, true);
    const double d = laplacian_diagonal(grid_.spacing);
    const double wx = 1 / (grid_.spacing.x * grid_.spacing.x), wy = 1 / (grid_.spacing.y * grid_.spacing.y),
                 wz = 1 / (grid_.spacing.z * grid_.spacing.z);
    const std::size_t length = grid_.row_length();
    const auto [nx, ny, nz] = grid_.boxes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const HeldFaces& faces = faces_[axis];
        const std::span<const double> field = response_.field(axis);
        parallel_for(nx, 1, [&](std::size_t x, std::size_t) {
            const auto row_at = [&](std::size_t i, std::size_t j) { return &field[(i * ny + j) * length]; };
            for (std::size_t y = 0; y < ny; ++y) {
                const double* const here = row_at(x, y);
                const double* const left = row_at(x == 0 ? nx - 1 : x - 1, y);
                const double* const right = row_at(x + 1 == nx ? 0 : x + 1, y);
                const double* const front = row_at(x, y == 0 ? ny - 1 : y - 1);
                const double* const back = row_at(x, y + 1 == ny ? 0 : y + 1);
                const std::size_t row = x * ny + y;
                for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
                    const std::size_t z = faces.z[f], below = z == 0 ? nz - 1 : z - 1, above = z + 1 == nz ? 0 : z + 1;
                    const double laplacian = d * here[z] - wx * (left[z] + right[z]) - wy * (front[z] + back[z]) -
                                             wz * (here[below] + here[above]);
                    result[axis][f] = laplacian / std::sqrt(1 + faces.mobility[f] * d);
                }
            }
        });
    }
}

UnitFlow HeldForces::solve(const Vec3& direction, const SolverLimits& limits, const Pulse& pulse) {
    FaceValues force = values_like(faces_), residual = values_like(faces_), step = values_like(faces_),
               work = values_like(faces_);
    for (int axis = 0; axis < 3; ++axis) { // all that drives the water ends in the grains: evenly, to begin with
        std::vector<double>& f = force[static_cast<std::size_t>(axis)];
        f.assign(f.size(), direction[axis] * static_cast<double>(grid_.size()) / static_cast<double>(f.size()));
    }
    UnitFlow flow;
    velocities(force, residual);
    flow.velocity = take_mean_away(residual);
    const double first = std::sqrt(dot(residual, residual));
    double product = 0;
    flow.residual = first > 0 ? 1 : 0;
    while (flow.residual > limits.tolerance) {
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
        precondition(residual, work);
        take_mean_away(work);
        const double last = product;
        product = dot(residual, work);
        add(step, flow.iterations == 0 ? 0 : product / last, work, Scale::First);
        velocities(step, work);
        const Vec3 drift = take_mean_away(work);
        const double length = product / dot(step, work);
        add(force, -length, step, Scale::Second);
        add(residual, -length, work, Scale::Second);
        flow.velocity -= length * drift;
        flow.residual = std::sqrt(dot(residual, residual)) / first;
        ++flow.iterations;
    }
    flow.force.assign(grains_, {});
    const double box = grid_.spacing.x * grid_.spacing.y * grid_.spacing.z;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        for (std::size_t f = 0; f < faces_[a].size(); ++f) {
            flow.force[faces_[a].grain[f]][axis] += box * force[a][f];
        }
    }
    return flow;
}

} // namespace suffuse::stokes
