#include "suffuse/casefile/stack_fields.hpp"

#include "suffuse/casefile/stage_loading.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/packing/stack.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::casefile {

namespace {

using packing::Layer;
using packing::PackSpec;

template <class V>
void fields(V& v, Layer& layer) {
    v.field("soil", layer.soil);
    v.field("thickness", layer.thickness);
}

std::string length_text(double length) {
    return print_quantity(1e-6 * std::ceil(1e6 * length), dimension::length);
}

/// Of one stack.
class LayerChecks {
public:
    LayerChecks(ReadContext& context, const Case& settings, const Stage& stage, const PackSpec& spec, std::string path)
        : problems_(context.problems), places_(context.places), soils_(settings.soils), stage_(stage), spec_(spec),
          path_(std::move(path)) {}

    void check() {
        double largest = 0, finer_median = 0;
        std::string finer;
        for (const Layer& layer : spec_.layers) {
            const auto soil = soils_.find(layer.soil);
            if (soil == soils_.end()) {
                report_unknown(layer);
                return;
            }
            const std::optional<packing::LayerSample> drawn = draw(layer, soil->second);
            if (!drawn) {
                return;
            }
            const double grain = packing::largest_of(*drawn);
            check_thickness(layer, grain);
            const double median = grains::size_at(grains::specified_grading(soil->second), 0.5);
            check_finer(layer, median, finer, finer_median);
            largest = std::max(largest, grain);
            finer = layer.soil;
            finer_median = median;
        }
        check_width(largest);
    }

private:
    void report_unknown(const Layer& layer) {
        std::string known;
        for (const auto& [name, soil] : soils_) {
            known += (known.empty() ? "" : ", ") + name;
        }
        problems_.error(
            "E402", place("layers"), fmt::format("a layer names the soil \"{}\", and there is none", layer.soil),
            known.empty() ? fmt::format("add a table [soil.{}]", layer.soil) : fmt::format("known are {}", known)
        );
    }

    /// As the run will.
    std::optional<packing::LayerSample> draw(const Layer& layer, const grains::Soil& soil) {
        try {
            return packing::sample_layer(soil, packing::solid_of(layer, *spec_.width));
        } catch (const CaseError& problem) {
            problems_.error(
                "E606", place("layers"), fmt::format("the layer \"{}\": {}", layer.soil, problem.what()),
                "a stack has as many grains as its `width` and the `thickness` of each layer hold"
            );
            return std::nullopt;
        }
    }

    void check_thickness(const Layer& layer, double grain) {
        if (layer.thickness >= packing::thinnest_layer * grain) {
            return;
        }
        problems_.error(
            "E619", place("layers"),
            fmt::format("the layer \"{}\" is {:.3g} of its largest grains thick", layer.soil, layer.thickness / grain),
            fmt::format(
                "take a `thickness` of at least {:.0f} of them: {}", packing::thinnest_layer,
                length_text(packing::thinnest_layer * grain)
            )
        );
    }

    void check_finer(const Layer& layer, double median, const std::string& before, double median_before) {
        if (median >= median_before) {
            return;
        }
        problems_.error(
            "E620", place("layers"),
            fmt::format(
                "the layer \"{}\" (D50 = {}) is finer than \"{}\" before it (D50 = {}): it filters nothing", layer.soil,
                length_text(median), before, length_text(median_before)
            ),
            "layers stand in the order of the flow, the base first; exchange them if the flow goes the other way"
        );
    }

    void check_width(double grain) {
        if (*spec_.width >= packing::thinnest_layer * grain) {
            return;
        }
        problems_.error(
            "E619", place("width"), fmt::format("the stack is {:.3g} of its largest grains wide", *spec_.width / grain),
            fmt::format(
                "take a `width` of at least {:.0f} of them: {}", packing::thinnest_layer,
                length_text(packing::thinnest_layer * grain)
            )
        );
    }

    [[nodiscard]] Place place(const char* key) const {
        const auto found = places_.find(fmt::format("{}.stage.{}.{}", path_, stage_.name, key));
        return found == places_.end() ? Place{} : found->second;
    }

    Problems& problems_;
    const std::map<std::string, Place>& places_;
    const std::map<std::string, grains::Soil>& soils_;
    const Stage& stage_;
    const PackSpec& spec_;
    std::string path_;
};

/// Whether a stage turns the right-angled cell of layers into a sheared one.
bool shears_cell(const StageSpec& spec) {
    const std::optional<cell::Loading> loading = loading_at_end(spec);
    const auto* advance = std::get_if<dem::AdvanceSpec>(&spec);
    return (loading && loading->shear_released) || std::holds_alternative<triaxial::ShearSpec>(spec) ||
           (advance != nullptr && advance->loading.velocity_gradient.has_value());
}

} // namespace

