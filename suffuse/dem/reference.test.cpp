// Every trajectory of the reference, number by number, through the step that the program runs.

#include "tests/support/reference.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/step.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace suffuse::dem {
namespace {

using nlohmann::json;
using test::read_reference_json;

Vec3 vec(const json& v) {
    return {v[0], v[1], v[2]};
}

Mat3 rows(const json& m) {
    return transpose(from_columns(vec(m[0]), vec(m[1]), vec(m[2])));
}

grains::Material material_of(const json& m) {
    grains::Material material;
    material.density = m["density"];
    material.modulus = m["young"];
    material.shear_ratio = m["poisson"];
    material.friction = radians(m["phiDeg"]);
    material.rolling_stiffness = m["alphaKr"];
    material.rolling_friction = m["etaRoll"];
    material.twisting_stiffness = m["alphaKtw"];
    material.twisting_friction = m["etaTwist"];
    material.adhesion_normal = m.value("cn", 0.0);
    material.adhesion_shear = m.value("cs", 0.0);
    return material;
}

World world_of(const json& golden) {
    World world;
    world.material = material_of(golden["material"]);
    if (!golden.value("cohesionOnNewContacts", true)) {
        world.material.adhesion_normal = world.material.adhesion_shear = 0;
    }
    const json& start = golden["initial"];
    const json radii = golden.contains("r") ? golden["r"] : start["r"];
    for (std::size_t g = 0; g < radii.size(); ++g) {
        add_grain(world.grains, vec(start["pos"][g]), radii[g], world.material.density);
        world.grains.velocity[g] = vec(start["vel"][g]);
        world.grains.spin[g] = vec(start["angVel"][g]);
        if (golden.contains("bodies") && golden["bodies"][g].value("fixed", 0) != 0) {
            world.grains.motion[g] = grains::Motion::Held;
        }
    }
    if (start.contains("hSize")) {
        world.cell.h = rows(start["hSize"]);
    } else if (golden["cell"].is_null()) {
        world.cell.h = diagonal({1, 1, 1}); // so large that no image touches
    } else {
        world.cell.h = diagonal(vec(golden["cell"]));
    }
    world.reference_h = world.cell.h;
    return world;
}

/// Largest difference and largest value of a field over a trajectory.
struct Field {
    double difference = 0, scale = 0;

    void add(const Vec3& ours, const Vec3& theirs) {
        for (int a = 0; a < 3; ++a) {
            difference = std::max(difference, std::abs(ours[a] - theirs[a]));
            scale = std::max(scale, std::abs(theirs[a]));
        }
    }

    void add(double ours, double theirs) {
        difference = std::max(difference, std::abs(ours - theirs));
        scale = std::max(scale, std::abs(theirs));
    }

    /// A field that is zero throughout is held to 1e-15 of its natural scale.
    [[nodiscard]] double error(double natural_scale) const {
        return scale > 0 ? difference / scale : difference / natural_scale * 1e6;
    }
};

struct Replay {
    std::map<std::string, Field> field;
    std::int64_t steps = 0;

    /// Compares all grains of a state of the golden trajectory.
    void compare(const World& world, const json& state) {
        for (std::size_t g = 0; g < world.grains.size(); ++g) {
            field["position"].add(world.grains.position[g], vec(state["pos"][g]));
            field["velocity"].add(world.grains.velocity[g], vec(state["vel"][g]));
            field["spin"].add(world.grains.spin[g], vec(state["angVel"][g]));
            field["force"].add(world.grains.force[g], vec(state["force"][g]));
            field["torque"].add(world.grains.torque[g], vec(state["torque"][g]));
        }
        if (state.contains("hSize")) {
            const Mat3 h = rows(state["hSize"]);
            for (int b = 0; b < 3; ++b) {
                field["cell"].add(world.cell.h.column(b), h.column(b));
            }
        }
    }

