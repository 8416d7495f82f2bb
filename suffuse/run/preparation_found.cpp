#include "suffuse/run/preparation_found.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/prepared_as.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/run/sample_run.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::run {
namespace {

namespace fs = std::filesystem;

const casefile::Variant& other_sample(const record::Sample& sample, const casefile::Stage& stage) {
    const casefile::Variant* other = casefile::sample_to_prepare_by(*sample.study, *sample.variant, stage);
    expects(other != nullptr, "a stage is prepared as one of a sample that the case has");
    return *other;
}

fs::path other_stage(const fs::path& folder, const record::Sample& sample, const casefile::Stage& stage) {
    const casefile::Variant& other = other_sample(sample, stage);
    return record::stage_folder(folder, other, *casefile::find_stage(other, stage.name));
}

/// Makes the stages of the other sample up to this one in a folder of its own, which goes when it has been read.
nlohmann::json make_for_itself(
    const casefile::Case& what, const RunOptions& options, const record::Sample& sample, const casefile::Stage& stage
) {
    const casefile::Variant& other = other_sample(sample, stage);
    const casefile::Stage* const last = casefile::find_stage(other, stage.name);
    RunOptions own;
    own.folder = record::stage_folder(options.folder, *sample.variant, stage) / "prepared-as";
    own.cache = options.cache;
    own.cache_owners = options.cache_owners;
    own.stop = options.stop;
    own.sample = other.folder;
    Overview quiet(own);
    const record::Sample needed{sample.study, &other, 1, 1, static_cast<int>(last - other.stages.data()) + 1};
    record::open_folder(own.folder, what, {});
    SampleRun(what, own, needed, quiet).run();
    nlohmann::json numbers = record::read_json(record::stage_folder(own.folder, other, *last) / "stage.json");
    std::error_code error;
    fs::remove_all(own.folder, error);
    return numbers;
}

nlohmann::json numbers_of_other(
    const casefile::Case& what, const RunOptions& options, const record::Sample& sample, const casefile::Stage& stage
) {
    const fs::path file = other_stage(options.folder, sample, stage) / "stage.json";
    if (fs::exists(file)) {
        record::check_file(file);
        return record::read_json(file);
    }
    if (options.sample.empty()) {
        throw StateError(fmt::format(
            "it is prepared as {}, which has not been made: see what failed there",
            record::stage_name(other_sample(sample, stage), stage)
        ));
    }
    return make_for_itself(what, options, sample, stage);
}

} // namespace

bool waits_for_another(const record::Sample& sample, const fs::path& folder) {
    return std::ranges::any_of(sample.variant->stages, [&](const casefile::Stage& stage) {
        return casefile::is_prepared_as_another(*sample.variant, stage) &&
               !fs::exists(other_stage(folder, sample, stage) / "stage.json");
    });
}

casefile::Stage with_preparation_found(
    const casefile::Case& what, const RunOptions& options, const record::Sample& sample, const casefile::Stage& stage
) {
    casefile::Stage found = stage;
    if (!casefile::is_prepared_as_another(*sample.variant, stage)) {
        return found;
    }
    const nlohmann::json numbers = numbers_of_other(what, options, sample, stage);
    auto& compact = std::get<packing::CompactSpec>(found.spec);
    record::take_from(other_stage(options.folder, sample, stage) / "stage.json", [&] {
        compact.prepare.friction = numbers.at("preparation_friction").get<double>();
        const nlohmann::json& adhesion = numbers.at("preparation_adhesion");
        compact.prepare.adhesion_normal = adhesion.at("normal").get<double>();
        compact.prepare.adhesion_shear = adhesion.at("shear").get<double>();
        if (numbers.contains("preparation_start_porosity")) {
            compact.start_porosity = numbers.at("preparation_start_porosity").get<double>();
        }
    });
    compact.void_ratio = compact.intergranular_void_ratio = compact.prepared_as = std::nullopt;
    return found;
}

} // namespace suffuse::run