void layers_fields(Reader& v, PackSpec& s) {
    const Node* node = v.take("layers");
    if (node == nullptr) {
        for (const char* key : {"axis", "width"}) {
            if (const Node* given = v.take(key)) {
                v.error(
                    "E207", given->place, fmt::format("{} gives `{}` and no `layers`", v.title(), key),
                    "leave it out: one soil is packed in a cube"
                );
            }
        }
        return;
    }
    const std::vector<Node>* items = v.list("layers", *node);
    for (std::size_t k = 0; items != nullptr && k < items->size(); ++k) {
        const Node& item = (*items)[k];
        if (!item.is_table()) {
            v.wrong_type("layers", item, "a list of tables, { soil = \"base\", thickness = \"3 mm\" }");
            return;
        }
        Reader inner(v.context(), item, item.place, {"stage.pack.layers"}, fmt::format("{}.layers.{}", v.path(), k));
        fields(inner, s.layers.emplace_back());
        inner.finish();
    }
    v.choice("axis", s.axis, names::axis);
    v.field("width", s.width);
    if (s.layers.size() < 2) {
        v.error(
            "E207", node->place, fmt::format("{} has one layer", v.title()),
            "a stack has two or more, the base first; a single soil needs no `layers`"
        );
    }
    if (!s.width && !v.has("width")) {
        v.error(
            "E201", node->place, fmt::format("{} has `layers` and no `width`", v.title()),
            "give the width of their square cross-section, three or more of the largest grains: width = \"4 mm\""
        );
    }
    s.porosity = packing::stack_porosity;
}

void layers_fields(Writer& v, const PackSpec& s) {
    if (s.layers.empty()) {
        return;
    }
    std::vector<Node> items;
    for (Layer layer : s.layers) {
        Writer inner({"stage.pack.layers"});
        fields(inner, layer);
        items.push_back(inner.node());
    }
    v.set("layers", make_array(std::move(items)));
    v.choice("axis", s.axis, names::axis);
    v.field("width", s.width);
}

const PackSpec* stack_of(const Variant& variant, const Stage& stage) {
    const Stage* at = &stage;
    while (at->parent >= 0) {
        at = &variant.stages[static_cast<std::size_t>(at->parent)];
    }
    const auto* pack = std::get_if<PackSpec>(&at->spec);
    return pack != nullptr && !pack->layers.empty() ? pack : nullptr;
}

namespace {

/// Whether the base had migrated before the stage begins: some of it is in the filter then, or beyond.
bool has_migrated(const Variant& variant, const Stage& stage) {
    for (int at = stage.parent; at >= 0; at = variant.stages[static_cast<std::size_t>(at)].parent) {
        if (std::holds_alternative<erosion::MigrateSpec>(variant.stages[static_cast<std::size_t>(at)].spec)) {
            return true;
        }
    }
    return false;
}

} // namespace

bool packs_one_soil(const Stage& stage) {
    const auto* pack = std::get_if<PackSpec>(&stage.spec);
    return traits_of(stage).origin == Origin::Soil && (pack == nullptr || pack->layers.empty());
}

void check_layers(ReadContext& context, const Case& settings, const Variant& variant, const std::string& path) {
    for (const Stage& stage : variant.stages) {
        const auto* pack = std::get_if<PackSpec>(&stage.spec);
        if (pack != nullptr && pack->layers.size() > 1 && pack->width) {
            LayerChecks(context, settings, stage, *pack, path).check();
        }
    }
}

void check_in_stack(ReadContext& context, const Variant& variant, const Stage& stage, const Place& place) {
    const PackSpec* stack = stack_of(variant, stage);
    if (stack == nullptr) {
        return;
    }
    const StageTraits& traits = traits_of(stage);
    const auto* migrate = std::get_if<erosion::MigrateSpec>(&stage.spec);
    const auto refuse = [&](const std::string& why, const char* advice) {
        context.problems.error(
            "E621", place, fmt::format("stage \"{}\" starts from layers, and {}", stage.name, why), advice
        );
    };
    if (shears_cell(stage.spec)) {
        refuse(
            "shears the cell: the plane between the layers would tilt across the flow",
            "keep the cell right-angled: shear_stresses = \"kept\", and no `shear`; or take one soil"
        );
    } else if (traits.needs_fines_rule && migrate == nullptr) {
        refuse(
            "finds which fines move through a skeleton of the same soil",
            "do = \"migrate\" moves a base into its filter"
        );
    } else if (migrate != nullptr) {
        Vec3 along;
        along[stack->axis] = 1;
        constexpr double straight = 1 - 1e-9;
        if (!(dot(migrate->direction, along) > straight * norm(migrate->direction))) {
            refuse(
                fmt::format("its water does not go along +{}, from the base into the filter", "xyz"[stack->axis]),
                "give it the `direction` of the `axis` of the layers; turn [gravity] for a flow downward"
            );
        }
        if (has_migrated(variant, stage)) {
            refuse(
                "its base has migrated before: where the base ends, and which of it is its screen, is known of a fresh "
                "one only",
                "list all gradients in the `gradients` of the first one"
            );
        }
        if (migrate->skeleton == erosion::Skeleton::Moves) {
            refuse("its skeleton moves: only a filter that is held is known", "take skeleton = \"held\"");
        }
    }
}

} // namespace suffuse::casefile
