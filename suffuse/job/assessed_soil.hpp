#pragma once
// What the criteria of internal stability say of a soil, as lines for a terminal and as JSON for programs; the names of
// the JSON are a promise (docs/formats.md).

#include "suffuse/job/filter_atlas.hpp"
#include "suffuse/stability/filter_between.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace suffuse::job {

/// Another soil next to it, as its filter.
struct AssessedFilter {
    std::string name; ///< the file
    stability::FilterCheck check;
    FilterAtlasAnswer simulated = {};
    grains::Grading measured = {}; ///< as given
};

struct AssessedSoil {
    std::string name;             ///< as shown: the file, and the soil where a case has it
    std::filesystem::path folder; ///< below -o, where there are several
    stability::Assessment assessment;
    grains::Grading measured = {}; ///< as given, for its classes of size
    std::optional<AssessedFilter> filter = {};
};

nlohmann::json soil_json(const AssessedSoil& soil, const stability::AssessSpec& spec);

/// What the critical gradients are computed from, and how the fines compare with the constrictions: sentences without
/// their capital and their point. @param join between the two halves
std::string seepage_text(const stability::Seepage& seepage);
extern const char* const no_heave_text; ///< of seepage that is not upward
std::string constrictions_text(const stability::Assessment& assessment, const char* join = " ");

/// "the filter filter.csv fails by 2 of 9 rules: ...".
std::string filter_summary(const AssessedFilter& filter);

/// That, a line for each rule, and what simulated bases did.
std::string filter_text(const AssessedFilter& filter);

/// @param columns of the terminal that it is for
std::string text_of(const AssessedSoil& soil, const stability::AssessSpec& spec, std::size_t columns = 80);

} // namespace suffuse::job
