#include "suffuse/record/missing_stages.hpp"

#include "suffuse/record/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace suffuse::record {

MissingStages find_missing_stages(const casefile::Case& what, const std::filesystem::path& run) {
    MissingStages missing;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            for (const casefile::Stage& stage : variant.stages) {
                ++missing.of;
                if (!std::filesystem::exists(stage_folder(run, variant, stage) / "stage.json")) {
                    missing.names.push_back(stage_name(variant, stage));
                }
            }
        }
    }
    return missing;
}

bool is_complete(const Sample& sample, const std::filesystem::path& run) {
    const auto& stages = sample.variant->stages;
    return std::all_of(stages.begin(), stages.begin() + sample.stages, [&](const casefile::Stage& stage) {
        return std::filesystem::exists(stage_folder(run, *sample.variant, stage) / "stage.json");
    });
}

std::string describe_missing(const MissingStages& missing) {
    constexpr std::size_t most_named = 8;
    const std::size_t count = missing.names.size(), named = std::min(count, most_named);
    if (count == 0) {
        return "";
    }
    return fmt::format(
        "{} of {} {} missing: {}{}", count, missing.of, missing.of == 1 ? "stage is" : "stages are",
        fmt::join(std::span(missing.names).first(named), ", "),
        count > named ? fmt::format(" and {} more", count - named) : ""
    );
}

} // namespace suffuse::record
