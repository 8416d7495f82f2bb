#pragma once
// The copies of a study: every combination of its sweep values, each as often as there are replicates.

#include "suffuse/casefile/node.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace suffuse::casefile {

/// A swept key in folders and tables: its last word; "fc" of a fines content, which then is in percent.
std::string short_name(const std::string& key);

/// A value of a sweep as part of a folder's name: fc=20, gradient=0.05, finer_than=0.18mm.
std::string folder_of(const std::string& key, const Scalar& value);

std::size_t count_variants(const Study& study);

/// Folder, values, replicate and seed of each copy; its soil and stages are still to be read. The first replicate has
/// the seed of the case, whatever the sweep value, so that values are compared on the same random numbers; unless the
/// sweep is over `seed`.
std::vector<Variant> list_variants(const Study& study, std::uint64_t seed);

/// Whether two are the same value, however they are written: "20 %" and 0.2.
bool same_value(const Scalar& a, const Scalar& b);

/// The stages that run for these values, with the rows of their parents; a stage whose parent does not run starts from
/// that one's parent.
std::vector<Stage> chosen_stages(const std::vector<Stage>& stages, const std::map<std::string, Scalar>& values);

/// Where a value stands in the list of its sweep.
Place place_in_sweep(const Node& list, const Scalar& value);

} // namespace suffuse::casefile
