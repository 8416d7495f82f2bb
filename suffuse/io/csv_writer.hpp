#pragma once
// A table of comma-separated values: a header, then rows. Numbers are printed with as many digits as reading them back
// to the same bits takes, and no more.

#include "suffuse/base/vec3.hpp"
#include "suffuse/io/atomic_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace suffuse::io {

class CsvWriter {
public:
    /// Starts the file with `header`, names separated by commas.
    CsvWriter(const std::filesystem::path& path, std::string_view header);

    /// One row; a vector or a matrix takes one field a component, rows first. Text goes as it is: it must hold no
    /// comma, quote or line break. Throws Bug where the number of fields is not that of the header.
    template <class... Values>
    void row(const Values&... values) {
        line_.clear();
        fields_ = 0;
        (add(values), ...);
        end_row();
    }

    /// Completes the file: without it none is left.
    void finish();

private:
    void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }

    void add(const Mat3& m) { add(m.row(0)), add(m.row(1)), add(m.row(2)); }

    template <class Value>
    void add(const Value& value) {
        if (fields_++ > 0) {
            line_.push_back(',');
        }
        if constexpr (std::is_same_v<Value, bool>) {
            line_.push_back(value ? '1' : '0');
        } else {
            fmt::format_to(std::back_inserter(line_), "{}", value);
        }
    }

    void end_row();

    AtomicFile file_;
    fmt::memory_buffer line_;
    std::size_t columns_, fields_ = 0;
};

} // namespace suffuse::io
