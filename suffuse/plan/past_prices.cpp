#include "suffuse/plan/past_prices.hpp"

#include "suffuse/base/quantile.hpp"
#include "suffuse/io/own_file.hpp"
#include "suffuse/plan/plan_record.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_cache.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace suffuse::plan {
namespace {

using nlohmann::json;

constexpr std::size_t least_known = 5; // stages of a kind: fewer say less than the tables
constexpr std::size_t most_known = 60; // the latest of a kind
constexpr double least_error = 1.15;   // a factor: no two runs of a machine take the same time

std::filesystem::path prices_of(const std::filesystem::path& cache) {
    return cache / record::StageCache::prices_file;
}

/// From the tables' middle to what nine of ten past stages took.
Range corrected(double tables, std::vector<double> ratios) {
    ratios.erase(ratios.begin(), ratios.end() - static_cast<std::ptrdiff_t>(std::min(ratios.size(), most_known)));
    std::ranges::sort(ratios);
    const double usual = quantile_of_sorted(ratios, 0.5);
    return {
        tables * std::min(quantile_of_sorted(ratios, 0.1), usual / least_error),
        tables * std::max(quantile_of_sorted(ratios, 0.9), usual * least_error)};
}

} // namespace

PastPrices::PastPrices(const std::filesystem::path& cache) {
    if (cache.empty()) {
        return;
    }
    io::require_regular(prices_of(cache));
    std::ifstream file(prices_of(cache));
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        double steps = 0, seconds = 0;
        std::string kind;
        if (words >> steps >> seconds && std::getline(words >> std::ws, kind) && !kind.empty()) {
            Ratios& ratios = of_kind_[kind];
            if (steps > 0) {
                ratios.steps.push_back(steps);
            }
            if (seconds > 0) {
                ratios.seconds.push_back(seconds);
            }
        }
    }
}

void PastPrices::correct(RunPlan& plan) const {
    for (StageEstimate& stage : plan.stages) {
        const auto known = of_kind_.find(stage.kind);
        if (known == of_kind_.end()) {
            continue;
        }
        if (known->second.steps.size() >= least_known && stage.tables_steps > 0) {
            stage.steps = corrected(stage.tables_steps, known->second.steps);
        }
        if (known->second.seconds.size() >= least_known && stage.tables_seconds > 0) {
            stage.seconds = corrected(stage.tables_seconds, known->second.seconds);
        }
    }
    sum_up(plan);
}

void remember_prices(const std::filesystem::path& cache, const std::filesystem::path& run) {
    const std::filesystem::path file = run / "plan.json";
    if (cache.empty() || !std::filesystem::is_directory(cache) || !std::filesystem::exists(file)) {
        return;
    }
    json plan = record::read_json(file);
    std::string lines;
    record::take_from(file, [&] {
        for (json& stage : plan.at("stages")) {
            if (!stage.contains("seconds_taken") || !stage.contains("by_tables") || stage.contains("remembered")) {
                continue;
            }
            const auto ratio = [&](const char* what, double least) {
                const double taken = stage.at(fmt::format("{}_taken", what)), tables = stage.at("by_tables").at(what);
                return taken >= least && tables > 0 ? taken / tables : 0;
            };
            stage["remembered"] = true;
            const std::string kind = stage.at("kind");
            lines += fmt::format("{:.4g} {:.4g} {}\n", ratio("steps", 1), ratio("seconds", least_timed), kind);
        }
    });
    if (!lines.empty()) {
        io::append_to(prices_of(cache), lines); // at once: several programs may add theirs
        record::write_json(file, plan);
    }
}

} // namespace suffuse::plan
