#include "suffuse/stokes/response.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fftw3.h>
#include <mutex>
#include <numbers>
#include <vector>

namespace suffuse::stokes {
namespace {

std::mutex planner; // FFTW plans one transform at a time, of either precision

template <class Real>
struct Fftw;

template <>
struct Fftw<float> {
    using Plan = fftwf_plan;
    using Wave = fftwf_complex;
    static constexpr auto plan_many = fftwf_plan_many_dft;
    static constexpr auto plan_row = fftwf_plan_dft_r2c_1d;
    static constexpr auto plan_row_back = fftwf_plan_dft_c2r_1d;
    static constexpr auto run = fftwf_execute_dft;
    static constexpr auto run_row = fftwf_execute_dft_r2c;
    static constexpr auto run_row_back = fftwf_execute_dft_c2r;
    static constexpr auto destroy = fftwf_destroy_plan;
};

template <>
struct Fftw<double> {
    using Plan = fftw_plan;
    using Wave = fftw_complex;
    static constexpr auto plan_many = fftw_plan_many_dft;
    static constexpr auto plan_row = fftw_plan_dft_r2c_1d;
    static constexpr auto plan_row_back = fftw_plan_dft_c2r_1d;
    static constexpr auto run = fftw_execute_dft;
    static constexpr auto run_row = fftw_execute_dft_r2c;
    static constexpr auto run_row_back = fftw_execute_dft_c2r;
    static constexpr auto destroy = fftw_destroy_plan;
};

template <class Real>
using Wave = typename Fftw<Real>::Wave;

/// Memory of either precision.
struct alignas(64) CacheLine {
    std::array<std::byte, 64> bytes;
};

template <class Real>
std::size_t lines_for(std::size_t waves) {
    return (waves * sizeof(Wave<Real>) + sizeof(CacheLine) - 1) / sizeof(CacheLine);
}

/// Four waves are what FFTW's plans take at a time, and keep what they work on aligned as they expect. An odd number of
/// fours: what follows one another begins in different lines of a cache.
std::size_t padded(std::size_t waves) {
    return ((waves + 3) / 4 | 1) * 4;
}

/// Of the fields in waves: three axes, planes x, rows y.
struct Layout {
    std::array<std::size_t, 3> boxes;
    std::size_t half; ///< waves of a row
    std::size_t row, plane, field;

    explicit Layout(const Grid& grid)
        : boxes(grid.boxes), half(boxes[2] / 2 + 1), row(padded(half)), plane(padded(boxes[1] * row)),
          field(boxes[0] * plane) {}

    /// Waves that a task works in: a plane and a row of numbers, or one row of each x and axis.
    [[nodiscard]] std::size_t work_size() const { return std::max(plane + row, 3 * boxes[0] * row); }
};

thread_local std::vector<CacheLine> work_of_thread; // grown once

template <class Real>
Wave<Real>* working_memory(const Layout& at) {
    const std::size_t lines = lines_for<Real>(at.work_size());
    if (work_of_thread.size() < lines) {
        work_of_thread.resize(lines);
    }
    return reinterpret_cast<Wave<Real>*>(work_of_thread.data());
}

/// From one memory into another, so that FFTW needs none of its own: rows along z, columns along y of a plane,
/// lines along x of a y.
template <class Real>
struct Plans {
    using F = Fftw<Real>;
    typename F::Plan rows{}, rows_back{}, columns{}, columns_back{}, lines{}, lines_back{};

    Plans(const Layout& at, Wave<Real>* fields) {
        Wave<Real>* const work = working_memory<Real>(at);
        Real* const numbers = work[at.plane];
        const int nx = static_cast<int>(at.boxes[0]), ny = static_cast<int>(at.boxes[1]);
        const int nz = static_cast<int>(at.boxes[2]);
        const int row = static_cast<int>(at.row), plane = static_cast<int>(at.plane);
        const unsigned quick = FFTW_ESTIMATE | FFTW_DESTROY_INPUT; // plans by measuring would differ from run to run
        const auto plan = [&](int n, Wave<Real>* from, int from_step, Wave<Real>* to, int to_step, int direction) {
            return F::plan_many(1, &n, row, from, nullptr, from_step, 1, to, nullptr, to_step, 1, direction, quick);
        };
        const std::scoped_lock one_at_a_time(planner);
        rows = F::plan_row(nz, numbers, work, quick);
        rows_back = F::plan_row_back(nz, work, numbers, quick);
        columns = plan(ny, work, row, fields, row, FFTW_FORWARD);
        columns_back = plan(ny, fields, row, work, row, FFTW_BACKWARD);
        lines = plan(nx, fields, plane, work, row, FFTW_FORWARD);
        lines_back = plan(nx, work, row, fields, plane, FFTW_BACKWARD);
    }

