#pragma once
// Values across the border: numbers with units, vectors, cells, JSON. A quantity is a number in SI or a text with its
// unit; a vector is anything of three numbers.

#include "suffuse/base/units.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h> // in every file of the module or in none
#include <pybind11/stl/filesystem.h>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::python {

namespace py = pybind11;

/// `what` names the argument in messages. @throws CaseError, UnitError.
double quantity_of(const py::handle& value, Dimension dimension, std::string_view what);

/// What a unit stands for in SI: a number above 0, "mm" or "1 mm". @throws CaseError, UnitError.
double unit_of(const py::handle& value, Dimension dimension, std::string_view what);

/// Nothing for None.
std::optional<double> optional_quantity(const py::handle& value, Dimension dimension, std::string_view what);

/// "x", "-z", or three numbers, as a unit vector. @throws CaseError.
Vec3 direction_of(const py::handle& value);

/// Three edges, or a 3 x 3 matrix whose columns are the cell vectors [m]. @throws CaseError where it has no volume.
Mat3 cell_of(const py::handle& value);

Mat3 matrix_of(const py::handle& value, Dimension dimension, std::string_view what);
Vec3 vector_of(const py::handle& value, Dimension dimension, std::string_view what);

/// n x 3 numbers; n numbers. @throws CaseError where the shape is another, or `rows` is given and is not that of it.
std::vector<Vec3> vectors_of(const py::handle& value, std::string_view what, std::optional<std::size_t> rows = {});
std::vector<double> numbers_of(const py::handle& value, std::string_view what, std::optional<std::size_t> rows = {});

py::array_t<double> to_array(const Vec3& v);
py::array_t<double> to_array(const Mat3& m);
py::array_t<double> to_array(const std::vector<Vec3>& rows); ///< n x 3
py::object to_python(const nlohmann::json& json);

} // namespace suffuse::python
