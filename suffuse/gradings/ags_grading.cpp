#include "suffuse/gradings/ags_grading.hpp"

#include "suffuse/gradings/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace suffuse::gradings {

namespace {

constexpr std::string_view group_name = "GRAT";

/// The rows of one group.
struct Group {
    const SheetRow *heading = nullptr, *unit = nullptr;
    std::vector<const SheetRow*> data;
};

Group find_group(const Sheet& sheet) {
    Group group;
    bool is_inside = false;
    for (const SheetRow& row : sheet.rows) {
        const std::string& word = text_at(row, 0);
        if (word == "GROUP") {
            is_inside = text_at(row, 1) == group_name;
        } else if (is_inside && word == "HEADING") {
            group.heading = &row;
        } else if (is_inside && word == "UNIT") {
            group.unit = &row;
        } else if (is_inside && word == "DATA") {
            group.data.push_back(&row);
        }
    }
    return group;
}

std::optional<std::size_t> find_heading(const SheetRow& headings, std::string_view name) {
    const auto found = std::ranges::find(headings.cells, name, &SheetCell::text);
    return found == headings.cells.end() ? std::nullopt
                                         : std::optional(static_cast<std::size_t>(found - headings.cells.begin()));
}

/// "A1 1.20 m B1": location, depth, and what else distinguishes its samples.
class SoilNames {
public:
    explicit SoilNames(const Group& group) {
        for (const char* name : {"LOCA_ID", "SAMP_TOP", "SAMP_TYPE", "SAMP_REF", "SAMP_ID", "SPEC_REF", "SPEC_DPTH"}) {
            if (const auto column = find_heading(*group.heading, name)) {
                columns_.push_back({*column, std::string_view(name) == "SAMP_TOP" ? " m" : ""});
            }
        }
        // the shortest list of headings that distinguishes all of them; location and depth always
        std::size_t enough = std::min<std::size_t>(2, columns_.size());
        while (enough < columns_.size() && count(group, enough) < count(group, columns_.size())) {
            ++enough;
        }
        columns_.resize(enough);
    }

    [[nodiscard]] std::string of(const SheetRow& row) const { return name(row, columns_.size()); }

private:
    [[nodiscard]] std::string name(const SheetRow& row, std::size_t parts) const {
        std::string text;
        for (std::size_t k = 0; k < parts; ++k) {
            if (const std::string& part = text_at(row, columns_[k].first); !part.empty()) {
                append_word(text, part + columns_[k].second);
            }
        }
        return text;
    }

    [[nodiscard]] std::size_t count(const Group& group, std::size_t parts) const {
        std::set<std::string> names;
        for (const SheetRow* row : group.data) {
            names.insert(name(*row, parts));
        }
        return names.size();
    }

    std::vector<std::pair<std::size_t, const char*>> columns_;
};

} // namespace

bool looks_like_ags(std::string_view text) {
    const std::string_view start = trimmed(text.substr(0, std::min<std::size_t>(text.size(), 256)));
    return start.starts_with("\"GROUP\"") || start.starts_with("\"**");
}

std::optional<std::vector<SievedSoil>> read_ags(const std::shared_ptr<const Source>& source, Problems& problems) {
    const Place whole{source, 0, 0, 1};
    if (trimmed(source->text).starts_with("\"**")) {
        problems.error("E506", whole, "the file is of AGS 3 or older", "save it as AGS 4, whose group GRAT is read");
        return std::nullopt;
    }
    const Sheet sheet = split_sheet(source, ',');
    const Group group = find_group(sheet);
    if (group.heading == nullptr || group.data.empty()) {
        problems.error(
            "E506", whole, "the AGS file has no rows in a group GRAT", "gradings are in that group: was it exported?"
        );
        return std::nullopt;
    }
    const auto size = find_heading(*group.heading, "GRAT_SIZE"), share = find_heading(*group.heading, "GRAT_PERP");
    if (!size || !share) {
        problems.error(
            "E506", group.heading->place, "the group GRAT has no GRAT_SIZE or no GRAT_PERP", "AGS 4 has both in it"
        );
        return std::nullopt;
    }
    const std::string unit = group.unit != nullptr ? text_at(*group.unit, *size) : "mm";
    const SizeScale scale = size_scale_of(unit);
    const SoilNames names(group);
    std::vector<SievedSoil> soils;
    std::map<std::string, std::size_t> index;
    bool is_good = true;
    const SheetRow* not_used = nullptr;
    std::size_t unused = 0;
    for (const SheetRow* row : group.data) {
        const auto diameter =
            read_sieve_size(text_at(*row, *size), scale == SizeScale::Unknown ? SizeScale::Millimeters : scale, false);
        const auto passing = plain_number(text_at(*row, *share), false);
        if (diameter && is_blank(text_at(*row, *share))) {
            not_used = not_used == nullptr ? row : not_used, ++unused;
            continue;
        }
        if (!diameter || !passing) {
            problems.error(
                "E502", place_at(*row, diameter ? *share : *size),
                fmt::format("\"{}\" is not a number", text_at(*row, diameter ? *share : *size)),
                "GRAT_SIZE in mm, GRAT_PERP in percent"
            );
            is_good = false;
            continue;
        }
        const std::string name = names.of(*row);
        const auto [found, is_new] = index.try_emplace(name, soils.size());
        if (is_new) {
            SievedSoil soil;
            soil.name = name, soil.heading = "GRAT_PERP", soil.size_heading = "GRAT_SIZE";
            soil.heading_place = group.heading->place, soil.end = row->place;
            soils.push_back(std::move(soil));
        }
        soils[found->second].sieves.push_back(
            {diameter->diameter, *passing / 100, place_at(*row, *size), place_at(*row, *share), true}
        );
    }
    if (not_used != nullptr) {
        problems.warning(
            sheet_remark, not_used->place,
            fmt::format("rows without a GRAT_PERP, {} from here on: skipped as not used", unused)
        );
    }
    for (SievedSoil& soil : soils) { // rows of AGS have no order: those of sieves and hydrometer run as each may
        std::ranges::stable_sort(soil.sieves, {}, &SieveRow::diameter);
    }
    return is_good ? std::optional(std::move(soils)) : std::nullopt;
}

} // namespace suffuse::gradings
