#include "suffuse/record/stage_key.hpp"

#include "suffuse/casefile/dependencies.hpp"
#include "suffuse/casefile/schema.hpp"

#include <filesystem>
#include <string_view>
#include <variant>

namespace suffuse::record {
namespace {

constexpr const char* layout_of_key = "1"; // of the text whose SHA-256 is the key
constexpr std::size_t form_digits = 8;

const std::string& form() {
    static const std::string digits = [] {
        std::string text = layout_of_key;
        for (const casefile::Key& key : casefile::schema()) {
            text += "\n" + key.table + "." + key.name + " = " + key.default_text;
        }
        return checksum_of_text(text).substr(0, form_digits);
    }();
    return digits;
}

} // namespace

Sums sums_of_imported(const casefile::Stage& stage) {
    Sums sums;
    if (const auto* import = std::get_if<casefile::ImportSpec>(&stage.spec)) {
        sums["packing"] = checksum_of(import->path);
        if (!import->contacts.empty()) {
            sums["contacts"] = checksum_of(import->contacts);
        }
    }
    return sums;
}

std::string key_of_stage(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage,
    const std::string& start_state, const Sums& imported
) {
    std::string text = "start " + start_state + "\n";
    if (const auto* import = std::get_if<casefile::ImportSpec>(&stage.spec)) {
        text += "packing " + std::filesystem::path(import->path).filename().string() + "\n";
        text += import->contacts.empty()
                    ? ""
                    : "contacts " + std::filesystem::path(import->contacts).filename().string() + "\n";
        text += sums_text(imported);
    }
    return form() + ":" + checksum_of_text(text + casefile::dependencies_of(what, variant, stage));
}

SameStage compare_keys(const std::string& found, const std::string& expected) {
    const auto form_of = [](std::string_view key) { return key.substr(0, key.find(':')); };
    if (form_of(found) != form_of(expected)) {
        return SameStage::Unknown;
    }
    return found == expected ? SameStage::Yes : SameStage::No;
}

} // namespace suffuse::record
