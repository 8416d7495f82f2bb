#include "suffuse/record/stage_start.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>

namespace suffuse::record {
namespace {

std::string stated_hash(const std::filesystem::path& stage_folder, const char* state) {
    const std::filesystem::path numbers = stage_folder / "stage.json";
    if (!std::filesystem::exists(numbers)) {
        return "";
    }
    const nlohmann::json read = read_json(numbers);
    return take_from(numbers, [&] { return read.value(state, ""); });
}

} // namespace

void check_start(const casefile::Variant& variant, const casefile::Stage& stage, const std::filesystem::path& run) {
    if (stage.parent < 0) {
        return;
    }
    const casefile::Stage& parent = variant.stages[static_cast<std::size_t>(stage.parent)];
    const std::filesystem::path folder = stage_folder(run, variant, stage);
    const std::string start = stated_hash(folder, "start_state"),
                      end = stated_hash(stage_folder(run, variant, parent), "end_state");
    if (!start.empty() && !end.empty() && start != end) {
        throw IoError(fmt::format(
            "{}: was computed from the state {}, and {} now ends with {}; {}", folder.string(), start,
            stage_name(variant, parent), end, advice_for({folder})
        ));
    }
}

} // namespace suffuse::record
