#pragma once
// Packings for tests of geometry and flow: the reference's, lattices of touching spheres, and random ones.

#include "suffuse/base/vec3.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace suffuse::test {

struct Packing {
    Mat3 h; ///< [m]
    std::vector<Vec3> position;
    std::vector<double> radius;

    [[nodiscard]] std::size_t size() const { return radius.size(); }
};

/// `packing500`, `packing2000` or `packing10k` of the reference.
Packing reference_spheres(const std::string& name);

/// `cells`^3 cubes of side `a` with spheres of radius `r` at the given places, in sides.
inline Packing lattice(int cells, double a, double r, const std::vector<Vec3>& places) {
    Packing packing;
    packing.h = (cells * a) * identity();
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            for (int k = 0; k < cells; ++k) {
                for (const Vec3& s : places) {
                    packing.position.push_back(a * Vec3{i + s.x, j + s.y, k + s.z});
                    packing.radius.push_back(r);
                }
            }
        }
    }
    return packing;
}

/// Touching spheres of radius `r`: simple cubic, body-centered and face-centered.
inline Packing simple_cubic(int cells, double r) {
    return lattice(cells, 2 * r, r, {{0.1, 0.2, 0.3}});
}

inline Packing body_centered(int cells, double r) {
    return lattice(cells, 4 * r / std::sqrt(3.0), r, {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}});
}

inline Packing face_centered(int cells, double r) {
    return lattice(
        cells, 4 * r / std::sqrt(2.0), r, {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.3}, {0.6, 0.2, 0.8}, {0.1, 0.7, 0.8}}
    );
}

/// Grains without overlap at random places of the cell `h`, placed one by one, largest first; radii log-uniform between
/// `smallest` and `largest` [m].
inline Packing random_packing(const Mat3& h, std::size_t grains, double smallest, double largest, unsigned seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    Packing packing;
    packing.h = h;
    for (std::size_t g = 0; g < grains; ++g) {
        const double share = 1 - static_cast<double>(g) / static_cast<double>(grains);
        const double r = smallest * std::pow(largest / smallest, share);
        for (int attempt = 0;; ++attempt) {
            const Vec3 x = h * Vec3{uniform(), uniform(), uniform()};
            bool is_free = true;
            for (std::size_t o = 0; is_free && o <= g; ++o) {
                for (int image = 0; is_free && image < 27; ++image) {
                    if (o == g && image == 13) {
                        continue;
                    }
                    const Vec3 n{image / 9 - 1.0, image / 3 % 3 - 1.0, image % 3 - 1.0};
                    const Vec3 y = (o == g ? x : packing.position[o]) + h * n;
                    const double reach = r + (o == g ? r : packing.radius[o]);
                    is_free = norm2(x - y) >= reach * reach;
                }
            }
            if (!is_free && attempt < 100'000) {
                continue;
            }
            if (!is_free) {
                throw std::runtime_error("random_packing: no room left");
            }
            packing.position.push_back(x);
            packing.radius.push_back(r);
            break;
        }
    }
    return packing;
}

} // namespace suffuse::test
