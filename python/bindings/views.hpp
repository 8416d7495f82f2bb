#pragma once
// NumPy arrays that look into columns of ours. The array's base holds its owner, so that what it looks at stays.

#include "suffuse/base/vec3.hpp"

#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <vector>

namespace suffuse::python {

/// What an array holds on to: any shared pointer.
template <class Owner>
pybind11::capsule hold(Owner owner) {
    return pybind11::capsule(new Owner(std::move(owner)), [](void* held) { delete static_cast<Owner*>(held); });
}

/// A look at `rows` rows of `width` values each, `stride` bytes from row to row; of one dimension where `width` is 0.
template <class T>
pybind11::array look_at(
    const T* first, std::size_t rows, std::size_t width, std::size_t stride, const pybind11::capsule& owner,
    bool writeable = false
) {
    using Size = pybind11::ssize_t;
    std::vector<Size> shape{static_cast<Size>(rows)}, strides{static_cast<Size>(stride)};
    if (width > 0) {
        shape.push_back(static_cast<Size>(width));
        strides.push_back(static_cast<Size>(sizeof(T)));
    }
    pybind11::array array(pybind11::dtype::of<T>(), std::move(shape), std::move(strides), first, owner);
    if (!writeable) {
        pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    }
    return array;
}

template <class T>
pybind11::array look_at(const std::vector<T>& column, const pybind11::capsule& owner, bool writeable = false) {
    return look_at(column.data(), column.size(), 0, sizeof(T), owner, writeable);
}

inline pybind11::array
look_at(const std::vector<Vec3>& column, const pybind11::capsule& owner, bool writeable = false) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return look_at(column.empty() ? nullptr : &column.front().x, column.size(), 3, sizeof(Vec3), owner, writeable);
}

template <class T, std::size_t N>
pybind11::array look_at(const std::vector<std::array<T, N>>& column, const pybind11::capsule& owner) {
    return look_at(column.empty() ? nullptr : column.front().data(), column.size(), N, sizeof(column[0]), owner);
}

} // namespace suffuse::python
