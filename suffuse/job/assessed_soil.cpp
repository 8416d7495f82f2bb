#include "suffuse/job/assessed_soil.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/job/atlas_words.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/stability/size_classes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::job {
namespace {

using nlohmann::json;
using stability::Assessment;
using stability::Criterion;

json criterion_json(const Criterion& criterion) {
    return {
        {"id", criterion.id},
        {"name", criterion.name},
        {"measure", criterion.measure},
        {"value", or_null(criterion.value)},
        {"measured", or_null(criterion.measured)},
        {"limit", or_null(criterion.limit)},
        {"upper", or_null(criterion.upper)},
        {"sense", stability::name_of(criterion.sense)},
        {"stable_if", stability::limit_text(criterion)},
        {"verdict", stability::verdict_word(criterion.verdict)},
        {"verified", criterion.verified},
        {"remark", criterion.remark},
        {"source", criterion.source},
        {"diameter", or_null(criterion.diameter)}};
}

json list_json(const std::vector<Criterion>& criteria) {
    json list = json::array();
    for (const Criterion& criterion : criteria) {
        list.push_back(criterion_json(criterion));
    }
    return list;
}

/// Where the curve was measured [m].
std::optional<double> size_of(const Assessment& found, double share) {
    const bool is_known = share >= found.missing_fine && share <= 1 - found.missing_coarse;
    return is_known ? std::optional(grains::size_at(found.grading, share)) : std::nullopt;
}

std::optional<double> uniformity_of(const Assessment& found) {
    const auto d10 = size_of(found, 0.10), d60 = size_of(found, 0.60);
    return d10 && d60 ? std::optional(*d60 / *d10) : std::nullopt;
}

std::string mm(double size) {
    return fmt::format("{:.3g}", 1e3 * size);
}

std::string opening(const AssessedSoil& soil) {
    const Assessment& found = soil.assessment;
    const auto size = [&found](double share) {
        const auto value = size_of(found, share);
        return value ? mm(*value) : std::string("?");
    };
    const auto uniformity = uniformity_of(found);
    std::string text = fmt::format(
        "{}  d10 {}  d50 {}  d60 {} mm  Cu {}", soil.name, size(0.10), size(0.50), size(0.60),
        uniformity ? fmt::format("{:.3g}", *uniformity) : "?"
    );
    if (found.missing_fine > 0 || found.missing_coarse > 0) {
        text += fmt::format(
            "  measured from {:.3g} to {:.3g} % passing", 100 * found.missing_fine, 100 * (1 - found.missing_coarse)
        );
    }
    if (const auto& gap = soil.assessment.gap) {
        text += fmt::format("  gap at {}-{} mm", mm(gap->fine_end), mm(gap->coarse_end));
    }
    if (const auto& fines = soil.assessment.fines) {
        text += fmt::format(
            "  fines {:.3g} % below {} mm ({})", 100 * fines->content, mm(fines->finer_than),
            stability::basis_text(fines->basis)
        );
    }
    return text + "\n";
}

/// "Kezdi 1979   D15c/d85f 11.4   <= 4   unstable   remark"; on narrow terminals the remark stands below.
std::string line_of(const Criterion& criterion, std::size_t columns) {
    constexpr std::size_t wide = 120;
    const std::string number = criterion.measured ? fmt::format("{} {:.3g} *", criterion.measure, *criterion.measured)
                               : criterion.value  ? fmt::format("{} {:.3g}", criterion.measure, *criterion.value)
                                                  : criterion.measure;
    const std::string first =
        fmt::format("  {:25}{:27}{:14}", criterion.name, number, stability::limit_text(criterion));
    const char* const verdict = stability::verdict_word(criterion.verdict);
    return columns < wide ? fmt::format("{}{}\n      {}\n", first, verdict, criterion.remark)
                          : fmt::format("{}{:12}{}\n", first, verdict, criterion.remark);
}

std::string heading(const char* first) {
    return fmt::format("  {:25}{:27}{:14}{}\n", first, "number", "stable if", "verdict");
}

std::string gradient_lines(const stability::Seepage& seepage, const Assessment& found, std::size_t columns) {
    std::string text = "\n  " + seepage_text(seepage) + "\n";
    if (!seepage.lifts()) {
        text += fmt::format("  {}\n", no_heave_text);
    }
    for (const Criterion& criterion : found.gradients) {
        text += line_of(criterion, columns);
    }
    return text;
}

} // namespace

