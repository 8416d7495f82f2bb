#pragma once
// Handles of the HDF5 library that close themselves, and its refusals as errors.

#include "suffuse/base/error.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <string_view>
#include <utility>

namespace suffuse::io {

/// A handle of HDF5, closed when it goes.
class Handle {
public:
    using Close = herr_t (*)(hid_t);

    Handle(hid_t id, Close close, std::string_view what) : id_(id), close_(close) {
        if (id < 0) {
            throw IoError(fmt::format("HDF5 refused: {}", what));
        }
    }

    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

    ~Handle() {
        if (id_ >= 0) {
            close_(id_);
        }
    }

    Handle& operator=(Handle&&) = delete;

    operator hid_t() const { return id_; } // NOLINT(google-explicit-constructor): stands for the handle in every call

private:
    hid_t id_;
    Close close_;
};

inline void require(bool done, std::string_view what) {
    if (!done) {
        throw IoError(fmt::format("HDF5 refused: {}", what));
    }
}

} // namespace suffuse::io
