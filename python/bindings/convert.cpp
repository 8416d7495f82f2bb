#include "python/bindings/convert.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace suffuse::python {
namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

Array array_of(const py::handle& value, std::string_view what) {
    Array array = Array::ensure(value);
    if (!array) {
        PyErr_Clear();
        throw CaseError(fmt::format("{}: expected numbers, found {}", what, py::repr(value).cast<std::string>()));
    }
    return array;
}

std::string shape_text(const Array& array) {
    std::string text;
    for (py::ssize_t a = 0; a < array.ndim(); ++a) {
        text += fmt::format("{}{}", a > 0 ? " x " : "", array.shape(a));
    }
    return text.empty() ? "a single number" : text;
}

void check_finite(const Array& array, std::string_view what) {
    for (py::ssize_t k = 0; k < array.size(); ++k) {
        if (!std::isfinite(array.data()[k])) {
            throw CaseError(fmt::format("{}: found {}, expected finite numbers", what, array.data()[k]));
        }
    }
}

/// A text is a sequence, too, and no list of its letters.
py::tuple three_of(const py::handle& value, std::string_view what, std::string_view of) {
    const bool is_list = py::isinstance<py::array>(value)
                             ? value.cast<py::array>().ndim() > 0
                             : py::isinstance<py::sequence>(value) && !py::isinstance<py::str>(value);
    const auto parts = is_list ? py::tuple(value.cast<py::object>()) : py::tuple();
    if (parts.size() != 3) {
        throw CaseError(fmt::format(
            "{}: expected three {}, found {}", what, of,
            is_list ? std::to_string(parts.size()) : py::repr(value).cast<std::string>()
        ));
    }
    return parts;
}

/// Errors name the argument.
template <class Parse>
double parse_text(const std::string& text, Dimension dimension, std::string_view what, const Parse& parse) {
    try {
        return parse(text, dimension);
    } catch (const UnitError& error) {
        throw UnitError(error.kind, fmt::format("{} \"{}\": {}; {}", what, text, error.what(), error.help), error.help);
    }
}

} // namespace

double quantity_of(const py::handle& value, Dimension dimension, std::string_view what) {
    if (py::isinstance<py::str>(value)) {
        return parse_text(value.cast<std::string>(), dimension, what, [](const std::string& text, Dimension wanted) {
            return parse_quantity(text, wanted);
        });
    }
    double number = 0;
    try {
        number = value.cast<double>();
    } catch (const py::cast_error&) {
        throw CaseError(fmt::format(
            "{}: expected {} as a number in SI or a text with its unit, found {}", what, with_article(dimension),
            py::repr(value).cast<std::string>()
        ));
    }
    if (!std::isfinite(number)) {
        throw CaseError(fmt::format("{}: found {}, expected a finite number", what, number));
    }
    return number;
}

double unit_of(const py::handle& value, Dimension dimension, std::string_view what) {
    if (py::isinstance<py::str>(value)) {
        return parse_text(value.cast<std::string>(), dimension, what, parse_unit);
    }
    const double unit = quantity_of(value, dimension, what);
    if (!(unit > 0)) {
        throw CaseError(fmt::format("{}: found {}, expected {} above 0", what, unit, with_article(dimension)));
    }
    return unit;
}

std::optional<double> optional_quantity(const py::handle& value, Dimension dimension, std::string_view what) {
    return value.is_none() ? std::nullopt : std::optional(quantity_of(value, dimension, what));
}

Vec3 direction_of(const py::handle& value) {
    if (!py::isinstance<py::str>(value)) {
        const Vec3 v = squarable(vector_of(value, dimension::none, "direction"));
        if (!(norm(v) > 0)) {
            throw CaseError("direction: a vector of length zero points nowhere");
        }
        return v / norm(v);
    }
    const auto text = value.cast<std::string>();
    const bool backwards = text.starts_with('-');
    const std::string_view axis = std::string_view(text).substr(backwards || text.starts_with('+') ? 1 : 0);
    const std::size_t a = std::string_view("xyz").find(axis);
    if (axis.size() != 1 || a == std::string_view::npos) {
        throw CaseError(
            fmt::format("direction: found \"{}\", expected x, y, z, +x, -x and so on, or three numbers", text)
        );
    }
    Vec3 v;
    v[static_cast<int>(a)] = backwards ? -1 : 1;
    return v;
}

