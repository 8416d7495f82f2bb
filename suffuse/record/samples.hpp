#pragma once
// The samples of a case: one for each study, set of sweep values and seed. Each is run on its own, in any order.

#include "suffuse/casefile/case.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::record {

struct Sample {
    const casefile::Study* study = nullptr;
    const casefile::Variant* variant = nullptr;
    int number = 0;      ///< 1-based, over the whole run
    int first_stage = 0; ///< number of its first stage, 1-based, over the whole run
    int stages = 0;      ///< how many of its stages are to be run: all, or those up to the requested last one
};

/// In the order of the file. With `until`, each sample ends with its stage of that name, and those without one are
/// left out. With `only`, the one in this folder below studies/. The samples point into `what`.
std::vector<Sample>
list_samples(const casefile::Case& what, const std::string& until = {}, const std::string& only = {});

/// "STUDY/SAMPLE/STAGE", as warnings and tables say where.
std::string stage_name(const casefile::Variant& variant, const casefile::Stage& stage);

/// Whether [output] requests this format.
bool writes(const casefile::OutputSpec& output, std::string_view format);

/// Whether the stage leaves CSV tables of many rows: the last stage does, those of imported samples do, and others
/// where [output] requests it.
bool leaves_tables(const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage);

/// Whether the soil distinguishes coarse and fine grains, so that every stage has their numbers.
bool has_fractions(const casefile::Variant& variant);

} // namespace suffuse::record
