#include "suffuse/record/ending_words.hpp"

#include "suffuse/erosion/passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <vector>

namespace suffuse::record {
namespace {

using erosion::Ending;
using erosion::ErodedTarget;
using erosion::NoiseDecides;
using erosion::NoneToRemove;
using erosion::NothingLeaves;
using erosion::SkeletonDoubt;
using erosion::SkeletonFailed;
using erosion::SkeletonRestless;
using erosion::TargetReached;
using erosion::ToldOtherwise;

struct Words {
    std::string operator()(std::monostate) const { return ""; }

    std::string operator()(const NothingLeaves&) const { return "nothing leaves any more"; }

    std::string operator()(const NoiseDecides&) const { return "what leaves cannot be told from the twin's noise"; }

    std::string operator()(const SkeletonDoubt& doubt) const {
        return doubt.width > 0
                   ? fmt::format(
                         "the cell is only {:.1f} coarse diameters wide (at least {} wanted): the coarse skeleton has "
                         "lost its meaning",
                         doubt.width, erosion::narrowest_skeleton
                     )
                   : fmt::format(
                         "the coarse skeleton has {} grains left: too few for its constrictions to mean anything",
                         doubt.coarse
                     );
    }

    std::string operator()(const SkeletonFailed& failed) const {
        return fmt::format(
            "the skeleton fails: it does not carry its stresses any more and strained by more than {:.3g} %",
            100 * failed.most_strain
        );
    }

    std::string operator()(const SkeletonRestless& restless) const {
        return fmt::format(
            "the skeleton fails: after {} steps under its stresses it is not at rest and carries {:.3g} % of them, or "
            "[balance] asks too much",
            restless.steps, 100 * restless.carried
        );
    }

    std::string operator()(const TargetReached& reached) const {
        return fmt::format(
            "{:.3g} % of the {} has left, {:.3g} % was asked for{}", 100 * reached.share, name_of(reached.of),
            100 * reached.asked, reached.doubt ? "; " + (*this)(*reached.doubt) : ""
        );
    }

    std::string operator()(const NoneToRemove& none) const {
        return fmt::format("no grain is left to be removed after pass {} of {}", none.pass, none.passes);
    }

    std::string operator()(const ToldOtherwise& told) const { return told.words; }
};

std::vector<double> numbers_in(const std::string& words) {
    std::vector<double> numbers;
    for (const char* at = words.c_str(); *at != '\0';) {
        char* end = nullptr;
        const bool begins = std::isdigit(static_cast<unsigned char>(*at)) != 0;
        const double number = begins ? std::strtod(at, &end) : 0;
        if (begins) {
            numbers.push_back(std::min(number, 1e9)); // beyond are none of ours, nor whole numbers that fit
        }
        at = begins ? end : at + 1;
    }
    return numbers;
}

/// All endings that may have these numbers in words; those that lack some get zeros.
std::vector<Ending> endings_with(std::vector<double> numbers) {
    numbers.resize(4);
    const auto whole = [&](std::size_t k) { return static_cast<std::int64_t>(numbers[k]); };
    std::vector<Ending> endings{
        {},
        {NothingLeaves{}},
        {NoiseDecides{}},
        {SkeletonDoubt{whole(0), 0}},
        {SkeletonDoubt{0, numbers[0]}},
        {SkeletonFailed{numbers[0] / 100}},
        {SkeletonRestless{whole(0), numbers[1] / 100}},
        {NoneToRemove{static_cast<int>(whole(0)), static_cast<int>(whole(1))}}};
    for (const ErodedTarget::Of of : {ErodedTarget::Of::Fines, ErodedTarget::Of::Solids}) {
        const TargetReached reached{numbers[0] / 100, numbers[1] / 100, of, {}};
        endings.push_back({reached});
        for (const SkeletonDoubt& doubt : {SkeletonDoubt{whole(2), 0}, SkeletonDoubt{0, numbers[2]}}) {
            endings.push_back({TargetReached{reached.share, reached.asked, of, doubt}});
        }
    }
    return endings;
}

} // namespace

std::string words_of(const Ending& ending) {
    return std::visit(Words{}, ending.why);
}

// The words have rounded numbers, so the words, not the numbers, say whether it is this ending.
Ending ending_told(const std::string& words) {
    for (Ending& ending : endings_with(numbers_in(words))) {
        if (words_of(ending) == words) {
            return std::move(ending);
        }
    }
    return {ToldOtherwise{words}};
}

} // namespace suffuse::record