Vec3 vector_of(const py::handle& value, Dimension dimension, std::string_view what) {
    const py::tuple parts = three_of(value, what, "values");
    return {
        quantity_of(parts[0], dimension, what), quantity_of(parts[1], dimension, what),
        quantity_of(parts[2], dimension, what)};
}

Mat3 matrix_of(const py::handle& value, Dimension dimension, std::string_view what) {
    const py::tuple rows = three_of(value, what, "rows of three values");
    Mat3 m;
    for (int a = 0; a < 3; ++a) {
        const Vec3 row = vector_of(rows[static_cast<std::size_t>(a)], dimension, what);
        m[a] = {row.x, row.y, row.z};
    }
    return m;
}

Mat3 cell_of(const py::handle& value) {
    const py::object first = three_of(value, "cell", "edges, or rows of a matrix")[0];
    const bool is_matrix = !py::isinstance<py::str>(first) && py::hasattr(first, "__len__");
    const Mat3 h =
        is_matrix ? matrix_of(value, dimension::length, "cell") : diagonal(vector_of(value, dimension::length, "cell"));
    if (!(determinant(h) > 0)) {
        throw CaseError("cell: its vectors span no volume; give three positive edges, or a 3 x 3 matrix whose columns "
                        "are the cell vectors, right-handed");
    }
    return h;
}

std::vector<Vec3> vectors_of(const py::handle& value, std::string_view what, std::optional<std::size_t> rows) {
    const Array array = array_of(value, what);
    if (array.ndim() != 2 || array.shape(1) != 3 || (rows && *rows != static_cast<std::size_t>(array.shape(0)))) {
        throw CaseError(fmt::format(
            "{}: found {}, expected {} x 3 numbers", what, shape_text(array), rows ? std::to_string(*rows) : "n"
        ));
    }
    check_finite(array, what);
    std::vector<Vec3> vectors(static_cast<std::size_t>(array.shape(0)));
    for (std::size_t g = 0; g < vectors.size(); ++g) {
        const double* row = array.data() + 3 * g;
        vectors[g] = {row[0], row[1], row[2]};
    }
    return vectors;
}

std::vector<double> numbers_of(const py::handle& value, std::string_view what, std::optional<std::size_t> rows) {
    const Array array = array_of(value, what);
    if (array.ndim() != 1 || (rows && *rows != static_cast<std::size_t>(array.size()))) {
        throw CaseError(fmt::format(
            "{}: found {}, expected {} numbers", what, shape_text(array), rows ? std::to_string(*rows) : "n"
        ));
    }
    check_finite(array, what);
    return {array.data(), array.data() + array.size()};
}

py::array_t<double> to_array(const Vec3& v) {
    const std::array<double, 3> values{v.x, v.y, v.z};
    return py::array_t<double>(3, values.data());
}

py::array_t<double> to_array(const Mat3& m) {
    return py::array_t<double>({3, 3}, m.m.front().data());
}

py::array_t<double> to_array(const std::vector<Vec3>& rows) {
    py::array_t<double> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
    double* out = array.mutable_data();
    for (const Vec3& row : rows) {
        *out++ = row.x, *out++ = row.y, *out++ = row.z;
    }
    return array;
}

py::object to_python(const nlohmann::json& json) {
    switch (json.type()) {
    case nlohmann::json::value_t::object: {
        py::dict dict;
        for (const auto& [key, value] : json.items()) {
            dict[py::str(key)] = to_python(value);
        }
        return dict;
    }
    case nlohmann::json::value_t::array: {
        py::list list;
        for (const nlohmann::json& value : json) {
            list.append(to_python(value));
        }
        return list;
    }
    case nlohmann::json::value_t::string:
        return py::str(json.get_ref<const std::string&>());
    case nlohmann::json::value_t::boolean:
        return py::bool_(json.get<bool>());
    case nlohmann::json::value_t::number_integer:
    case nlohmann::json::value_t::number_unsigned:
        return py::int_(json.get<std::int64_t>());
    case nlohmann::json::value_t::number_float:
        return py::float_(json.get<double>());
    default:
        return py::none();
    }
}

} // namespace suffuse::python
