#include "suffuse/stokes/response.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/parallel.hpp"

#include <cmath>
#include <fftw3.h>
#include <mutex>
#include <new>
#include <numbers>
#include <vector>

namespace suffuse::stokes {
namespace {

std::mutex planner; // FFTW plans one transform at a time

/// Of a forward difference over one of n boxes, for each wave number up to `kept`: (exp(2 pi i k/n) - 1)/spacing.
std::vector<std::array<double, 2>> difference_symbol(std::size_t n, std::size_t kept, double spacing) {
    std::vector<std::array<double, 2>> symbol(kept);
    for (std::size_t k = 0; k < kept; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
        symbol[k] = {(std::cos(angle) - 1) / spacing, std::sin(angle) / spacing};
    }
    return symbol;
}

fftw_complex* as_complex(double* numbers) {
    return reinterpret_cast<fftw_complex*>(numbers);
}

} // namespace

/// Transforms of single lines, many at a time; threads share the lines, so that none depends on how many there are.
struct Response::Plans {
    fftw_plan rows, rows_back;       ///< along z, of a plane x
    fftw_plan columns, columns_back; ///< along y, of a plane x
    fftw_plan across, across_back;   ///< along x, for a y
};

void Response::Free::operator()(double* memory) const {
    fftw_free(memory);
}

Response::Response(const Grid& grid) : grid_(grid), plans_(std::make_unique<Plans>()) {
    const std::size_t half = grid.row_length() / 2;
    for (std::size_t a = 0; a < 3; ++a) {
        fields_[a].reset(fftw_alloc_real(grid.field_size()));
        if (!fields_[a]) {
            throw std::bad_alloc();
        }
        difference_[a] =
            difference_symbol(grid.boxes[a], a == 2 ? half : grid.boxes[a], grid.spacing[static_cast<int>(a)]);
    }
    const int nx = static_cast<int>(grid.boxes[0]), ny = static_cast<int>(grid.boxes[1]);
    const int nz = static_cast<int>(grid.boxes[2]), nh = static_cast<int>(half);
    double* const f = fields_[0].get();
    fftw_complex* const c = as_complex(f);
    const unsigned quick = FFTW_ESTIMATE; // plans by measuring would differ from run to run
    const std::scoped_lock one_at_a_time(planner);
    plans_->rows = fftw_plan_many_dft_r2c(1, &nz, ny, f, nullptr, 1, 2 * nh, c, nullptr, 1, nh, quick);
    plans_->rows_back = fftw_plan_many_dft_c2r(1, &nz, ny, c, nullptr, 1, nh, f, nullptr, 1, 2 * nh, quick);
    const auto many = [&](int n, int stride, int direction) {
        return fftw_plan_many_dft(1, &n, nh, c, nullptr, stride, 1, c, nullptr, stride, 1, direction, quick);
    };
    plans_->columns = many(ny, nh, FFTW_FORWARD);
    plans_->columns_back = many(ny, nh, FFTW_BACKWARD);
    plans_->across = many(nx, ny * nh, FFTW_FORWARD);
    plans_->across_back = many(nx, ny * nh, FFTW_BACKWARD);
}

Response::~Response() {
    const std::scoped_lock one_at_a_time(planner);
    for (fftw_plan plan :
         {plans_->rows, plans_->rows_back, plans_->columns, plans_->columns_back, plans_->across,
          plans_->across_back}) {
        fftw_destroy_plan(plan);
    }
}

void Response::transform_planes(bool forward) {
    const std::size_t planes = grid_.boxes[0], length = grid_.boxes[1] * grid_.row_length();
    parallel_for(3 * planes, 1, [&](std::size_t i, std::size_t) {
        double* const plane = fields_[i / planes].get() + (i % planes) * length;
        fftw_complex* const waves = as_complex(plane);
        if (forward) {
            fftw_execute_dft_r2c(plans_->rows, plane, waves);
            fftw_execute_dft(plans_->columns, waves, waves);
        } else {
            fftw_execute_dft(plans_->columns_back, waves, waves);
            fftw_execute_dft_c2r(plans_->rows_back, waves, plane);
        }
    });
}

/// Of waves k of the force f: velocity (f - conj(d) (d . f)/|d|2)/|d|2, d the symbol of the forward difference; the
/// middle term is the pressure's, which keeps the velocity free of sources.
void Response::respond_and_transform_back(std::size_t y) {
    const std::size_t half = grid_.row_length() / 2, step = grid_.boxes[1] * half;
    std::array<fftw_complex*, 3> line{};
    for (std::size_t a = 0; a < 3; ++a) {
        line[a] = as_complex(fields_[a].get()) + y * half;
        fftw_execute_dft(plans_->across, line[a], line[a]);
    }
    const double boxes = static_cast<double>(grid_.size()); // what the transforms there and back multiply by
    const auto [dy_re, dy_im] = difference_[1][y];
    for (std::size_t x = 0; x < grid_.boxes[0]; ++x) {
        const auto [dx_re, dx_im] = difference_[0][x];
        for (std::size_t z = 0; z < half; ++z) {
            const auto [dz_re, dz_im] = difference_[2][z];
            double* const fx = line[0][x * step + z];
            double* const fy = line[1][x * step + z];
            double* const fz = line[2][x * step + z];
            const double d2 =
                dx_re * dx_re + dx_im * dx_im + (dy_re * dy_re + dy_im * dy_im) + (dz_re * dz_re + dz_im * dz_im);
            const double inverse = d2 > 0 ? 1 / d2 : 0;
            const double p_re =
                (dx_re * fx[0] - dx_im * fx[1] + (dy_re * fy[0] - dy_im * fy[1]) + (dz_re * fz[0] - dz_im * fz[1])) *
                inverse;
            const double p_im =
                (dx_re * fx[1] + dx_im * fx[0] + (dy_re * fy[1] + dy_im * fy[0]) + (dz_re * fz[1] + dz_im * fz[0])) *
                inverse;
            const double factor = inverse / boxes;
            fx[0] = (fx[0] - (dx_re * p_re + dx_im * p_im)) * factor;
            fx[1] = (fx[1] - (dx_re * p_im - dx_im * p_re)) * factor;
            fy[0] = (fy[0] - (dy_re * p_re + dy_im * p_im)) * factor;
            fy[1] = (fy[1] - (dy_re * p_im - dy_im * p_re)) * factor;
            fz[0] = (fz[0] - (dz_re * p_re + dz_im * p_im)) * factor;
            fz[1] = (fz[1] - (dz_re * p_im - dz_im * p_re)) * factor;
        }
    }
    for (fftw_complex* waves : line) {
        fftw_execute_dft(plans_->across_back, waves, waves);
    }
}

void Response::apply() {
    transform_planes(true);
    parallel_for(grid_.boxes[1], 1, [&](std::size_t y, std::size_t) { respond_and_transform_back(y); });
    transform_planes(false);
}

} // namespace suffuse::stokes
