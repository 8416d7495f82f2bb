// Internal stability of a soil by its grading.

#include "suffuse/atlas/filter_row.hpp"
#include "suffuse/atlas/row.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/gradings/read_grading.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/job/assessed_soil.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/work.hpp"
#include "python/bindings/world_handle.hpp"

namespace suffuse::python {

grains::Grading grading_of(const grains::Grains& grains) {
    if (grains.size() == 0) {
        throw CaseError("a World without grains has no grading");
    }
    return grains::curve_of_steps(grains::measure_gradation(grains));
}

namespace {

std::optional<stability::FlowWay> flow_of(const py::object& flow) {
    if (flow.is_none()) {
        return std::nullopt;
    }
    const auto word = py::str(flow).cast<std::string>();
    const auto way = stability::flow_way_of(word);
    if (!way) {
        throw CaseError(fmt::format("flow = {}: expected {}", word, stability::flow_ways_text));
    }
    return way;
}

std::optional<stability::Seepage> seepage_of(
    const py::object& gradient, const py::object& porosity, const py::object& density, const py::object& alpha,
    const py::object& flow
) {
    if (gradient.is_none()) {
        if (!porosity.is_none() || !density.is_none() || !alpha.is_none() || !flow.is_none()) {
            throw CaseError("porosity, density, alpha and flow go with a gradient: give gradient= too");
        }
        return std::nullopt;
    }
    stability::Seepage seepage;
    seepage.gradient = quantity_of(gradient, dimension::none, "gradient");
    seepage.porosity = optional_quantity(porosity, dimension::none, "porosity").value_or(seepage.porosity);
    seepage.grain_density = optional_quantity(density, dimension::density, "density").value_or(seepage.grain_density);
    seepage.stress_share = optional_quantity(alpha, dimension::none, "alpha");
    seepage.flow = flow_of(flow);
    return seepage;
}

constexpr std::string_view gradings = "a file, a World, or a pair (sizes in meters, shares finer by mass)";

/// The curve of a file, or of one of its samples.
grains::Grading
read_curve(const std::string& path, const std::string& sample, const gradings::ReadingOptions& options) {
    const auto source = std::make_shared<Source>(Source{path, read_whole_file(path)});
    gradings::GradingFile file = gradings::read_gradings(source, gradings::CurveEnds::MayBeOpen, sample, options);
    if (file.soils.size() > 1) {
        std::vector<std::string> names;
        for (const gradings::NamedGrading& soil : file.soils) {
            names.push_back(soil.name);
        }
        throw CaseError(
            fmt::format(
                "{} holds the curves of {} samples, and one is needed: give sample= one of {}", path, names.size(),
                fmt::join(names, ", ")
            ),
            path
        );
    }
    return std::move(file.soils.front().grading);
}

/// One of these.
job::AssessedSoil soil_of(const py::object& what, const std::string& sample, const gradings::ReadingOptions& options) {
    job::AssessedSoil soil;
    const bool is_pair = py::isinstance<py::tuple>(what) || py::isinstance<py::list>(what);
    if ((is_pair || py::isinstance<WorldHandle>(what)) && !sample.empty()) {
        throw CaseError("sample: only a file has samples");
    }
    if (py::isinstance<WorldHandle>(what)) {
        soil.name = "a packing";
        soil.assessment.grading = grading_of(what.cast<const WorldHandle&>().world().grains);
    } else if (is_pair) {
        const auto pair = what.cast<py::sequence>();
        if (py::len(pair) != 2) {
            throw CaseError(fmt::format("a grading is {}", gradings));
        }
        soil.name = "a grading";
        soil.assessment.grading.diameter = numbers_of(pair[0], "sizes");
        soil.assessment.grading.passing = numbers_of(pair[1], "shares finer", soil.assessment.grading.diameter.size());
    } else {
        if (!py::isinstance<py::str>(what) && !py::hasattr(what, "__fspath__")) {
            throw CaseError(fmt::format("a grading is {}, found {}", gradings, py::repr(what).cast<std::string>()));
        }
        const auto path = what.cast<std::filesystem::path>();
        soil.name = sample.empty() ? path.string() : fmt::format("{}, {}", path.string(), sample);
        soil.assessment.grading = read_curve(path.string(), sample, options);
    }
    return soil;
}

py::object assess(
    const py::object& grading, const py::object& finer_than, const py::object& relative_density, bool coarse_fabric,
    const py::object& gradient, const py::object& porosity, const py::object& density, const py::object& alpha,
    const py::object& flow, const py::object& sample, const py::object& size, const py::object& passing,
    const py::object& retained, const py::object& share, const py::object& mass, const py::object& by,
    const py::object& sheet, const py::object& rows
) {
    const auto words = [](const py::object& value) {
        return value.is_none() ? "" : py::str(value).cast<std::string>();
    };
    const gradings::ReadingOptions options{
        words(size),
        words(passing),
        words(retained),
        words(share),
        words(mass),
        words(by),
        sheet.is_none() ? std::nullopt : std::optional(sheet.cast<std::int64_t>()),
        words(rows)};
    stability::AssessSpec spec;
    spec.finer_than = optional_quantity(finer_than, dimension::length, "finer_than");
    spec.relative_density = optional_quantity(relative_density, dimension::none, "relative_density");
    spec.fabric = coarse_fabric ? stability::PrimaryFabric::Coarse : stability::PrimaryFabric::Soil;
    spec.seepage = seepage_of(gradient, porosity, density, alpha, flow);
    job::AssessedSoil soil = soil_of(grading, words(sample), options);
    soil.measured = soil.assessment.grading;
    soil.assessment = stability::assess_measured(soil.measured, spec);
    nlohmann::json document = job::soil_json(soil, spec);
    document["text"] = job::text_of(soil, spec);
    return to_python(document);
}

} // namespace

void bind_stability(py::module_& m) {
    m.def(
        "assess", &assess, py::arg("grading"), py::kw_only(), py::arg("finer_than") = py::none(),
        py::arg("relative_density") = py::none(), py::arg("coarse_fabric") = false, py::arg("gradient") = py::none(),
        py::arg("porosity") = py::none(), py::arg("density") = py::none(), py::arg("alpha") = py::none(),
        py::arg("flow") = py::none(), py::arg("sample") = py::none(), py::arg("size") = py::none(),
        py::arg("passing") = py::none(), py::arg("retained") = py::none(), py::arg("share") = py::none(),
        py::arg("mass") = py::none(), py::arg("by") = py::none(), py::arg("sheet") = py::none(),
        py::arg("rows") = py::none()
    );
    m.def("atlas_table", &atlas::shipped_table);
    m.def("filter_atlas_table", &atlas::shipped_filter_table);
}

} // namespace suffuse::python
