#pragma once
// The velocity of a viscous incompressible fluid without grains under a given body force, in a periodic cell: by
// Fourier transforms, exactly as the differences of the staggered grid require. In single precision it takes half the
// time; both precisions work in the same memory.

#include "suffuse/stokes/grid.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

namespace suffuse::stokes {

/// Called with axis, row x boxes[1] + y, and that row along z: all rows of one axis and x in order, in one task.
template <class Real>
using RowWork = std::function<void(std::size_t axis, std::size_t row, std::span<Real> values)>;

/// One transform at a time. Its bits do not depend on the number of threads; another kind of processor may round it
/// otherwise.
class Response {
public:
    explicit Response(const Grid& grid);
    ~Response();
    Response(const Response&) = delete;
    Response& operator=(const Response&) = delete;

    /// Of the force per volume over the viscosity [1/(m s)] that `fill` puts into rows of zeros the velocity [m/s]
    /// whose mean is zero, given to `take`.
    void apply(const RowWork<float>& fill, const RowWork<float>& take);
    void apply(const RowWork<double>& fill, const RowWork<double>& take);

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

} // namespace suffuse::stokes
