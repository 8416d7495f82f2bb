#pragma once
// All results, in the order of docs/results.md.

#include "suffuse/facts/fact.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::facts {

/// Facts that stand together: in one object of stage.json, of one verb, or in one kind of table.
struct Group {
    std::string title;
    std::string within; ///< the object of stage.json that they are in, "" for the stage itself
    std::vector<Fact> facts;
};

inline constexpr std::string_view columns_of_tables = "tables"; ///< `within` of the group that is in no stage.json

/// Every number of stage.json, then the columns of tables.
const std::vector<Group>& every_group();

/// docs/results.md.
std::string results_markdown();

} // namespace suffuse::facts
