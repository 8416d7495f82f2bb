#include "suffuse/stokes/grid.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::stokes {
namespace {

bool is_smooth(std::size_t n) {
    for (const std::size_t factor : {2, 3, 5, 7}) {
        while (n % factor == 0) {
            n /= factor;
        }
    }
    return n == 1;
}

} // namespace

std::size_t boxes_along(double spacings) {
    const auto least = static_cast<std::size_t>(std::ceil(spacings));
    std::size_t n = std::max<std::size_t>(least + least % 2, 4);
    while (!is_smooth(n)) {
        n += 2;
    }
    return n;
}

bool is_right_angled(const Mat3& h) {
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            if (a != b && std::abs(h(a, b)) > 1e-12 * std::abs(h(a, a))) {
                return false;
            }
        }
    }
    return true;
}

Grid grid_over(const Mat3& h, double spacing) {
    if (!is_right_angled(h)) {
        throw GeometryError("resolved flow: the cell is sheared; a right-angled cell along x, y, z is expected. The "
                            "pore network takes cells of any shape");
    }
    Grid grid;
    double total = 1;
    for (int a = 0; a < 3; ++a) {
        if (!(h(a, a) > 0)) {
            throw GeometryError("resolved flow: the cell has no positive width along each of x, y, z");
        }
        total *= h(a, a) / spacing;
    }
    if (!(total < 2147483648.0)) {
        throw GeometryError(fmt::format(
            "resolved flow: boxes of {:.3g} m make {:.3g} of them, more than 2^31; use fewer across a diameter",
            spacing, total
        ));
    }
    for (int a = 0; a < 3; ++a) {
        const auto boxes = boxes_along(h(a, a) / spacing);
        grid.boxes[static_cast<std::size_t>(a)] = boxes;
        grid.spacing[a] = h(a, a) / static_cast<double>(boxes);
    }
    return grid;
}

} // namespace suffuse::stokes
