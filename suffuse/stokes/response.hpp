#pragma once
// The velocity of a viscous incompressible fluid without grains under a given body force, in a periodic cell: by
// Fourier transforms, exactly as the differences of the staggered grid ask for.

#include "suffuse/stokes/grid.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace suffuse::stokes {

/// Fields and their transforms. One at a time: it works in its own memory. The bits of a transform do not depend on the
/// number of threads; another kind of processor may round it otherwise.
class Response {
public:
    explicit Response(const Grid& grid);
    ~Response();
    Response(const Response&) = delete;
    Response& operator=(const Response&) = delete;

    /// The component along `axis` [grid.field_size()]: rows (x boxes[1] + y) of row_length() numbers.
    [[nodiscard]] std::span<double> field(std::size_t axis) { return {fields_[axis].get(), grid_.field_size()}; }

    /// Replaces the force per volume over the viscosity [1/(m s)] by the velocity [m/s] whose mean is zero.
    void apply();

private:
    struct Plans;

    struct Free {
        void operator()(double* memory) const;
    };

    void transform_planes(bool forward);
    void respond_and_transform_back(std::size_t y);

    Grid grid_;
    std::array<std::unique_ptr<double, Free>, 3> fields_;
    std::array<std::vector<std::array<double, 2>>, 3> difference_; ///< of each axis: symbol of the forward difference
    std::unique_ptr<Plans> plans_;
};

} // namespace suffuse::stokes
