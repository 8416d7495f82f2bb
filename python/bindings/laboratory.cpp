// Records of laboratory tests.

#include "suffuse/laboratory/read_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include <algorithm>

namespace suffuse::python {
namespace {

laboratory::TestKind kind_of(const std::string& kind) {
    if (const auto found = laboratory::test_kind_named(kind)) {
        return *found;
    }
    throw UsageError(fmt::format("kind {}: it is one of {}", kind, fmt::join(laboratory::test_kind_names(), ", ")));
}

std::optional<bool> contraction_of(const py::object& contraction) {
    if (contraction.is_none()) {
        return std::nullopt;
    }
    const auto word = py::str(contraction).cast<std::string>();
    if (word != "positive" && word != "negative") {
        throw UsageError(fmt::format("contraction {}: it is positive or negative", word));
    }
    return word == "positive";
}

/// Of the values as they are read.
std::string si_unit(Dimension dimension) {
    const std::vector<std::string> units = usual_units(dimension);
    const auto found =
        std::ranges::find_if(units, [dimension](const std::string& unit) { return parse_unit(unit, dimension) == 1; });
    return found == units.end() ? "-" : *found;
}

/// The columns with the test of each row first, their units, and what was assumed.
py::tuple read_test(const std::filesystem::path& path, const std::string& kind, const py::object& contraction) {
    const laboratory::TestRecord record =
        laboratory::read_test(path, {.kind = kind_of(kind), .contraction_is_positive = contraction_of(contraction)});
    py::dict columns, units;
    py::list tests, assumed;
    for (const laboratory::NamedTest& test : record.tests) {
        for (std::size_t row = test.begin; row < test.end; ++row) {
            tests.append(test.name);
        }
    }
    columns["test"] = tests;
    for (const laboratory::TestColumn& column : record.columns) {
        const laboratory::QuantityRow& row = laboratory::row_of(column.quantity);
        columns[py::str(std::string(row.key))] = column.values;
        units[py::str(std::string(row.key))] = si_unit(row.dimension);
    }
    for (const laboratory::Finding& finding : record.findings) {
        if (finding.is_assumed) {
            assumed.append(finding.text);
        }
    }
    return py::make_tuple(columns, units, assumed);
}

} // namespace

void bind_laboratory(py::module_& m) {
    m.def("read_test", &read_test);
}

} // namespace suffuse::python
