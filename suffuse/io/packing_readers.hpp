#pragma once
// The formats of packings that are read: how a text is recognized, what is read of it, and who reads it. A new format
// is a row here; docs/packings.md lists the rows, and a test compares them.

#include "suffuse/io/packing_file.hpp"
#include "suffuse/io/packing_source.hpp"

#include <span>
#include <string_view>

namespace suffuse::io {

struct PackingReader {
    std::string_view name;
    std::string_view recognized; ///< how, for the page
    std::string_view columns;    ///< what is read
    std::string_view cell;       ///< where it comes from
    bool has_own_radii;          ///< always, so that one for all is refused
    bool (*recognizes)(std::string_view text);
    ImportedPacking (*read)(const PackingSource& source);
};

/// In the order in which they are tried; the last one takes any text.
std::span<const PackingReader> packing_readers();

} // namespace suffuse::io