const char* const no_heave_text =
    "only upward flow lifts grains: heave i_c and alpha i_c of Skempton and Brogan are no limits here";

namespace {

json classes_json(const std::vector<stability::SizeClass>& classes) {
    json shares = json::object();
    for (const stability::SizeClass& one : classes) {
        shares[one.name] = or_null(one.share);
    }
    return shares;
}

json filter_json(const AssessedFilter& filter) {
    json list = list_json(filter.check.criteria);
    for (std::size_t k = 0; k < list.size(); ++k) {
        list[k]["verdict"] = stability::filter_word(filter.check.criteria[k].verdict);
    }
    return {
        {"filter", filter.name},
        {"verdict", stability::filter_word(filter.check.verdict)},
        {"summary", stability::filter_summary(filter.check)},
        {"simulated", filter_atlas_json(filter.simulated)},
        {"criteria", list}};
}

} // namespace

json soil_json(const AssessedSoil& soil, const stability::AssessSpec& spec) {
    const Assessment& found = soil.assessment;
    json sizes = json::object();
    for (const int percent : {5, 10, 15, 50, 60, 85, 90}) {
        const auto size = size_of(found, percent / 100.0);
        sizes[fmt::format("d{}", percent)] = or_null(size);
    }
    const stability::Tally tally = stability::count_verdicts(found.criteria);
    const stability::FinesAgainstConstrictions& constrictions = found.constrictions;
    json about = {
        {"soil", soil.name},
        {"sizes", sizes},
        {"uniformity", or_null(uniformity_of(found))},
        {"gap", nullptr},
        {"fine_fraction", nullptr},
        {"finer_limit", found.finer_limit},
        {"missing_fine", found.missing_fine},
        {"missing_coarse", found.missing_coarse},
        {"criteria", list_json(found.criteria)},
        {"gradients", list_json(found.gradients)},
        {"seepage", nullptr},
        {"constrictions", nullptr},
        {"tally",
         {{"stable", tally.stable},
          {"transition", tally.transition},
          {"unstable", tally.unstable},
          {"cannot_say", tally.cannot_say},
          {"unverified", tally.unverified}}},
        {"summary", stability::summary(found.criteria)}};
    if (!soil.measured.diameter.empty()) {
        about["classes"] = {
            {"astm", classes_json(stability::astm_classes(soil.measured))},
            {"iso", classes_json(stability::iso_classes(soil.measured))}};
        about["atlas"] = atlas_json(consult_atlas(soil.measured, spec), spec);
    }
    if (found.gap) {
        about["gap"] = {{"from", found.gap->fine_end}, {"to", found.gap->coarse_end}, {"finer", found.gap->finer}};
    }
    if (found.fines) {
        about["fine_fraction"] = {
            {"finer_than", found.fines->finer_than},
            {"content", found.fines->content},
            {"basis", stability::basis_text(found.fines->basis)}};
    }
    if (found.has_constrictions) {
        about["constrictions"] = {
            {"split", constrictions.split},
            {"d35_densest", constrictions.densest_d35},
            {"d35_loosest", constrictions.loosest_d35},
            {"fines_d85_by_surface", constrictions.fines_d85},
            {"fines_smaller_densest", constrictions.densest_passes},
            {"fines_smaller_loosest", constrictions.loosest_passes}};
    }
    if (spec.seepage) {
        about["seepage"] = {
            {"gradient", spec.seepage->gradient},
            {"porosity", spec.seepage->porosity},
            {"grain_density", spec.seepage->grain_density},
            {"stress_share", or_null(spec.seepage->stress_share)},
            {"flow", spec.seepage->flow ? json(stability::name_of(*spec.seepage->flow)) : json(nullptr)}};
    }
    if (soil.filter) {
        about["filter"] = filter_json(*soil.filter);
    }
    return about;
}

