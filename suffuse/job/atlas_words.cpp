#include "suffuse/job/atlas_words.hpp"

#include "suffuse/answer/surrogate_words.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

namespace suffuse::job {
namespace {

using atlas::Found;
using atlas::Node;
using atlas::Value;
using stability::Seepage;

const char* words_of(atlas::Flow flow) {
    return flow == atlas::Flow::Up ? "upward" : "level";
}

/// Those of all flows.
std::vector<const Found*> all_found(const AtlasAnswer& answer) {
    std::vector<const Found*> all;
    for (const AtlasFlow& flow : answer.flows) {
        for (const Found& found : flow.of_density) {
            all.push_back(&found);
        }
    }
    return all;
}

bool is_inside(const AtlasAnswer& answer) {
    return std::ranges::any_of(all_found(answer), [](const Found* found) { return found->node.has_value(); });
}

double heave_of(const Node& node, const Seepage& seepage) {
    return stability::terzaghi_gradient(node.porosity, seepage.grain_density);
}

/// Ramps know a gradient to 0.01.
std::string gradient_text(const std::optional<Value>& over_heave, const atlas::Floor& floor, double heave) {
    constexpr double known_to = 0.01;
    if (!over_heave && !floor.is_reached) {
        return "not reached";
    }
    if (!over_heave) {
        return floor.gradient ? fmt::format(">= {:.2f}", heave * *floor.gradient) : "not known";
    }
    const double gradient = heave * over_heave->mean;
    return gradient < known_to ? "< 0.01" : fmt::format("{}{:.2f}", over_heave->is_at_most ? "<= " : "", gradient);
}

/// Where the whole soil is outside, its nearest one.
std::optional<Node> shown_node(const Found& found, bool is_soil_inside) {
    if (is_soil_inside || found.rows.empty()) {
        return found.node;
    }
    return atlas::gather_nodes(found.rows, found.density, found.flow).front();
}

figures::PageTable table_of(const AtlasAnswer& answer, const Seepage& seepage) {
    const bool is_soil_inside = is_inside(answer);
    figures::PageTable table;
    table.section = "Soils";
    table.title = is_soil_inside ? "Simulated soils like this one" : "The nearest simulated soil";
    table.header = {"density", "porosity", "alpha"};
    std::map<atlas::Density, std::vector<std::string>> rows;
    for (const AtlasFlow& flow : answer.flows) {
        table.header.push_back(fmt::format("{}: 1 % move at i", words_of(flow.flow)));
        table.header.emplace_back("10 % at i");
        for (const Found& found : flow.of_density) {
            std::vector<std::string>& row = rows[found.density];
            row.resize(table.header.size(), "–");
            row[0] = atlas::name_of(found.density);
            if (const std::optional<Node> node = shown_node(found, is_soil_inside)) {
                row[1] = fmt::format("{:.2f}", node->porosity);
                row[2] = fmt::format("{:.2g}", node->alpha.mean);
                *(row.end() - 2) = gradient_text(node->moves_1, node->least_1, heave_of(*node, seepage));
                row.back() = gradient_text(node->moves_10, node->least_10, heave_of(*node, seepage));
            }
        }
    }
    for (auto& [density, row] : rows) {
        row.resize(table.header.size(), "–");
        table.rows.push_back(std::move(row));
    }
    table.numeric.assign(table.header.size(), true);
    table.numeric.front() = false;
    return table;
}

/// Share of the fines' mass that a gradient moves, as far as bounds let that be said.
enum class Moved { Unknown, Below1, From1, From1To10, From10 };

const char* words_of(Moved moved) {
    switch (moved) {
    case Moved::Below1:
        return "less than 1 %";
    case Moved::From1:
        return "1 % or more";
    case Moved::From1To10:
        return "1 to 10 %";
    case Moved::From10:
        return "10 % or more";
    case Moved::Unknown:
        break;
    }
    return "an unknown share";
}

Moved moved_at(const Node& node, const Seepage& seepage) {
    const double heave = heave_of(node, seepage);
    const auto reaches = [&](const std::optional<Value>& value) {
        return value && seepage.gradient >= heave * value->mean;
    };
    const auto stays_below = [&](const atlas::Floor& floor) {
        return floor.gradient && seepage.gradient < heave * *floor.gradient;
    };
    if (reaches(node.moves_10)) {
        return Moved::From10;
    }
    if (reaches(node.moves_1)) {
        return stays_below(node.least_10) ? Moved::From1To10 : Moved::From1;
    }
    return stays_below(node.least_1) ? Moved::Below1 : Moved::Unknown;
}

/// "upward flow moves 10 % or more (loose), 1 to 10 % (dense)"; empty where nothing is inside.
std::string moved_by(const AtlasFlow& flow, const Seepage& seepage) {
    std::vector<std::pair<Moved, std::vector<std::string>>> groups;
    for (const Found& found : flow.of_density) {
        if (!found.node) {
            continue;
        }
        const Moved moved = moved_at(*found.node, seepage);
        if (groups.empty() || groups.back().first != moved) {
            groups.emplace_back(moved, std::vector<std::string>{});
        }
        groups.back().second.emplace_back(atlas::name_of(found.density));
    }
    std::vector<std::string> texts;
    texts.reserve(groups.size());
    for (const auto& [moved, densities] : groups) {
        texts.push_back(fmt::format("{} ({})", words_of(moved), fmt::join(densities, " and ")));
    }
    return texts.empty() ? "" : fmt::format("{} flow moves {}", words_of(flow.flow), fmt::join(texts, ", "));
}

std::string answer_note(const AtlasAnswer& answer, const Seepage& seepage) {
    std::vector<std::string> texts;
    for (const AtlasFlow& flow : answer.flows) {
        if (std::string text = moved_by(flow, seepage); !text.empty()) {
            texts.push_back(std::move(text));
        }
    }
    return fmt::format("at i = {:.4g}, of the mass of the fines: {}", seepage.gradient, fmt::join(texts, "; "));
}

std::string percents(const std::optional<double>& of_1, const std::optional<double>& of_10) {
    const auto percent = [](const std::optional<double>& value) {
        return value ? short_number(100 * *value, 2) + " %" : std::string("unknown");
    };
    return percent(of_1) + " and " + percent(of_10);
}

/// The largest of the densities, relative.
std::optional<double> scatter_of(const AtlasFlow& flow, std::optional<Value> Node::*gradient) {
    std::optional<double> most;
    for (const Found& found : flow.of_density) {
        const std::optional<Value> value = found.node ? (*found.node).*gradient : std::nullopt;
        if (value && value->deviation) {
            most = std::max(most.value_or(0), *value->deviation / value->mean);
        }
    }
    return most;
}

/// How far the numbers are right between nodes.
std::string interpolation_note(const AtlasAnswer& answer) {
    if (std::ranges::none_of(all_found(answer), &Found::is_interpolated)) {
        return "not interpolated";
    }
    std::vector<std::string> errors;
    for (const AtlasFlow& flow : answer.flows) {
        errors.push_back(fmt::format("{} {}", words_of(flow.flow), percents(flow.error.moves_1, flow.error.moves_10)));
    }
    return fmt::format("error of the interpolation at 1 and 10 %: {}", fmt::join(errors, ", "));
}

/// How far another sample may differ.
std::string scatter_note(const AtlasAnswer& answer) {
    int fewest = 0;
    for (const Found* const found : all_found(answer)) {
        fewest = !found->node ? fewest : fewest == 0 ? found->seeds() : std::min(fewest, found->seeds());
    }
    if (fewest == 1) {
        return "scatter not known: one seed";
    }
    std::vector<std::string> scatters;
    for (const AtlasFlow& flow : answer.flows) {
        scatters.push_back(fmt::format(
            "{} {}", words_of(flow.flow), percents(scatter_of(flow, &Node::moves_1), scatter_of(flow, &Node::moves_10))
        ));
    }
    return fmt::format("scatter among {} samples: {}", fewest, fmt::join(scatters, ", "));
}

/// Nothing where no more than a trace of the fines sifts.
std::optional<std::string> sifting_note(const AtlasAnswer& answer) {
    std::map<atlas::Density, double> shares;
    for (const Found* const found : all_found(answer)) {
        if (found->node && found->sifting() > atlas::much_sifting) {
            shares[found->density] = std::max(shares[found->density], found->sifting());
        }
    }
    std::vector<std::string> texts;
    texts.reserve(shares.size());
    for (const auto& [density, share] : shares) {
        texts.push_back(fmt::format("{} % of their mass ({})", short_number(100 * share, 2), atlas::name_of(density)));
    }
    return texts.empty() ? std::nullopt
                         : std::optional(fmt::format(
                               "single fines of this ratio fall through the skeleton by themselves: up to {}",
                               fmt::join(texts, ", ")
                           ));
}

/// Nothing where the soil's fines are like those of the atlas.
std::optional<std::string> width_note(const TwoParts& parts) {
    if (!parts.has_wide_fines()) {
        return std::nullopt;
    }
    return fmt::format(
        "too high for this soil: its fines are wide (d90/d10 {}), and the smallest move first; the atlas has fines of "
        "one size. For soils with fines a factor of 3 to 4 wide its first gradients were 28 to 38 % too high",
        parts.fines_width ? short_number(*parts.fines_width, 2) : "not measured"
    );
}

std::vector<std::string> inside_notes(const AtlasAnswer& answer, const Seepage& seepage) {
    std::vector<std::string> notes = {
        answer_note(answer, seepage), interpolation_note(answer) + "; " + scatter_note(answer)};
    if (auto sifting = sifting_note(answer)) {
        notes.push_back(std::move(*sifting));
    }
    if (auto width = width_note(*answer.parts)) {
        notes.push_back(std::move(*width));
    }
    return notes;
}

std::vector<std::string> outside_notes(const AtlasAnswer& answer) {
    const std::vector<const Found*> all = all_found(answer);
    const auto with_rows = std::ranges::find_if(all, [](const Found* found) { return !found->rows.empty(); });
    std::vector<std::string> notes = {"the atlas has " + answer.extent};
    if (with_rows != all.end()) {
        const atlas::Row& nearest = (*with_rows)->rows.front();
        notes.front() += fmt::format(
            "; the lines are of its nearest soil, D50/d50 {} and {} % of fines, and no answer for this one",
            short_number(nearest.size_ratio), short_number(100 * nearest.fines_content)
        );
    }
    if (answer.parts->size_ratio > answer::sifting_ratio) {
        notes.push_back(fmt::format(
            "above a size ratio of {} single fines may fall through the skeleton by themselves",
            short_number(answer::sifting_ratio)
        ));
    }
    return notes;
}

std::size_t shown_width(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

} // namespace

AtlasWords atlas_words(const AtlasAnswer& answer, const Seepage& seepage) {
    const std::string title = "atlas of simulated soils: ";
    if (!answer.parts) {
        return {title + answer.no_parts, {}, {}};
    }
    if (answer.flows.empty()) {
        return {title + "it has upward and level flow, none downward", {}, {}};
    }
    const TwoParts& parts = *answer.parts;
    const bool is_soil_inside = is_inside(answer);
    return {
        fmt::format(
            "{}{}D50/d50 {}, {} % of fines (split at {} mm: {})", is_soil_inside ? "" : "outside the ", title,
            short_number(parts.size_ratio), short_number(100 * parts.fines_content),
            short_number(1e3 * parts.finer_than), parts.reason
        ),
        table_of(answer, seepage), is_soil_inside ? inside_notes(answer, seepage) : outside_notes(answer)};
}

std::string text_of(const AtlasWords& words) {
    std::string text = "  " + words.heading + "\n";
    if (words.table) {
        std::vector<std::vector<std::string>> lines = words.table->rows;
        lines.insert(lines.begin(), words.table->header);
        for (const std::vector<std::string>& cells : lines) {
            std::string line = " ";
            std::size_t gap = 0; // to the next column
            for (std::size_t k = 0; k < cells.size(); ++k) {
                line += std::string(gap, ' ') + " " + cells[k];
                const std::size_t width = std::max<std::size_t>(words.table->header[k].size(), 9) + 1;
                gap = width - std::min(width, shown_width(cells[k]));
            }
            text += line + "\n";
        }
    }
    for (const std::string& note : words.notes) {
        text += "  " + note + "\n";
    }
    return text;
}

} // namespace suffuse::job