    ~Plans() {
        const std::scoped_lock one_at_a_time(planner);
        for (const auto plan : {rows, rows_back, columns, columns_back, lines, lines_back}) {
            F::destroy(plan);
        }
    }

    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;
};

/// Of a forward difference, of some wave numbers along an axis: (exp(2 pi i k/n) - 1)/spacing.
template <class Real>
struct Symbols {
    std::vector<Real> re, im, square;

    Symbols(std::size_t n, double spacing, std::size_t kept) {
        for (std::size_t k = 0; k < kept; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k % n) / static_cast<double>(n);
            const double c = (std::cos(angle) - 1) / spacing, s = std::sin(angle) / spacing;
            re.push_back(static_cast<Real>(c));
            im.push_back(static_cast<Real>(s));
            square.push_back(static_cast<Real>(c * c + s * s));
        }
    }
};

template <class Real>
struct Tables {
    Plans<Real> plans;
    std::array<Symbols<Real>, 3> difference;
    Real factor; ///< undoes what transforms there and back multiply by

    Tables(const Grid& grid, const Layout& at, Wave<Real>* fields)
        : plans(at, fields),
          difference{
              Symbols<Real>(grid.boxes[0], grid.spacing.x, grid.boxes[0]),
              Symbols<Real>(grid.boxes[1], grid.spacing.y, grid.boxes[1]),
              Symbols<Real>(grid.boxes[2], grid.spacing.z, at.row)},
          factor(static_cast<Real>(1 / static_cast<double>(grid.size()))) {}
};

/// Of waves k of the force f: velocity (f - conj(d) (d . f)/|d|2)/|d|2, d the symbol of the forward difference; the
/// middle term is the pressure's, which keeps the velocity free of sources. In rows of one x after those of another,
/// for each axis.
template <class Real>
[[gnu::always_inline]] inline void
respond_as(const Tables<Real>& tables, const Layout& at, std::size_t y, Wave<Real>* rows) {
    const auto& [along_x, along_y, along_z] = tables.difference;
    const Real dy_re = along_y.re[y], dy_im = along_y.im[y], dy_square = along_y.square[y];
    const Real* const z_re = along_z.re.data();
    const Real* const z_im = along_z.im.data();
    const Real* const z_square = along_z.square.data();
    const std::size_t nx = at.boxes[0];
    for (std::size_t x = 0; x < nx; ++x) {
        const Real dx_re = along_x.re[x], dx_im = along_x.im[x], d2_across = along_x.square[x] + dy_square;
        Real* __restrict fx = rows[x * at.row];
        Real* __restrict fy = rows[(nx + x) * at.row];
        Real* __restrict fz = rows[(2 * nx + x) * at.row];
        for (std::size_t k = 0; k < at.row; ++k) {
            const std::size_t re = 2 * k, im = 2 * k + 1;
            const Real dz_re = z_re[k], dz_im = z_im[k], d2 = d2_across + z_square[k];
            const Real inverse = d2 > 0 ? 1 / d2 : 0;
            const Real p_re = (dx_re * fx[re] - dx_im * fx[im] + (dy_re * fy[re] - dy_im * fy[im]) +
                               (dz_re * fz[re] - dz_im * fz[im])) *
                              inverse;
            const Real p_im = (dx_re * fx[im] + dx_im * fx[re] + (dy_re * fy[im] + dy_im * fy[re]) +
                               (dz_re * fz[im] + dz_im * fz[re])) *
                              inverse;
            const Real factor = inverse * tables.factor;
            fx[re] = (fx[re] - (dx_re * p_re + dx_im * p_im)) * factor;
            fx[im] = (fx[im] - (dx_re * p_im - dx_im * p_re)) * factor;
            fy[re] = (fy[re] - (dy_re * p_re + dy_im * p_im)) * factor;
            fy[im] = (fy[im] - (dy_re * p_im - dy_im * p_re)) * factor;
            fz[re] = (fz[re] - (dz_re * p_re + dz_im * p_im)) * factor;
            fz[im] = (fz[im] - (dz_re * p_im - dz_im * p_re)) * factor;
        }
    }
}

// One for each precision, as what is compiled for several processors cannot be a template.
SUFFUSE_CLONES void respond(const Tables<float>& tables, const Layout& at, std::size_t y, Wave<float>* rows) {
    respond_as(tables, at, y, rows);
}

SUFFUSE_CLONES void respond(const Tables<double>& tables, const Layout& at, std::size_t y, Wave<double>* rows) {
    respond_as(tables, at, y, rows);
}

template <class Real>
void apply_as(
    const Tables<Real>& tables, const Layout& at, Wave<Real>* fields, const RowWork<Real>& fill,
    const RowWork<Real>& take
) {
    using F = Fftw<Real>;
    const Plans<Real>& plans = tables.plans;
    const std::size_t nx = at.boxes[0], ny = at.boxes[1], nz = at.boxes[2];
    parallel_for(3 * nx, 1, [&](std::size_t i, std::size_t) {
        Wave<Real>* const work = working_memory<Real>(at);
        const std::span<Real> numbers(work[at.plane], nz);
        for (std::size_t y = 0; y < ny; ++y) {
            Wave<Real>* const row = work + y * at.row;
            std::fill(numbers.begin(), numbers.end(), Real{});
            fill(i / nx, i % nx * ny + y, numbers);
            F::run_row(plans.rows, numbers.data(), row);
            std::fill(row[at.half], row[at.row], Real{});
        }
        Wave<Real>* const plane = fields + i / nx * at.field + i % nx * at.plane;
        F::run(plans.columns, work, plane);
    });
    parallel_for(ny, 1, [&](std::size_t y, std::size_t) {
        Wave<Real>* const work = working_memory<Real>(at);
        Wave<Real>* const first = fields + y * at.row;
        for (std::size_t a = 0; a < 3; ++a) {
            F::run(plans.lines, first + a * at.field, work + a * nx * at.row);
        }
        respond(tables, at, y, work);
        for (std::size_t a = 0; a < 3; ++a) {
            F::run(plans.lines_back, work + a * nx * at.row, first + a * at.field);
        }
    });
    parallel_for(3 * nx, 1, [&](std::size_t i, std::size_t) {
        Wave<Real>* const work = working_memory<Real>(at);
        const std::span<Real> numbers(work[at.plane], nz);
        Wave<Real>* const plane = fields + i / nx * at.field + i % nx * at.plane;
        F::run(plans.columns_back, plane, work);
        for (std::size_t y = 0; y < ny; ++y) {
            F::run_row_back(plans.rows_back, work + y * at.row, numbers.data());
            take(i / nx, i % nx * ny + y, numbers);
        }
    });
}

} // namespace

struct Response::Work {
    Layout at;
    std::vector<CacheLine> fields; ///< in double precision; in single precision half of it is used
    Tables<float> single_tables;
    Tables<double> double_tables;

    explicit Work(const Grid& grid)
        : at(grid), fields(lines_for<double>(3 * at.field)), single_tables(grid, at, waves<float>()),
          double_tables(grid, at, waves<double>()) {}

    template <class Real>
    Wave<Real>* waves() {
        return reinterpret_cast<Wave<Real>*>(fields.data());
    }
};

Response::Response(const Grid& grid) : work_(std::make_unique<Work>(grid)) {}

Response::~Response() = default;

void Response::apply(const RowWork<float>& fill, const RowWork<float>& take) {
    apply_as(work_->single_tables, work_->at, work_->waves<float>(), fill, take);
}

void Response::apply(const RowWork<double>& fill, const RowWork<double>& take) {
    apply_as(work_->double_tables, work_->at, work_->waves<double>(), fill, take);
}

} // namespace suffuse::stokes
