#include "suffuse/stokes/held_faces.hpp"

#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::stokes {
namespace {

/// Distance of each face to the nearest surface, negative within a grain, and that grain.
struct Distances {
    std::vector<float> distance; ///< over the largest spacing, at most `far`
    std::vector<std::uint32_t> grain;
};

constexpr float far = 1.01F; // beyond the next face

/// A grain's section with a plane of faces.
struct Section {
    std::uint32_t grain;
    double dx2; ///< squared distance of its center from the plane [m2]
};

std::size_t wrapped(std::int64_t i, std::size_t n) {
    const auto period = static_cast<std::int64_t>(n);
    return static_cast<std::size_t>((i % period + period) % period);
}

/// Whole numbers i for which |(i + offset) spacing - x| <= reach.
struct Range {
    std::int64_t first, last;

    Range(double x, double reach, double offset, double spacing)
        : first(static_cast<std::int64_t>(std::ceil((x - reach) / spacing - offset))),
          last(static_cast<std::int64_t>(std::floor((x + reach) / spacing - offset))) {}
};

double at(std::int64_t i, double offset, double spacing) {
    return (static_cast<double>(i) + offset) * spacing;
}

double largest_spacing(const Grid& grid) {
    return std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z});
}

Vec3 offsets(int axis) {
    Vec3 offset{0.5, 0.5, 0.5};
    offset[axis] = 0;
    return offset;
}

std::vector<std::vector<Section>> sections_by_plane(
    const Grid& grid, const Vec3& offset, std::span<const Vec3> position, std::span<const double> radius
) {
    std::vector<std::vector<Section>> sections(grid.boxes[0]);
    for (std::size_t g = 0; g < radius.size(); ++g) {
        const Range range(position[g].x, radius[g] + far * largest_spacing(grid), offset.x, grid.spacing.x);
        for (std::int64_t i = range.first; i <= range.last; ++i) {
            const double dx = at(i, offset.x, grid.spacing.x) - position[g].x;
            sections[wrapped(i, grid.boxes[0])].push_back({static_cast<std::uint32_t>(g), dx * dx});
        }
    }
    return sections;
}

Distances distances_of(const Grid& grid, int axis, std::span<const Vec3> position, std::span<const double> radius) {
    const Vec3 offset = offsets(axis);
    const double unit = largest_spacing(grid);
    const std::vector<std::vector<Section>> sections = sections_by_plane(grid, offset, position, radius);
    const std::size_t nx = grid.boxes[0], ny = grid.boxes[1], nz = grid.boxes[2];
    Distances result{std::vector<float>(grid.size(), far), std::vector<std::uint32_t>(grid.size())};
    parallel_for(nx, 1, [&](std::size_t x, std::size_t) {
        for (const Section& section : sections[x]) {
            const Vec3& center = position[section.grain];
            const double r = radius[section.grain], reach = r + far * unit;
            const Range ys(center.y, reach, offset.y, grid.spacing.y), zs(center.z, reach, offset.z, grid.spacing.z);
            for (std::int64_t j = ys.first; j <= ys.last; ++j) {
                const double dy = at(j, offset.y, grid.spacing.y) - center.y;
                const std::size_t row = (x * ny + wrapped(j, ny)) * nz;
                for (std::int64_t k = zs.first; k <= zs.last; ++k) {
                    const double dz = at(k, offset.z, grid.spacing.z) - center.z;
                    const auto d = static_cast<float>((std::sqrt(section.dx2 + dy * dy + dz * dz) - r) / unit);
                    const std::size_t face = row + wrapped(k, nz);
                    if (d < result.distance[face]) {
                        result.distance[face] = d;
                        result.grain[face] = section.grain;
                    }
                }
            }
        }
    });
    return result;
}

constexpr double not_held = -1;

/// Mobility of a face, or `not_held`. Where a surface lies between two faces is read off their distances.
double mobility_of(const Grid& grid, const std::vector<float>& distance, std::size_t x, std::size_t y, std::size_t z) {
    const std::size_t nx = grid.boxes[0], ny = grid.boxes[1], nz = grid.boxes[2];
    const double here = distance[(x * ny + y) * nz + z];
    if (here < 0) {
        return 0;
    }
    if (here >= static_cast<double>(far)) {
        return not_held;
    }
    double hold = 0;
    const auto look = [&](std::size_t i, std::size_t j, std::size_t k, double spacing) {
        const double there = distance[(i * ny + j) * nz + k];
        if (there < 0) {
            const double share = std::max(here / (here - there), 1e-3); // nearer the face stands still
            hold += (1 / share - 1) / (spacing * spacing);
        }
    };
    look(x == 0 ? nx - 1 : x - 1, y, z, grid.spacing.x);
    look(x + 1 == nx ? 0 : x + 1, y, z, grid.spacing.x);
    look(x, y == 0 ? ny - 1 : y - 1, z, grid.spacing.y);
    look(x, y + 1 == ny ? 0 : y + 1, z, grid.spacing.y);
    look(x, y, z == 0 ? nz - 1 : z - 1, grid.spacing.z);
    look(x, y, z + 1 == nz ? 0 : z + 1, grid.spacing.z);
    return hold > 0 ? 1 / hold : not_held;
}

HeldFaces held_faces(const Grid& grid, const Distances& found) {
    const std::size_t nx = grid.boxes[0], ny = grid.boxes[1], nz = grid.boxes[2];
    HeldFaces faces;
    faces.row_begin.assign(grid.rows() + 1, 0);
    const auto for_each_held = [&](const auto& act) { // act(row, z, mobility)
        parallel_for(nx, 1, [&](std::size_t x, std::size_t) {
            for (std::size_t y = 0; y < ny; ++y) {
                for (std::size_t z = 0; z < nz; ++z) {
                    const double mobility = mobility_of(grid, found.distance, x, y, z);
                    if (mobility != not_held) {
                        act(x * ny + y, z, mobility);
                    }
                }
            }
        });
    };
    for_each_held([&](std::size_t row, std::size_t, double) { ++faces.row_begin[row + 1]; });
    for (std::size_t row = 0; row < grid.rows(); ++row) {
        faces.row_begin[row + 1] += faces.row_begin[row];
    }
    const std::size_t count = faces.row_begin.back();
    faces.z.resize(count);
    faces.grain.resize(count);
    faces.mobility.resize(count);
    std::vector<std::size_t> next(faces.row_begin.begin(), faces.row_begin.end() - 1);
    for_each_held([&](std::size_t row, std::size_t z, double mobility) {
        const std::size_t f = next[row]++;
        faces.z[f] = static_cast<std::uint32_t>(z);
        faces.grain[f] = found.grain[row * nz + z];
        faces.mobility[f] = static_cast<float>(mobility);
    });
    return faces;
}

} // namespace

std::array<HeldFaces, 3>
find_held_faces(const Grid& grid, std::span<const Vec3> position, std::span<const double> radius) {
    std::array<HeldFaces, 3> faces;
    for (int axis = 0; axis < 3; ++axis) {
        faces[static_cast<std::size_t>(axis)] = held_faces(grid, distances_of(grid, axis, position, radius));
    }
    return faces;
}

} // namespace suffuse::stokes
