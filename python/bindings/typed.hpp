#pragma once
// Arguments that are objects to C++, with the type that Python's help and editors are to show.

#include "python/bindings/convert.hpp"
#include <algorithm>
#include <cstddef>

namespace suffuse::python {

template <std::size_t N>
struct TypeName {
    char text[N]{};

    constexpr TypeName(const char (&given)[N]) { std::copy_n(given, N, text); } // NOLINT(google-explicit-constructor)
};

/// Any object; its value is checked where it is read.
template <TypeName name>
class Typed : public py::object {
public:
    using py::object::object;

    Typed(const py::object& other) : py::object(other) {} // NOLINT(google-explicit-constructor)

    static bool check_(py::handle) { return true; }
};

using Quantity = Typed<"float | str">; ///< a number in SI, or a text with its unit
using QuantityOrNone = Typed<"float | str | None">;
using Direction = Typed<"str | Sequence[float]">;
using Numbers = Typed<"ArrayLike">;
using NumbersOrNone = Typed<"ArrayLike | None">;
using PackingOrCell = Typed<"World | Stage | ArrayLike">; ///< see packing_of
using CallableOrNone = Typed<"Callable[[str, int], object] | None">;

} // namespace suffuse::python

namespace pybind11::detail {

template <suffuse::python::TypeName name_>
struct handle_type_name<suffuse::python::Typed<name_>> {
    static constexpr auto name = const_name(name_.text);
};

} // namespace pybind11::detail
