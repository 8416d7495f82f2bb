#pragma once
// Which key fills which field, once for reading and writing: `v` is a Reader or a Writer.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/special_fields.hpp"
#include "suffuse/casefile/stack_fields.hpp"
#include "suffuse/casefile/weight_fields.hpp"
#include "suffuse/casefile/writer.hpp"

namespace suffuse::casefile {

template <class V>
void top_fields(V& v, Case& c) {
    v.field("schema", c.schema);
    v.field("title", c.title);
    v.field("paper", c.paper);
    v.field("seed", c.seed);
    v.choice("mode", c.mode, names::mode);
}

template <class V>
void grain_fields(V& v, grains::Material& m) {
    v.field("density", m.density);
}

template <class V>
void contact_fields(V& v, grains::Material& m, double& damping) {
    v.choice("law", m.law, names::law);
    v.field("modulus", m.modulus);
    spring_fields(v, m);
    v.field("friction", m.friction);
    v.field("rolling_stiffness", m.rolling_stiffness);
    v.field("rolling_friction", m.rolling_friction);
    v.field("twisting_stiffness", m.twisting_stiffness);
    v.field("twisting_friction", m.twisting_friction);
    v.field("damping", damping);
    v.field("viscous_damping", m.viscous_damping);
    v.table("adhesion", [&](auto& a) {
        a.field("normal", m.adhesion_normal);
        a.field("shear", m.adhesion_shear);
    });
    check_law(v, m);
}

template <class V>
void fields(V& v, dem::BalanceSpec& s) {
    v.field("unbalanced_force", s.unbalanced_force);
    v.field("stress_error", s.stress_error);
    v.field("patience", s.patience);
}

/// A run of before the key `conductance` goes on with the law of then, and with a resolved case that does not name it.
template <class V>
void fluid_fields(V& v, Case& c) {
    v.field("density", c.fluid.density);
    v.field("viscosity", c.fluid.viscosity);
    v.field("bulk_modulus", c.fluid.bulk_modulus);
    if constexpr (V::reads) {
        c.names_conductance = !v.context().is_resolved || v.has("conductance");
        c.fluid.conductance = c.names_conductance ? c.fluid.conductance : flow::Conductance::Yade;
    }
    if (c.names_conductance) {
        v.choice("conductance", c.fluid.conductance, names::conductance);
    }
}

template <class V>
void fields(V& v, OutputSpec& s) {
    v.field("formats", s.formats);
    snapshot_field(v, s.snapshots);
    v.field("checkpoint", s.checkpoint);
    v.table("histories", [&](auto& h) { h.field("every", s.histories_every); });
}

/// Written only where the case gives them: runs of before these keys stay those of their cases.
template <class V>
void text_field(V& v, const char* key, std::string& text) {
    if (V::reads || !text.empty()) {
        v.field(key, text);
    }
}

template <class V>
void fields(V& v, ReportSpec& s) {
    text_field(v, "project", s.project);
    text_field(v, "author", s.author);
    v.field("figures", s.figures);
    v.choice("psd_axis", s.reversed_size_axis, names::size_axis);
    v.choice("dilation", s.dilation_up, names::dilation);
    overlay_field(v, s.overlay);
}

template <class V>
void fields(V& v, ImportSpec& s) {
    packing_field(v, s);
    contacts_field(v, s);
    cell_field(v, s.cell);
    v.field("unit", s.unit);
    v.field("radius", s.radius);
    gradient_field(v, s.velocity_gradient);
    v.field("max_overlap", s.max_overlap);
}

template <class V>
void fields(V& v, packing::PackSpec& s) {
    layers_fields(v, s);
    v.field("porosity", s.porosity);
}

/// Written only where they are released: runs and cached stages of before this key stay those of their cases.
template <class V>
void shear_stresses_field(V& v, bool& released) {
    if (V::reads || released) {
        v.choice("shear_stresses", released, names::shear_stresses);
    }
}

template <class V>
void fields(V& v, packing::CompactSpec& s) {
    v.field("pressure", s.pressure);
    shear_stresses_field(v, s.shear_released);
    v.choice("protocol", s.protocol, names::protocol);
    v.field("start_porosity", s.start_porosity);
    v.table("prepare", [&](auto& p) {
        p.field("friction", s.prepare.friction);
        p.table("adhesion", [&](auto& a) {
            a.field("normal", s.prepare.adhesion_normal);
            a.field("shear", s.prepare.adhesion_shear);
        });
        p.field("skeleton_first", s.prepare.skeleton_first);
    });
    v.field("void_ratio", s.void_ratio);
    v.field("intergranular_void_ratio", s.intergranular_void_ratio);
    v.field("void_ratio_tolerance", s.void_ratio_tolerance);
    v.choice("if_unreachable", s.if_unreachable, names::if_unreachable);
    v.table("prepared_as", s.prepared_as, [](auto& p, double& content) { p.field("fines_content", content); });
    v.field("max_rate", s.max_rate);
    v.time_step(s.time_step);
    check_start(v, s);
    check_void_ratio(v, s);
    check_skeleton_first(v, s);
    check_shear_stresses(v, s);
}

template <class V>
void fields(V& v, cell::ServoSpec& s) {
    v.choice("kind", s.kind, names::servo_kind);
    v.field("mass", s.mass);
    v.field("damping", s.damping);
    v.field("max_rate", s.max_rate);
    v.field("response", s.response);
}

template <class V>
void servo_field(V& v, cell::ServoSpec& s) {
    v.table("servo", [&](auto& inner) {
        fields(inner, s);
        check_servo(inner, s);
    });
}

template <class V>
void fields(V& v, dem::SettleSpec& s) {
    settle_stress_fields(v, s.loading);
    shear_stresses_field(v, s.loading.shear_released);
    servo_field(v, s.loading.servo);
    v.time_step(s.time_step);
    v.field("max_steps", s.max_steps);
    check_shear_stresses(v, s);
}

template <class V>
void fields(V& v, dem::AdvanceSpec& s) {
    v.field("steps", s.steps);
    v.time_step(s.time_step);
    loading_fields(v, s.loading);
    servo_field(v, s.loading.servo);
}

/// How quickly a test loads, and how closely it is recorded.
template <class V>
void pace_fields(V& v, triaxial::TriaxialSpec& s) {
    inertial_number_field(v, s.inertial_number);
    v.choice("inertia", s.inertia, names::grain_inertia);
    v.time_step(s.time_step);
    v.field("rows", s.rows);
}

template <class V>
void fields(V& v, triaxial::TriaxialSpec& s) {
    v.choice("path", s.path, names::triaxial_path);
    v.choice("axis", s.axis, names::axis);
    if (V::reads || s.direction != triaxial::Direction::Compression) { // as of old, see solver_fields
        v.choice("direction", s.direction, names::direction);
    }
    v.field("b", s.b);
    v.field("strain", s.strain);
    v.field("strain_ratio", s.strain_ratio);
    v.field("deviator_stress", s.deviator_stress);
    v.field("stress_ratio", s.stress_ratio);
    pace_fields(v, s);
    check_path(v, s);
}

/// Of the verbs that go from stress to stress.
template <class V>
void stresses_fields(V& v, triaxial::TriaxialSpec& s) {
    v.choice("axis", s.axis, names::axis);
    v.field("stresses", s.stresses);
    v.field("strain", s.strain);
    pace_fields(v, s);
}

template <class V>
void fields(V& v, triaxial::OedometerSpec& s) {
    stresses_fields(v, s);
}

template <class V>
void fields(V& v, triaxial::IsotropicSpec& s) {
    stresses_fields(v, s);
}

template <class V>
void fields(V& v, triaxial::PlaneStrainSpec& s) {
    v.choice("axis", s.axis, names::axis);
    v.choice("direction", s.direction, names::direction);
    v.field("strain", s.strain);
    pace_fields(v, s);
}

template <class V>
void fields(V& v, triaxial::ShearSpec& s) {
    v.choice("hold", s.path, names::shear_hold);
    v.choice("axes", s.shear_axes, names::shear_axes);
    v.field("strain", s.strain);
    pace_fields(v, s);
    s.axis = s.shear_axes.normal;
}

template <class V>
void fields(V& v, triaxial::CyclicSpec& s) {
    triaxial::Cycles& cycles = *s.cycles;
    v.choice("drainage", s.path, names::drainage);
    v.choice("axis", s.axis, names::axis);
    v.field("csr", cycles.csr);
    v.field("strain_amplitude", cycles.strain);
    v.field("cycles", cycles.number);
    v.table("until", [&](auto& inner) {
        inner.field("pore_pressure_ratio", cycles.pore_pressure_ratio);
        inner.field("double_amplitude", cycles.double_amplitude);
    });
    s.strain = cycles.double_amplitude; // for the rows
    pace_fields(v, s);
    check_cycles(v, s);
}

template <class V>
void fields(V& v, triaxial::StiffnessSpec& s) {
    v.field("increment", s.increment);
    v.field("unbalanced_force", s.unbalanced_force);
    v.field("max_steps", s.max_steps);
    v.time_step(s.time_step);
}

template <class V>
void fields(V& v, triaxial::StressProbeSpec& s) {
    v.choice("axis", s.axis, names::axis);
    v.field("directions", s.directions);
    v.field("increment", s.increment);
    v.field("ramp", s.ramp);
    v.field("unbalanced_force", s.unbalanced_force);
    v.field("max_strain", s.max_strain);
    v.field("max_steps", s.max_steps);
    v.time_step(s.time_step);
}

/// Written where they are not as of old, so that the resolved cases of earlier runs stay what they are.
template <class V>
void solver_fields(V& v, flow::SolverChoice& s) {
    if (V::reads || s.solver != flow::SolverChoice{}.solver) {
        v.choice("solver", s.solver, names::solver);
    }
    v.field("resolve", s.resolve);
    if (V::reads || s.resolve_tolerance != flow::SolverChoice{}.resolve_tolerance) {
        v.field("resolve_tolerance", s.resolve_tolerance);
    }
}

template <class V>
void fields(V& v, flow::FlowSpec& s) {
    v.field("gradient", s.gradient);
    v.direction(s.direction);
    v.field("tensor", s.tensor);
    solver_fields(v, s.how);
}

template <class V>
void fields(V& v, erosion::Gravity& s) {
    v.direction(s.down, "down");
    v.field("acceleration", s.acceleration);
}

/// Settings of a probe of fines without weight; with weight none of them has a meaning.
template <class V>
void weightless_fields(V& v, erosion::ProbeSpec& probe) {
    if (V::reads || !probe.gravity) {
        v.field("ramp", probe.ramp);
        v.field("watch", probe.watch);
        v.field("probe_unbalanced_force", probe.unbalanced_force);
        v.field("relax_limit", probe.relax_limit);
    }
    check_weightless(v, probe);
}

/// Settings of a probe of fines that have weight; without weight none of them has a meaning.
template <class V>
void weighed_fields(V& v, erosion::ProbeSpec& probe) {
    if (V::reads || probe.gravity) {
        v.field("hold_at_most", probe.weighed.hold_at_most);
        v.field("fluid_drag", probe.weighed.fluid_drag);
        v.field("moved", probe.weighed.moved);
        v.field("softness", probe.weighed.softness);
    }
    check_weighed(v, probe);
}

template <class V>
void fields(V& v, erosion::DetachStageSpec& s) {
    take_gravity(v, s.probe.gravity);
    gradients_field(v, s);
    v.direction(s.direction);
    v.field("asked_gradient", s.specified_gradient);
    v.choice("hold", s.probe.hold_coarse, names::hold);
    check_hold(v, s.probe, s.probe.hold_coarse);
    weightless_fields(v, s.probe);
    weighed_fields(v, s.probe);
    solver_fields(v, s.probe.flow);
    if (V::reads || !s.probe.gravity) {
        v.table("detached", [&](auto& inner) { fields(inner, s.detached); });
    }
    check_ramp(v, s);
}

template <class V>
void resettle_fields(V& v, erosion::ResettleSpec& s) {
    v.field("max_strain", s.max_strain);
    v.field("inertial_number", s.inertial_number);
}

template <class V>
void fields(V& v, erosion::ErodeSpec& s) {
    v.field("passes", s.passes);
    v.field("until_nothing_leaves", s.until_nothing_leaves);
    v.table("until_eroded", s.until_eroded, [](auto& inner, erosion::ErodedTarget& target) {
        inner.field("share", target.share);
        inner.choice("of", target.of, names::eroded_of);
    });
    take_gravity(v, s.probe.gravity);
    gradient_of_passes(v, s);
    v.direction(s.direction);
    hold_of_passes(v, s);
    weightless_fields(v, s.probe);
    weighed_fields(v, s.probe);
    solver_fields(v, s.probe.flow);
    rule_of_passes(v, s);
    v.table("passes_constriction", [&](auto& inner) {
        auto of = names::Of::Coarse;
        inner.choice("size", s.passes_constriction, names::constriction_size);
        inner.choice("of", of, names::constrictions_of);
        inner.choice("merge", s.merge, names::void_merge);
        inner.field("distance", s.transport_distance);
    });
    v.table("forced", s.forced, [](auto& inner, erosion::ForcedRemoval& f) {
        inner.field("max_contacts", f.max_contacts);
    });
    resettle_fields(v, s.resettle);
    auto then = names::Then::Settle;
    v.choice("then", then, names::then);
}

template <class V>
void fields(V& v, erosion::RemoveSpec& s) {
    v.choice("grains", s.grains, names::removed_fines);
    v.field("share", s.share);
    v.choice("order", s.order, names::removal_order);
    v.field("passes", s.passes);
    resettle_fields(v, s.resettle);
}

template <class V>
void fields(V& v, erosion::MigrateSpec& s) {
    take_gravity(v, s.gravity);
    v.field("gradients", s.gradients);
    v.direction(s.direction);
    v.field("exit", s.exit);
    v.choice("skeleton", s.skeleton, names::skeleton);
    v.field("hold_at_most", s.hold_at_most);
    v.field("still", s.still);
    v.field("still_for", s.still_for);
    v.field("softness", s.softness);
    v.field("friction", s.friction);
    v.field("with_water", s.with_water);
    v.field("solve_after", s.solve_after);
    v.field("feed", s.feed);
    v.field("time_at_most", s.time_at_most);
    v.field("steps_at_most", s.steps_at_most);
    check_migration(v, s);
}

/// What every stage has besides its own keys; `name` and `do` are read before, for they say which keys these are.
template <class V>
void stage_fields(V& v, Stage& s) {
    v.field("from", s.from);
    v.table("record", [&](auto& r) { r.field("every", s.record_every); });
    v.field("restore", s.restore);
    v.field("measure", s.measure);
    sweep_field(v, "only", s.only);
}

} // namespace suffuse::casefile