std::string seepage_text(const stability::Seepage& seepage) {
    const stability::FlowWay way = seepage.way();
    const bool is_named = way == stability::upward || way == stability::downward || way == stability::level_flow;
    return fmt::format(
        "{} seepage{}, i = {:.4g}; porosity {:.3g}, grains {:.4g} kg/m3", stability::kind_of(way),
        is_named ? "" : fmt::format(" at {:g} degrees", std::abs(way.rise)), seepage.gradient, seepage.porosity,
        seepage.grain_density
    );
}

namespace {

/// How much of the finer grains is smaller than the constrictions, at the densest and at the loosest.
std::string smaller_share(double densest, double loosest) {
    const long from = std::lround(100 * densest), to = std::lround(100 * loosest);
    if (to == 0) {
        return "almost none of the finer grains are smaller than that";
    }
    return from == to ? fmt::format("{} % of the finer grains are smaller than that", to)
                      : fmt::format("{} to {} % of the finer grains are smaller than that", from, to);
}

} // namespace

std::string constrictions_text(const Assessment& found, const char* join) {
    const stability::FinesAgainstConstrictions& constrictions = found.constrictions;
    return fmt::format(
        "constrictions between the grains above {} mm: Dc35 = {} mm at the densest, {} mm at the loosest;{}{}",
        mm(constrictions.split), mm(constrictions.densest_d35), mm(constrictions.loosest_d35), join,
        smaller_share(constrictions.densest_passes, constrictions.loosest_passes)
    );
}

std::string text_of(const AssessedSoil& soil, const stability::AssessSpec& spec, std::size_t columns) {
    const Assessment& found = soil.assessment;
    std::string text = opening(soil);
    if (!soil.measured.diameter.empty()) {
        text += fmt::format(
            "  ASTM D2487: {}; ISO 14688: {}\n", stability::classes_text(stability::astm_classes(soil.measured)),
            stability::classes_text(stability::iso_classes(soil.measured))
        );
    }
    text += "\n" + heading("criterion");
    for (const Criterion& criterion : found.criteria) {
        text += criterion.verified ? line_of(criterion, columns) : "";
    }
    text += "\n  unverified: limits not verified in the source, so not counted\n";
    for (const Criterion& criterion : found.criteria) {
        text += criterion.verified ? "" : line_of(criterion, columns);
    }
    const auto is_part = [](const Criterion& criterion) { return criterion.measured.has_value(); };
    if (std::ranges::any_of(found.criteria, is_part)) {
        text += "\n  * of the part that was measured; what is missing may change it\n";
    }
    if (spec.seepage) {
        text += gradient_lines(*spec.seepage, found, columns);
        text += soil.measured.diameter.empty()
                    ? ""
                    : "\n" + text_of(atlas_words(consult_atlas(soil.measured, spec), *spec.seepage));
    }
    if (found.has_constrictions) {
        text += "\n  " + constrictions_text(found, "\n  ") + "\n";
    }
    text += "\n" + stability::summary(found.criteria);
    return soil.filter ? text + "\n\n" + filter_text(*soil.filter) : text;
}

std::string filter_summary(const AssessedFilter& filter) {
    return fmt::format("the filter {} {}", filter.name, stability::filter_summary(filter.check));
}

std::string filter_text(const AssessedFilter& filter) {
    std::string text = "  " + as_sentence(filter_summary(filter)) + "\n";
    for (const Criterion& criterion : filter.check.criteria) {
        const std::string number =
            criterion.value ? fmt::format("{} {:.3g}", criterion.measure, *criterion.value) : criterion.measure;
        text += fmt::format(
            "  {:54}{:26}{:8}{}{}\n      {}\n", criterion.name, number, stability::limit_text(criterion),
            stability::filter_word(criterion.verdict),
            criterion.verified ? "" : " (unverified: limit not verified in the source, so not counted)",
            criterion.remark
        );
    }
    return text + text_of(filter.simulated);
}

} // namespace suffuse::job
