#pragma once
// What stages took on this machine compared with the plan's tables. It is in the cache, and corrects the
// next plan for whatever the tables leave out: this machine's memory, its other work, the soils that its user likes.

#include "suffuse/plan/plan.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace suffuse::plan {

class PastPrices {
public:
    /// What the folder of a cache holds; an empty path: nothing. Lines that are none of ours are passed over.
    explicit PastPrices(const std::filesystem::path& cache);

    /// Steps and seconds of stages of whose kind enough are known: the middle of the tables, times what most of the
    /// past ones took over theirs.
    void correct(RunPlan& plan) const;

private:
    struct Ratios {
        std::vector<double> steps, seconds; ///< taken over the middle of the tables, the latest last [-]
    };

    std::map<std::string, Ratios> of_kind_;
};

/// Adds what the stages of a run took, of those in its plan.json, each once. A cache that cannot be written
/// learns nothing; no error comes of it.
void remember_prices(const std::filesystem::path& cache, const std::filesystem::path& run);

} // namespace suffuse::plan
