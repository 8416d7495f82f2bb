#include "suffuse/casefile/dependencies.hpp"

#include "suffuse/casefile/fields.hpp"
#include "suffuse/casefile/soil_fields.hpp"
#include "suffuse/casefile/stage_list.hpp"
#include "suffuse/casefile/stage_traits.hpp"

namespace suffuse::casefile {
namespace {

/// The stage without what has no part in its result.
Stage nameless(Stage stage) {
    stage.name.clear();
    stage.from.clear();
    stage.only.clear();
    stage.restore = false;
    if (auto* import = std::get_if<ImportSpec>(&stage.spec)) {
        import->path.clear();
        import->contacts.clear();
    }
    return stage;
}

} // namespace

std::string dependencies_of(const Case& c, const Variant& variant, const Stage& stage) {
    Case copy; // of what the fields below need: a case may have thousands of samples
    copy.mode = c.mode;
    copy.balance = c.balance;
    copy.fluid = c.fluid;
    copy.names_conductance = c.names_conductance;
    copy.gravity = c.gravity;
    copy.output = c.output;
    grains::Material material = variant.material;
    double damping = variant.damping;
    const auto write = [](const std::string& pattern, auto body) {
        Writer v({pattern});
        body(v);
        return v.node();
    };
    Node root = write("", [&](Writer& v) {
        v.field("seed", variant.seed);
        v.choice("mode", copy.mode, names::mode);
    });
    const StageTraits& traits = traits_of(stage);
    if (traits.origin == Origin::Soil) {
        root.set("particles", make_node(Scalar(variant.particles)));
    }
    root.set("grain", write("grain", [&](Writer& v) { grain_fields(v, material); }));
    root.set("contact", write("contact", [&](Writer& v) { contact_fields(v, material, damping); }));
    root.set("balance", write("balance", [&](Writer& v) { fields(v, copy.balance); }));
    if (traits.has_water) {
        root.set("fluid", write("fluid", [&](Writer& v) { fluid_fields(v, copy); }));
    }
    const triaxial::TriaxialSpec* const test = laboratory_test(stage.spec);
    const bool has_pore_pressure = std::holds_alternative<triaxial::StiffnessSpec>(stage.spec) ||
                                   (test != nullptr && test->path == triaxial::Path::Undrained);
    if (copy.fluid.bulk_modulus && has_pore_pressure) {
        root.set("fluid", write("fluid", [&](Writer& v) { v.field("bulk_modulus", copy.fluid.bulk_modulus); }));
    }
    if (traits.probes_fines() && copy.gravity) {
        root.set("gravity", write("gravity", [&](Writer& v) { fields(v, *copy.gravity); }));
    }
    if (traits.makes_sample() && variant.soil) {
        Node soil; // with a name, as [soil.NAME]: a bare value right below [soil] would not be printed
        soil.set("sample", write_soil(*variant.soil));
        root.set("soil", std::move(soil));
    }
    if (const auto* pack = std::get_if<packing::PackSpec>(&stage.spec); pack != nullptr && !pack->layers.empty()) {
        Node soils;
        for (const packing::Layer& layer : pack->layers) {
            soils.set(layer.soil, write_soil(c.soils.at(layer.soil)));
        }
        root.set("soil", std::move(soils));
    }
    copy.output.checkpoint = OutputSpec{}.checkpoint; // when a state is saved on the way changes nothing
    root.set("output", write("output", [&](Writer& v) { fields(v, copy.output); }));
    root.set("stage", write_stage(nameless(stage)));
    return print_file(root);
}

} // namespace suffuse::casefile
