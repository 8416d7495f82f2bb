#pragma once
// All results, for docs/results.md, for the units that Python knows, and for a test that no result lacks its row.

#include "suffuse/facts/fact.hpp"

#include <map>
#include <string>
#include <vector>

namespace suffuse::facts {

/// Facts that stand together: in one object of stage.json, of one verb, or in one kind of table.
struct Group {
    std::string title;
    std::string within; ///< the object of stage.json that they are in, "" for the stage itself
    std::vector<Fact> facts;
};

/// Every number of stage.json, then the columns of tables.
const std::vector<Group>& every_group();

/// Key -> unit of what has one: "mean_stress", "force_distribution.mean_force". Parts of an object have its unit.
const std::map<std::string, std::string>& units();

/// Of what is under this key of any object of stage.json: "steps", "void_ratio".
Kind kind_of(const std::string& key);

/// The fact of this key that tables and axes give a name; null where none has one.
const Fact* shown_fact(std::string_view key);

/// Whether results may be under this key of an object of stage.json: "void_ratio", "fabric.deviator".
bool is_fact(const std::string& key);

/// docs/results.md.
std::string results_markdown();

} // namespace suffuse::facts
