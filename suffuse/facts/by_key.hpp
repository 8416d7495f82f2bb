#pragma once
// What the table of all results knows of a key: for axes and tables, for Python's units, and for the comparison of
// runs.

#include "suffuse/facts/fact.hpp"

#include <map>
#include <string>
#include <string_view>

namespace suffuse::facts {

/// Key -> unit of what has one: "mean_stress", "force_distribution.mean_force". Parts of an object have its unit.
const std::map<std::string, std::string>& units();

/// Of what is under this key of any object of stage.json: "steps", "void_ratio".
Kind kind_of(const std::string& key);

/// The fact of this key that tables and axes give a name; null where none has one.
const Fact* shown_fact(std::string_view key);

/// Whether results may be under this key of an object of stage.json: "void_ratio", "fabric.deviator".
bool is_fact(const std::string& key);

} // namespace suffuse::facts
