#include "suffuse/casefile/load_case.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/casefile/overrides.hpp"
#include "suffuse/casefile/read_toml.hpp"

#include <algorithm>
#include <filesystem>

namespace suffuse::casefile {

namespace {

/// The preset in force: the command line's, the case's, or the one that a resolved case holds already.
std::string choose_preset(Node& root, const LoadOptions& options, Problems& problems) {
    const auto text_at = [&](std::string_view key) {
        const Node::Entry* entry = root.find(key);
        return entry != nullptr && entry->value.is_text() ? entry->value.text : "";
    };
    const bool is_requested = !options.preset.empty();
    const std::string name = is_requested ? options.preset : text_at("preset");
    if (name.empty()) {
        const std::string applied = text_at("applied_preset");
        return applied.empty() ? "standard" : applied;
    }
    const Place place_of_preset =
        is_requested
            ? Place{std::make_shared<Source>(Source{"--preset", options.preset}), 1, 1, static_cast<int>(options.preset.size())}
            : root.find("preset")->value.place;
    const bool weighs = root.find("gravity") != nullptr || std::ranges::any_of(options.overrides, sets_gravity);
    apply_preset(root, name, place_of_preset, weighs, problems);
    return name;
}

} // namespace

LoadedCase load_case_text(
    const std::string& text, const std::string& name, const std::string& folder, const LoadOptions& options
) {
    Problems problems;
    LoadedCase loaded;
    std::vector<std::string> overrides = options.overrides;
    if (auto root = read_toml(std::make_shared<Source>(Source{name, text}), problems)) {
        // What is set of presets comes before the preset, and what the preset sets before what is set of other keys.
        const auto middle = std::stable_partition(overrides.begin(), overrides.end(), sets_preset);
        std::for_each(overrides.begin(), middle, [&](const auto& o) { apply_override(*root, o, problems); });
        const std::string preset = choose_preset(*root, options, problems);
        std::for_each(overrides.begin(), middle, [&](const auto& o) { check_preset_override(o, preset, problems); });
        std::for_each(middle, overrides.end(), [&](const auto& o) { apply_override(*root, o, problems); });
        keep_studies(*root, options.studies, problems);
        std::for_each(middle, overrides.end(), [&](const auto& o) { check_swept_override(*root, o, problems); });
        loaded.value = bind_case(*root, folder, preset, problems);
    }
    if (problems.has_errors()) {
        throw CaseProblems(problems.sorted());
    }
    loaded.warnings = problems.sorted();
    return loaded;
}

LoadedCase load_case(const std::string& path, const LoadOptions& options) {
    return load_case_text(read_whole_file(path), path, std::filesystem::path(path).parent_path().string(), options);
}

} // namespace suffuse::casefile
