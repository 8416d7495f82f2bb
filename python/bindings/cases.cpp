// Case files: read, checked, priced; and the words of the schema.

#include "suffuse/base/read_text.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/casefile/schema.hpp"
#include "suffuse/casefile/sweep_value.hpp"
#include "suffuse/casefile/variants.hpp"
#include "suffuse/facts/by_key.hpp"
#include "suffuse/facts/shown.hpp"
#include "suffuse/job/explain_word.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/record/refine.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/case_handle.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/work.hpp"
#include <algorithm>
#include <filesystem>
#include <map>

namespace suffuse::python {
namespace {
using casefile::Key;

void bind_diagnostic(py::module_& m) {
    py::class_<Diagnostic>(m, "Diagnostic", "One thing that is wrong with a case, or doubtful, with its place.")
        .def_readonly("code", &Diagnostic::code, "As in \"E203\"; suffuse.explain knows it.")
        .def_readonly("file", &Diagnostic::file)
        .def_readonly("line", &Diagnostic::line)
        .def_readonly("column", &Diagnostic::column)
        .def_readonly("message", &Diagnostic::message)
        .def_readonly("help", &Diagnostic::help, "One thing to do.")
        .def_readonly("is_warning", &Diagnostic::is_warning)
        .def(py::pickle(
            [](const Diagnostic& d) { // an error that a process of a pool raises travels home with it
                return py::make_tuple(
                    d.code, d.file, d.line, d.column, d.length, d.source_line, d.message, d.label, d.help, d.is_warning
                );
            },
            [](const py::tuple& s) {
                return Diagnostic{s[0].cast<std::string>(), s[1].cast<std::string>(), s[2].cast<int>(),
                                  s[3].cast<int>(),         s[4].cast<int>(),         s[5].cast<std::string>(),
                                  s[6].cast<std::string>(), s[7].cast<std::string>(), s[8].cast<std::string>(),
                                  s[9].cast<bool>()};
            }
        ))
        .def("__str__", [](const Diagnostic& problem) { return render({problem}); })
        .def("__repr__", [](const Diagnostic& problem) {
            return fmt::format("<{} {}:{}: {}>", problem.code, problem.file, problem.line, problem.message);
        });
}

CaseHandle load(
    const std::filesystem::path& path, const std::string& preset, const std::vector<std::string>& changes,
    const std::vector<std::string>& studies
) {
    CaseHandle made;
    made.path = path;
    made.text = read_whole_file(path.string());
    made.options = {preset, changes, studies};
    made.loaded = casefile::load_case(path.string(), made.options);
    return made;
}

py::list stages_of(const CaseHandle& self) {
    py::list list;
    for (const casefile::Study& study : self.loaded.value.studies) {
        for (const casefile::Variant& variant : study.variants) {
            for (const casefile::Stage& stage : variant.stages) {
                list.append(variant.folder + "/" + stage.name);
            }
        }
    }
    return list;
}

/// "kg/m3", "-" of ratios and counts: as tables name units.
std::string si_unit(Dimension wanted) {
    for (std::string unit : usual_units(wanted)) {
        if (parse_unit(unit, wanted) == 1) {
            std::erase(unit, '^');
            std::ranges::replace(unit, '*', ' ');
            return unit;
        }
    }
    return "-";
}

/// A swept value and its unit: a number in SI, the fines content in percent as in the folder's name; words as written.
py::tuple swept_value(const std::string& key, const casefile::Scalar& value) {
    const std::optional<Quantity> number = casefile::quantity_of(value);
    if (!number) {
        return py::make_tuple(casefile::written(value), py::none());
    }
    return key == "fines_content" ? py::make_tuple(100 * number->value, "%")
                                  : py::make_tuple(number->value, si_unit(number->dimension));
}

/// Of each sample of a run, in the order of the sweep: its folder, stages, and the values of the sweep and of its row
/// by the key's last word; by the whole key where two end alike.
py::list samples_of(const std::filesystem::path& run) {
    py::list list;
    for (const casefile::Study& study : record::load_run(run).studies) {
        std::vector<casefile::Sweep> own = study.sweep;
        own.insert(own.end(), study.rows.begin(), study.rows.end());
        std::map<std::string, int> ends;
        for (const casefile::Sweep& sweep : own) {
            ++ends[casefile::short_name(sweep.key)];
        }
        for (const casefile::Variant& variant : study.variants) {
            py::dict values;
            for (const casefile::Sweep& sweep : own) {
                const std::string name = casefile::short_name(sweep.key);
                values[py::str(ends[name] > 1 ? sweep.key : name)] =
                    swept_value(sweep.key, variant.values.at(sweep.key));
            }
            if (study.replicates > 1) {
                values["rep"] = py::make_tuple(variant.replicate, "-");
            }
            py::list stages;
            for (const casefile::Stage& stage : variant.stages) {
                stages.append(stage.name);
            }
            list.append(py::make_tuple(variant.folder, stages, values));
        }
    }
    return list;
}

void bind_case(py::module_& m) {
    py::class_<CaseHandle>(m, "CaseFile", "A case that was read and checked.")
        .def_static(
            "load", &load, py::arg("path"), py::arg("preset") = "", py::arg("changes") = std::vector<std::string>{},
            py::arg("studies") = std::vector<std::string>{}
        )
        .def_property_readonly("path", [](const CaseHandle& self) { return self.path; })
        .def_property_readonly("text", [](const CaseHandle& self) { return self.text; })
        .def_property_readonly("title", [](const CaseHandle& self) { return self.loaded.value.title; })
        .def_property_readonly("seed", [](const CaseHandle& self) { return self.loaded.value.seed; })
        .def_property_readonly("preset", [](const CaseHandle& self) { return self.loaded.value.preset; })
        .def_property_readonly("warnings", [](const CaseHandle& self) { return self.loaded.warnings; })
        .def_property_readonly("material", [](const CaseHandle& self) { return self.loaded.value.material; })
        .def_property_readonly("balance", [](const CaseHandle& self) { return self.loaded.value.balance; })
        .def_property_readonly("fluid", [](const CaseHandle& self) { return self.loaded.value.fluid; })
        .def_property_readonly("damping", [](const CaseHandle& self) { return self.loaded.value.damping; })
        .def_property_readonly("stages", &stages_of)
        .def_property_readonly(
            "resolved", [](const CaseHandle& self) { return casefile::resolved_toml(self.loaded.value); },
            "The case with every default and unit spelled out, as TOML."
        )
        .def("plan", [](const CaseHandle& self) {
            plan::RunPlan plan;
            {
                const Working working;
                plan = plan::plan_case(self.loaded.value, plan::samples_at_once(self.loaded.value));
            }
            nlohmann::json json = plan;
            json["text"] = plan::plan_sentence(plan);
            return to_python(json);
        });
}

void bind_schema(py::module_& m) {
    py::class_<Key>(m, "Key", "A key that a case may have.")
        .def_readonly("table", &Key::table)
        .def_readonly("name", &Key::name)
        .def_readonly("text", &Key::text, "What it means.")
        .def_readonly("default", &Key::default_text, "As it would be written; empty where there is none.")
        .def_readonly("required", &Key::is_required)
        .def_readonly("choices", &Key::choices)
        .def_property_readonly("place", &casefile::key_place)
        .def_property_readonly("value", &casefile::value_text, "What may be written.")
        .def("__repr__", [](const Key& key) { return fmt::format("<{}: {}>", casefile::key_place(key), key.text); });
    m.def(
        "schema", [] { return casefile::schema(); }, "Every key that a case may have."
    );
    m.def(
        "explain", &job::explain_word, py::arg("word"),
        "One screen on a key of a case, a code of an error, a figure, a criterion of stability, or \"conventions\"."
    );
}

} // namespace

void bind_cases(py::module_& m) {
    bind_diagnostic(m);
    bind_case(m);
    bind_schema(m);
    m.def("samples_of", &samples_of, py::arg("run"));
    m.def(
        "quantity", [](const std::string& text) { return parse_quantity(text).value; }, py::arg("text"),
        "\"100 kPa\" -> 100000.0: a quantity in SI."
    );
    m.def(
        "units", &facts::units,
        "The unit of each result of stage.json and of each column of a table, by its key; \"-\" of shares and counts."
    );
    m.def("title", &facts::title, py::arg("key"), "\"mean stress p [kPa]\" of \"mean_stress\".");
    m.def(
        "in_unit_shown", &facts::in_unit_shown, py::arg("key"), py::arg("value"), "A value in the unit of that title."
    );
    m.def("pressure_unit", [](const py::object& unit) { return unit_of(unit, dimension::pressure, "unit"); });
}

} // namespace suffuse::python
