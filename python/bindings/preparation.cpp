// What makes a sample: a cloud of grains, and its compaction to a pressure and a void ratio.

#include "suffuse/dem/inspect.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/seed.hpp"
#include "suffuse/packing/target_density.hpp"
#include "suffuse/run/measure.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/stage_work.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/views.hpp"
#include "python/bindings/warn_caller.hpp"
#include "python/bindings/work.hpp"
#include <algorithm>

namespace suffuse::python {
namespace {

packing::Protocol protocol_of(const std::string& word) {
    for (const auto& [protocol, name] : casefile::names::protocol) {
        if (word == name) {
            return protocol;
        }
    }
    throw CaseError(fmt::format("protocol: found \"{}\", expected faithful, swift, slow or wide", word));
}

/// One compaction, to its end or until it is seen to miss a specified void ratio.
packing::CompactState compact_once(
    Stepping& call, const packing::CompactSpec& spec, const dem::BalanceSpec& balance, double damping,
    Attention& attention
) {
    dem::World& world = call.world();
    packing::CompactState state;
    state.material = world.material;
    const Loan loan(call, state);
    state = packing::begin_compaction(world, spec, damping);
    for (bool done = false; !done && !packing::misses_void_ratio(world, spec, state);) {
        done = packing::compact_burst(world, call.caches(), spec, balance, state);
        call.remember_place();
        attention.beat("compact", state.steps);
    }
    return state;
}

/// The arguments are keys of a stage that does "compact".
packing::CompactSpec spec_of(
    const py::object& pressure, const py::object& friction, const py::object& adhesion_normal,
    const py::object& adhesion_shear, const py::object& void_ratio, const py::object& void_ratio_tolerance,
    const std::string& protocol, const py::object& max_rate, const std::string& shear_stresses
) {
    const auto key = [](const char* name) -> const casefile::Key& { return key_of("stage.compact", name); };
    const auto adhesion = [](const char* name, const py::object& value) {
        return optional_value_of(
            key_of("stage.compact.prepare.adhesion", name), value, fmt::format("adhesion_{}", name)
        );
    };
    packing::CompactSpec spec;
    spec.protocol = protocol_of(protocol);
    spec.shear_released = word_of(shear_stresses, casefile::names::shear_stresses, "shear_stresses");
    spec.max_rate = optional_value_of(key("max_rate"), max_rate, "max_rate");
    spec.pressure = value_of(key("pressure"), pressure, "pressure");
    spec.prepare.friction = optional_value_of(key_of("stage.compact.prepare", "friction"), friction, "friction");
    spec.prepare.adhesion_normal = adhesion("normal", adhesion_normal);
    spec.prepare.adhesion_shear = adhesion("shear", adhesion_shear);
    spec.void_ratio = optional_value_of(key("void_ratio"), void_ratio, "void_ratio");
    spec.void_ratio_tolerance = value_of(key("void_ratio_tolerance"), void_ratio_tolerance, "void_ratio_tolerance");
    if (spec.void_ratio && spec.prepare.friction && spec.protocol != packing::Protocol::Swift) {
        throw CaseError(fmt::format(
            "friction: found {}, together with a void_ratio, for which protocol \"{}\" searches the friction; leave "
            "one of the two out, or take protocol=\"swift\"",
            print_quantity(*spec.prepare.friction, dimension::angle), protocol
        ));
    }
    if (spec.shear_released && spec.protocol == packing::Protocol::Slow) {
        throw CaseError(
            "shear_stresses: found \"released\", which the servo of protocol \"slow\" cannot; take another protocol"
        );
    }
    return spec;
}

py::dict compact(
    WorldHandle& w, const Quantity& pressure, const QuantityOrNone& friction, const QuantityOrNone& adhesion_normal,
    const QuantityOrNone& adhesion_shear, const QuantityOrNone& void_ratio, const Quantity& void_ratio_tolerance,
    const std::string& protocol, const QuantityOrNone& max_rate, const std::string& shear_stresses,
    const dem::BalanceSpec& balance, const Quantity& damping, const CallableOrNone& on_progress
) {
    const packing::CompactSpec spec = spec_of(
        pressure, friction, adhesion_normal, adhesion_shear, void_ratio, void_ratio_tolerance, protocol, max_rate,
        shear_stresses
    );
    const double given_damping = value_of(key_of("contact", "damping"), damping, "damping");
    packing::CompactState state;
    Stepping call(w);
    refuse_too_soft(call.world().material, spec.pressure);
    Attention attention(on_progress, call);
    py::dict dict;
    begin(call);
    if (!spec.void_ratio) {
        const Working working;
        state = compact_once(call, spec, balance, given_damping, attention);
    } else {
        packing::FoundDensity found;
        {
            const Working working;
            const dem::World cloud = call.world();
            const auto start_again = [&] {
                call.world() = cloud;
                call.drop_caches();
            };
            try {
                found = packing::search_void_ratio(spec, cloud.material, [&](const packing::CompactSpec& trial) {
                    start_again();
                    state = compact_once(call, trial, balance, given_damping, attention);
                    return dem::void_ratio(call.world());
                });
            } catch (...) {
                start_again(); // the last trial is nothing that was requested
                throw;
            }
        }
        dict["void_ratio"] = found.void_ratio;
        dict["trials"] = found.trials;
        dict["preparation_friction"] = found.spec.prepare.friction.value_or(call.world().material.friction);
    }
    warn_caller(run::words_on_overlap(state.balance.equilibrium.max_overlap_ratio, call.world().material));
    dict["steps"] = state.steps;
    dict["void_ratio_compacted"] = state.void_ratio_compacted;
    return dict;
}

Handle make_cloud(
    const Numbers& radius, const Quantity& porosity, const NumbersOrNone& fine, const grains::Material& material,
    std::uint64_t seed
) {
    const std::vector<double> radii = numbers_of(radius, "radius");
    if (radii.empty()) {
        throw CaseError("radius: found no grains, expected the radius of one or more");
    }
    std::vector<std::uint8_t> fines(radii.size(), 0);
    if (!fine.is_none()) {
        const std::vector<double> claims = numbers_of(fine, "fine", radii.size());
        std::transform(claims.begin(), claims.end(), fines.begin(), [](double v) { return v != 0 ? 1 : 0; });
    }
    std::vector<std::size_t> order(radii.size());
    for (std::size_t g = 0; g < order.size(); ++g) {
        order[g] = g;
        if (!(radii[g] > 0)) {
            throw CaseError(fmt::format("radius: found {} at grain {}, expected a positive one", radii[g], g));
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return radii[a] > radii[b]; });
    grains::SampledGrains sample;
    for (const std::size_t g : order) {
        sample.radius.push_back(radii[g]);
        sample.fine.push_back(fines[g]);
    }
    packing::PackSpec spec;
    spec.porosity = value_of(key_of("stage.pack", "porosity"), porosity, "porosity");
    const Released released;
    packing::Cloud cloud = packing::make_cloud(sample, spec, material.density, seed, look_at_signals());
    dem::World world;
    world.cell = cloud.cell;
    world.reference_h = cloud.cell.h;
    world.grains = std::move(cloud.grains);
    world.material = material;
    world.seed = seed;
    return std::make_shared<WorldHandle>(std::move(world));
}

} // namespace

void bind_preparation(py::module_& m) {
    auto type = py::reinterpret_borrow<py::class_<WorldHandle, Handle>>(m.attr("World"));
    type.def(
        "compact", &compact, py::arg("pressure"), py::kw_only(), py::arg("friction") = py::none(),
        py::arg("adhesion_normal") = py::none(), py::arg("adhesion_shear") = py::none(),
        py::arg("void_ratio") = py::none(),
        py::arg("void_ratio_tolerance") = packing::CompactSpec{}.void_ratio_tolerance,
        py::arg("protocol") = std::string(name_of(packing::Protocol::Faithful)), py::arg("max_rate") = py::none(),
        py::arg("shear_stresses") = "kept", py::arg_v("balance", dem::BalanceSpec{}, "Balance()"),
        py::arg("damping") = dem::usual_damping, py::arg("on_progress") = py::none(),
        with_keys(
            "Compacts a cloud isotropically, then settles it with the final material, as a stage that does "
            "\"compact\". Returns a dictionary: `steps`, `void_ratio_compacted` (before settling); and, if a void "
            "ratio was specified, `void_ratio`, `trials` and `preparation_friction` [rad].\n"
            "on_progress: called as on_progress(part, steps) ten times a second at most; what it raises ends the work",
            {{"stage.compact", "pressure"},
             {"stage.compact.prepare", "friction"},
             {"contact", "damping"},
             {"stage.compact", "void_ratio"},
             {"stage.compact", "void_ratio_tolerance"},
             {"stage.compact", "protocol"},
             {"stage.compact", "max_rate"},
             {"stage.compact", "shear_stresses"}}
        ).c_str()
    );
    m.def(
        "make_cloud", &make_cloud, py::arg("radius"), py::arg("porosity") = packing::PackSpec{}.porosity, py::kw_only(),
        py::arg("fine") = py::none(), py::arg_v("material", grains::Material{}, "Material()"), py::arg("seed") = 0,
        "Grains of the given radii [m] placed at random in a periodic cube, none overlapping; the same for one seed."
    );
}

} // namespace suffuse::python
