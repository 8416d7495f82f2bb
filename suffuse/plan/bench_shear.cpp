#include "suffuse/plan/bench_shear.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/settle.hpp"

namespace suffuse::plan {
namespace {

constexpr std::int64_t most_settle_steps = 500'000;
constexpr double shear_servo_rate = 60; // largest lateral strain rate, as the reference's scene has it [1/s]

cell::Loading slow_shear(const ShearSpec& spec) {
    cell::Loading loading = dem::isotropic_stress(spec.pressure);
    loading.axis[2] = {cell::Control::StrainRate, spec.strain_rate};
    loading.servo.max_rate = shear_servo_rate;
    return loading;
}

} // namespace

BenchShear settle_for_shear(const BenchPacking& packing, const ShearSpec& spec) {
    expects(spec.time_step > 0, "a benchmark needs a time step");
    BenchShear shear{load_bench_packing(packing), {}, {}, 0, 0};
    dem::sort_along_curve(shear.world);
    shear.plan.mode = spec.mode;
    shear.plan.dt = spec.time_step;
    shear.plan.loading = dem::isotropic_stress(spec.pressure);
    const Stopwatch watch;
    shear.settle_steps = dem::settle(shear.world, shear.caches, shear.plan, {}, most_settle_steps).steps;
    shear.settle_seconds = watch.seconds();
    shear.plan.loading = slow_shear(spec);
    return shear;
}

} // namespace suffuse::plan
