#include "suffuse/gradings/reading_options.hpp"

#include "suffuse/base/shell_word.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <fmt/format.h>

namespace suffuse::gradings {

bool ReadingOptions::is_empty() const {
    return !name_columns() && by.empty() && !sheet && rows.empty();
}

bool ReadingOptions::name_columns() const {
    return !(size.empty() && passing.empty() && retained.empty() && share.empty() && mass.empty());
}

std::string command_words(const ReadingOptions& options) {
    std::string words;
    for (const auto& [flag, value] :
         {std::pair{"--size", options.size},
          {"--passing", options.passing},
          {"--retained", options.retained},
          {"--share", options.share},
          {"--mass", options.mass},
          {"--by", options.by},
          {"--sheet", options.sheet ? fmt::format("{}", *options.sheet) : ""},
          {"--rows", options.rows}}) {
        if (!value.empty()) {
            words += fmt::format("{}{} {}", words.empty() ? "" : " ", flag, shell_word(value));
        }
    }
    return words;
}

NamedColumn split_column(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) {
        return {std::string(trimmed(text)), {}};
    }
    const std::string unit(trimmed(std::string_view(text).substr(colon + 1)));
    const bool is_unit =
        unit == "%" || size_scale_of(unit) != SizeScale::Unknown || share_unit_named(unit) != ShareUnit::Unknown;
    return is_unit ? NamedColumn{std::string(trimmed(std::string_view(text).substr(0, colon))), unit}
                   : NamedColumn{std::string(trimmed(text)), {}};
}

std::optional<std::pair<int, int>> split_lines(const std::string& text) {
    const std::size_t dash = text.find('-');
    const auto first = io::number_of<int>(text.substr(0, dash));
    const auto last = dash == std::string::npos ? std::nullopt : io::number_of<int>(text.substr(dash + 1));
    return first && last && *first > 0 && *last >= *first ? std::optional(std::pair(*first, *last)) : std::nullopt;
}

std::string words_of(const SheetReading& reading) {
    return fmt::format(
        "sizes: {}, in {}; shares: {}, read as {}, in {}", reading.size.empty() ? "no heading" : reading.size,
        reading.size_unit, reading.share.empty() ? "no heading" : reading.share, reading.kind, reading.share_unit
    );
}

} // namespace suffuse::gradings