    void compare_contacts(const World& world, const json& theirs) {
        const std::vector<ContactView> ours = inspect_contacts(world);
        ASSERT_EQ(ours.size(), theirs.size()) << "at step " << steps;
        for (const ContactView& c : ours) {
            const auto match = std::find_if(theirs.begin(), theirs.end(), [&](const json& t) {
                return t["id1"] == world.grains.id[c.i] && t["id2"] == world.grains.id[c.j];
            });
            ASSERT_NE(match, theirs.end());
            field["overlap"].add(c.overlap, (*match)["un"]);
            field["normal"].add(c.normal, vec((*match)["normal"]));
            field["normal force"].add(-c.normal_force, vec((*match)["fn"]));
            field["shear force"].add(-c.shear_force, vec((*match)["fs"]));
            field["moment"].add(-c.moment, vec((*match)["mb"]) + vec((*match)["mt"]));
        }
    }
};

StepPlan plan_of(const json& golden) {
    StepPlan plan;
    plan.dt = golden["dt"];
    plan.damping = golden["damping"];
    plan.turns_to_first_order = true;
    plan.loading.velocity_gradient = Mat3{};
    if (golden.contains("controller")) {
        const json& servo = golden["controller"];
        plan.loading.velocity_gradient.reset();
        plan.loading.servo = {
            cell::ServoKind::Inertial, servo["mass"], servo["growDamping"], servo["maxStrainRate"], 0};
        for (cell::AxisControl& axis : plan.loading.axis) {
            axis = {cell::Control::Stress, -servo["goal"].get<double>()};
        }
    }
    return plan;
}

void apply_events(const json& events, std::int64_t step, World& world, StepPlan& plan) {
    for (const json& event : events) {
        if (event["before_step"] != step) {
            continue;
        }
        if (event.contains("velGrad")) {
            plan.loading.velocity_gradient = rows(event["velGrad"]);
        }
        if (event.contains("body")) {
            const std::size_t g = event["body"];
            if (event.contains("vel")) {
                world.grains.velocity[g] = vec(event["vel"]);
            }
            if (event.contains("angVel")) {
                world.grains.spin[g] = vec(event["angVel"]);
            }
        }
    }
}

/// Runs a golden case to `last_step` at most, calling `at_state` at every recorded state.
template <class AtState>
World replay(const json& golden, std::int64_t last_step, AtState&& at_state) {
    World world = world_of(golden);
    StepPlan plan = plan_of(golden);
    StepCaches caches;
    for (const json& state : golden["states"]) {
        if (state["iter"] > last_step) {
            break;
        }
        while (world.clock.step < state["iter"]) {
            apply_events(golden["events"], world.clock.step, world, plan);
            step(world, caches, plan);
        }
        at_state(world, state);
    }
    return world;
}

class TwoAndThreeGrains : public testing::TestWithParam<const char*> {};

TEST_P(TwoAndThreeGrains, FollowTheReferenceInEveryField) {
    const json golden = read_reference_json("golden_small.json.gz")[GetParam()];
    Replay compared;
    replay(golden, 1'000'000, [&](const World& world, const json& state) {
        compared.steps = world.clock.step;
        compared.compare(world, state);
        compared.compare_contacts(world, state["contacts"]);
    });
    ASSERT_GT(compared.steps, 100);
    // Natural scales of fields that stay zero: forces of 1e-3 N, moments of 1e-7 N m, velocities of 1e-2 m/s.
    const std::map<std::string, double> natural{{"position", 1e-4},    {"velocity", 1e-2}, {"spin", 1e2},
                                                {"force", 1e-3},       {"torque", 1e-7},   {"cell", 1e-3},
                                                {"overlap", 1e-7},     {"normal", 1},      {"normal force", 1e-3},
                                                {"shear force", 1e-3}, {"moment", 1e-7}};
    for (const auto& [name, field] : compared.field) {
        // The sign switch of the damping amplifies rounding where a velocity passes through zero (reference,
        // tolerances).
        const bool switches = std::string(GetParam()) == "adhesion_free_pull" && name != "position";
        EXPECT_LE(field.error(natural.at(name)), switches ? 1e-6 : 1e-9) << name;
        RecordProperty(name, std::to_string(field.error(natural.at(name))));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Reference, TwoAndThreeGrains,
    testing::Values(
        "normal_load_unload", "free_collision", "shear_slip", "rolling_limit", "twist_limit", "adhesion_tension_break",
        "adhesion_shear_break_compression", "adhesion_shear_break_tension", "adhesion_free_pull", "chain3",
        "periodic_pair_velgrad"
    ),
    [](const auto& test) { return std::string(test.param); }
);

class FiveHundredGrains : public testing::TestWithParam<const char*> {};

TEST_P(FiveHundredGrains, FollowTheReferenceFor400StepsAndItsStateAtStep2000) {
    const json golden = read_reference_json(GetParam());
    Replay compared;
    Field stress;
    World world = replay(golden, 400, [&](const World& now, const json& state) {
        compared.compare(now, state);
        const Mat3 ours = mean_stress_tensor(now), theirs = rows(state["stress"]);
        for (int a = 0; a < 3; ++a) {
            stress.add(ours.row(a), -theirs.row(a)); // the reference counts tension positive
        }
        EXPECT_EQ(measure_equilibrium(now).contacts, state["nContacts"]) << "at step " << now.clock.step;
    });
    EXPECT_LE(compared.field["position"].error(1e-4), 1e-11);
    EXPECT_LE(compared.field["velocity"].error(1e-2), 1e-8);
    EXPECT_LE(compared.field["force"].error(1e-3), 1e-8);
    EXPECT_LE(stress.error(1), 1e-9);

    // From there on the packing is chaotic: only means agree.
    json last;
    world = replay(golden, 2000, [&](const World&, const json& state) { last = state; });
    const double p_ours = mean_stress(mean_stress_tensor(world)), p_theirs = -trace(rows(last["stress"])) / 3;
    EXPECT_NEAR(p_ours / p_theirs, 1, 1e-3);
    double solid = 0;
    for (const double r : world.grains.radius) {
        solid += sphere_volume(r);
    }
    EXPECT_NEAR(void_ratio(world), determinant(rows(last["hSize"])) / solid - 1, 1e-5);
    const double contacts = last["nContacts"];
    EXPECT_NEAR(static_cast<double>(measure_equilibrium(world).contacts) / contacts, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Reference, FiveHundredGrains, testing::Values("golden_iso500.json.gz", "golden_iso500_servo.json.gz"),
    [](const auto& test) { return std::string(test.param).substr(7, std::string(test.param).find('.') - 7); }
);

} // namespace
} // namespace suffuse::dem
