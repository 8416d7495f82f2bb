// Passes of an erosion in sentences.
#include "suffuse/answer/pass_words.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/facts/ending_words.hpp"
#include "suffuse/study/erosion_span.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace suffuse::answer {
namespace {

/// "12.3 %", or that there is nothing to report.
std::string percent_or_none(double percent) {
    return is_noise(percent) ? "less than 0.01 %" : percent_beyond_noise(percent) + " %";
}

/// "the skeleton lost 3.00 % of its mean stress"; a negative loss is a gain.
std::string loss_text(double loss) {
    const bool is_gain = loss < 0 && !is_noise(100 * loss);
    return fmt::format(
        "the skeleton {} {} of its mean stress", is_gain ? "gained" : "lost", percent_or_none(100 * std::abs(loss))
    );
}

/// How many of the fines that the water would carry were carried out.
/// @param name "Pass 1"
std::string describe_removed(const std::string& name, const erosion::PassResult& pass, bool is_forced) {
    if (pass.detachable == 0) {
        return name + ": no fine grain is detachable";
    }
    if (is_forced) {
        return fmt::format(
            "{}: {} {} taken out by force, {} of the initial mass", name, fines_text(pass.removed),
            pass.removed == 1 ? "was" : "were", percent_or_none(pass.eroded_mass_percent_of_initial)
        );
    }
    if (pass.removed == 0) {
        return fmt::format("{}: none of {} detachable fines was carried out", name, grouped(pass.detachable));
    }
    return fmt::format(
        "{}: {} of {} detachable fines {} carried out, {} of the initial mass", name, grouped(pass.removed),
        grouped(pass.detachable), pass.removed == 1 ? "was" : "were",
        percent_or_none(pass.eroded_mass_percent_of_initial)
    );
}

std::string describe_pass(const erosion::ErosionResult& erosion, const erosion::PassResult& pass) {
    const study::ErosionSpan span = *study::span_of({&erosion});
    const bool is_forced = study::is_forced(erosion, pass), is_one = span.least_gradient == span.most_gradient;
    const std::string name = is_one || is_forced ? fmt::format("Pass {}", pass.pass)
                                                 : fmt::format("Pass {} at i = {:g}", pass.pass, pass.probe.gradient);
    const std::string removed = describe_removed(name, pass, is_forced);
    if (pass.removed == 0) {
        return removed + ".";
    }
    return fmt::format(
        "{}; porosity {:.4f} to {:.4f}, permeability {} to {} m²; at constant volume {}, and resettling strained it "
        "by {}.",
        removed, pass.porosity_before, pass.porosity_after, short_number(pass.permeability_before),
        short_number(pass.permeability_after), loss_text(erosion::stress_loss(pass).value_or(0)),
        percent_or_none(100 * pass.volumetric_strain)
    );
}

/// All passes but the first, where there are too many for a sentence each.
std::string describe_later_passes(const erosion::ErosionResult& erosion) {
    const erosion::PassResult &second = erosion.passes[1], &last = erosion.passes.back();
    std::int64_t removed = 0;
    double percent = 0, strain = 0, largest_loss = 0;
    bool has_forced = false;
    for (const erosion::PassResult& pass : std::span(erosion.passes).subspan(1)) {
        removed += pass.removed;
        has_forced = has_forced || study::is_forced(erosion, pass);
        percent += pass.eroded_mass_percent_of_initial;
        strain += pass.volumetric_strain;
        largest_loss = std::max(largest_loss, erosion::stress_loss(pass).value_or(0));
    }
    return fmt::format(
        "Passes 2 to {}: {} {} {} out, {:.2f} % of the initial mass, {} of them in pass 2 and {} in pass {}; porosity "
        "{:.4f}, permeability {} m² after the last; {} at most, and resettling strained it by {} in all.",
        last.pass, fines_text(removed), removed == 1 ? "was" : "were", has_forced ? "taken" : "carried", percent,
        grouped(second.removed), grouped(last.removed), last.pass, last.porosity_after,
        short_number(last.permeability_after), loss_text(largest_loss), percent_or_none(100 * strain)
    );
}

/// How often fines were held that travelled with the water; empty where none was on its way.
std::string describe_transport(const erosion::ErosionResult& erosion) {
    std::vector<std::string> rates;
    for (const erosion::PassResult* pass : study::few_passes(erosion, 2)) {
        const std::optional<double> held = erosion::filter_coefficient(pass->transport);
        if (held && *held > 0) {
            rates.push_back(fmt::format("{} times in pass {}", short_number(*held / 1e3, 2), pass->pass));
        }
    }
    return rates.empty() ? "" : fmt::format("A mm of flow held a detached grain {}, the mean.", fmt::join(rates, ", "));
}

} // namespace

std::string fines_text(std::int64_t count) {
    return count == 1 ? "1 fine grain" : grouped(count) + " fines";
}

std::string answer_to_erosion(const erosion::ErosionResult& erosion) {
    constexpr std::size_t most_reported = 4; // passes, a sentence each
    if (erosion.passes.empty()) {
        return "";
    }
    std::vector<std::string> sentences;
    for (const erosion::PassResult& pass : erosion.passes) {
        sentences.push_back(describe_pass(erosion, pass));
        if (erosion.passes.size() > most_reported) {
            sentences.push_back(describe_later_passes(erosion));
            break;
        }
    }
    if (std::string transport = describe_transport(erosion); !transport.empty()) {
        sentences.push_back(std::move(transport));
    }
    const erosion::Ending& ending = erosion.passes.back().verdict;
    if (ending && ending != erosion::Ending{erosion::NothingLeaves{}}) { // already reported
        sentences.push_back(fmt::format("It ended there: {}.", facts::words_of(ending)));
    }
    return fmt::format("{}", fmt::join(sentences, " "));
}

std::string describe_idle(const erosion::ErosionResult& erosion) {
    constexpr double nearly_all = 0.98;
    constexpr int least_carrying = 2; // contacts
    std::int64_t removed = 0, idle = 0;
    for (const erosion::PassResult& pass : erosion.passes) {
        for (const auto& [contacts, grains] : pass.coordination_histogram) {
            removed += grains;
            idle += contacts < least_carrying ? grains : 0;
        }
    }
    if (removed == 0 || static_cast<double>(idle) < nearly_all * static_cast<double>(removed)) {
        return {};
    }
    const study::ErosionSpan span = *study::span_of({&erosion});
    return fmt::format(
        "{}: without gravity any water moves what carries no load, so that {} not critical, and a soil "
        "that criteria of stability call stable loses such grains too.",
        idle == removed ? "None of them carried load"
                        : fmt::format("Only {} of the {} carried load", grouped(removed - idle), grouped(removed)),
        span.least_gradient == span.most_gradient ? "this gradient is" : "these gradients are"
    );
}

} // namespace suffuse::answer
