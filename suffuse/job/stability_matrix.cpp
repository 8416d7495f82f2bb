#include "suffuse/job/stability_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <tuple>

namespace suffuse::job {

namespace {

using nlohmann::json;
using stability::Criterion;
using stability::Verdict;

/// "Kenney and Lau 1985" -> "KL85": initials and the year.
std::string short_name(const std::string& name) {
    std::string initials;
    for (std::size_t k = 0; k < name.size(); ++k) {
        const bool begins = k == 0 || name[k - 1] == ' ' || name[k - 1] == '-';
        if (begins && std::isupper(static_cast<unsigned char>(name[k])) != 0) {
            initials += name[k];
        }
    }
    const std::size_t year = name.find_first_of("12");
    return initials + (year != std::string::npos && year + 4 <= name.size() ? name.substr(year + 2, 2) : "");
}

std::string cell_text(const Criterion& criterion) {
    constexpr const char* letters[] = {"s", "t", "U", "?"};
    const std::optional<double> value = criterion.value ? criterion.value : criterion.measured;
    const std::string number = !value ? "" : *value < 1000 ? fmt::format(" {:.3g}", *value) : std::string(" >999");
    return letters[static_cast<int>(criterion.verdict)] + number;
}

/// Of a gradient that all soils bear, the critical one is what differs between them.
std::string gradient_cell(Criterion criterion) {
    criterion.value = criterion.limit, criterion.measured.reset();
    return cell_text(criterion);
}

/// How far on the unstable side a number lies, as a ratio to its limit; nothing where it has none.
double badness(const Criterion& criterion) {
    if (!criterion.value || !criterion.limit || !(*criterion.limit > 0)) {
        return criterion.verdict == Verdict::Unstable ? 1 : 0;
    }
    return criterion.sense == stability::Sense::AtMost ? *criterion.value / *criterion.limit
                                                       : *criterion.limit / std::max(*criterion.value, 1e-12);
}

std::vector<std::size_t> counted_columns(const AssessedSoil& soil) {
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < soil.assessment.criteria.size(); ++k) {
        if (soil.assessment.criteria[k].verified) {
            columns.push_back(k);
        }
    }
    return columns;
}

/// The soil whose number is farthest beyond the limit, of those that it calls unstable; none where it calls none.
std::optional<std::size_t> worst_by(const std::vector<AssessedSoil>& soils, std::size_t criterion) {
    std::optional<std::size_t> worst;
    for (std::size_t k = 0; k < soils.size(); ++k) {
        const Criterion& here = soils[k].assessment.criteria[criterion];
        const bool is_worse = !worst || badness(here) > badness(soils[*worst].assessment.criteria[criterion]);
        if (here.verdict == Verdict::Unstable && is_worse) {
            worst = k;
        }
    }
    return worst;
}

} // namespace

std::size_t find_worst(const std::vector<AssessedSoil>& soils) {
    const auto rank = [](const AssessedSoil& soil) {
        const stability::Tally tally = stability::count_verdicts(soil.assessment.criteria);
        const auto& ratio = soil.assessment.criteria[stability::kenney_lau_1985_row].value;
        return std::tuple(-tally.unstable, -tally.transition, ratio.value_or(std::numeric_limits<double>::max()));
    };
    const auto least = std::min_element(soils.begin(), soils.end(), [&rank](const auto& a, const auto& b) {
        return rank(a) < rank(b);
    });
    return static_cast<std::size_t>(least - soils.begin());
}

std::string matrix_text(const std::vector<AssessedSoil>& soils, const std::optional<stability::Seepage>& seepage) {
    const std::vector<std::size_t> columns = counted_columns(soils.front());
    std::size_t width = 6;
    for (const AssessedSoil& soil : soils) {
        width = std::min<std::size_t>(32, std::max(width, soil.name.size()));
    }
    std::string text = fmt::format("{:{}}", "soil", width), legend;
    for (const std::size_t k : columns) {
        const std::string& name = soils.front().assessment.criteria[k].name;
        text += fmt::format("  {:7}", short_name(name));
        legend += fmt::format("{}{} {}", legend.empty() ? "" : ", ", short_name(name), name);
    }
    const std::vector<Criterion>& gradients = soils.front().assessment.gradients; // all soils have these, or none has
    for (std::size_t k = 0; k < gradients.size(); ++k) {
        text += fmt::format("  {:7}", short_name(gradients[k].name));
        legend += fmt::format(
            ", {} {}{}", short_name(gradients[k].name), gradients[k].name,
            k + 1 == gradients.size() ? ", each with its critical gradient" : ""
        );
    }
    for (const AssessedSoil& soil : soils) {
        const std::string name =
            soil.name.size() > width ? ".." + soil.name.substr(soil.name.size() - width + 2) : soil.name;
        text += fmt::format("\n{:{}}", name, width);
        for (const std::size_t k : columns) {
            text += fmt::format("  {:7}", cell_text(soil.assessment.criteria[k]));
        }
        for (const Criterion& gradient : soil.assessment.gradients) {
            text += fmt::format("  {:7}", gradient_cell(gradient));
        }
        text.erase(text.find_last_not_of(' ') + 1);
    }
    const AssessedSoil& worst = soils[find_worst(soils)];
    text += fmt::format("\n\nworst: {}: {}", worst.name, stability::summary(worst.assessment.criteria));
    text += fmt::format(
        "\nU unstable, t transition, s stable, ? cannot say, each with its number (behind ? that of the measured "
        "part); "
        "{}",
        legend
    );
    for (const AssessedSoil& soil : soils) {
        text += soil.filter ? fmt::format("\n\n{}\n{}", soil.name, filter_text(*soil.filter)) : "";
    }
    if (seepage) { // what the atlas says of each soil has no room here
        text += fmt::format(
            "\n{}{}\ngradients that moved the fines of simulated soils: -o DIR, --json, or one FILE at a time",
            seepage_text(*seepage), seepage->lifts() ? "" : fmt::format("; {}", no_heave_text)
        );
    }
    return text;
}

json matrix_json(const std::vector<AssessedSoil>& soils) {
    json rows = json::array(), worst_of = json::object();
    for (const AssessedSoil& soil : soils) {
        json verdicts = json::object();
        for (const std::size_t k : counted_columns(soil)) {
            const Criterion& criterion = soil.assessment.criteria[k];
            verdicts[criterion.id] = stability::verdict_word(criterion.verdict);
        }
        rows.push_back({{"soil", soil.name}, {"verdicts", verdicts}});
    }
    for (const std::size_t k : counted_columns(soils.front())) {
        const auto worst = worst_by(soils, k);
        worst_of[soils.front().assessment.criteria[k].id] = worst ? json(soils[*worst].name) : json(nullptr);
    }
    return {{"soils", rows}, {"worst", soils[find_worst(soils)].name}, {"worst_by_criterion", worst_of}};
}

} // namespace suffuse::job
