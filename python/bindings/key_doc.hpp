#pragma once
// Docstrings of what a case file can say too: from the same table of keys as the reader and its messages.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/schema.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::python {

inline const casefile::Key& key_of(std::string_view table, std::string_view name) {
    const std::vector<casefile::Key>& keys = casefile::schema();
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const casefile::Key& k) {
        return k.table == table && k.name == name;
    });
    expects(key != keys.end(), "a docstring names a key of the case file");
    return *key;
}

/// "E of the normal stiffness ... (a pressure, above 0 kPa; "356 MPa" unless given; [contact] modulus of a case)".
inline std::string key_doc(const casefile::Key& key) {
    return key.text + " (" + casefile::value_text(key) +
           (key.default_text.empty() ? "" : "; " + key.default_text + " unless given") + "; " +
           casefile::key_place(key) + " of a case)";
}

} // namespace suffuse::python
