#pragma once
// Handles of the HDF5 library that close themselves, and its refusals as errors.

#include "suffuse/base/error.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <new>
#include <string_view>
#include <utility>

namespace suffuse::io {

/// Throws what HDF5 has just refused: it shows in its stack of errors where no memory was left.
[[noreturn]] inline void refuse(std::string_view what) {
    bool ran_out = false;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned, const H5E_error2_t* error, void* found) -> herr_t {
            *static_cast<bool*>(found) |= error->maj_num == H5E_RESOURCE || error->min_num == H5E_CANTALLOC;
            return 0;
        },
        &ran_out
    );
    if (ran_out) {
        throw std::bad_alloc();
    }
    throw IoError(fmt::format("HDF5 refused: {}", what));
}

/// A handle of HDF5, closed when it goes.
class Handle {
public:
    using Close = herr_t (*)(hid_t);

    Handle(hid_t id, Close close, std::string_view what) : id_(id), close_(close) {
        if (id < 0) {
            refuse(what);
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
        refuse(what);
    }
}

} // namespace suffuse::io
