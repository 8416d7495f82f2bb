#include "suffuse/record/earlier_endings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <optional>

namespace suffuse::record {
namespace {

using Numbers = std::array<double, 2>;

/// The numbers that a sentence has where `form` has #; of another sentence none.
std::optional<Numbers> numbers_in(const std::string& sentence, const char* form) {
    Numbers numbers{};
    const char* at = sentence.c_str();
    for (std::size_t k = 0; *form != '\0'; ++form) {
        const bool is_number = *form == '#' && std::isdigit(static_cast<unsigned char>(*at)) != 0;
        if (!is_number && *at++ != *form) {
            return std::nullopt;
        }
        if (is_number) { // beyond the bound are none of ours, nor whole numbers that fit
            char* end = nullptr;
            numbers.at(k++) = std::min(std::strtod(at, &end), 1e9);
            at = end;
        }
    }
    return *at == '\0' ? std::optional(numbers) : std::nullopt;
}

std::optional<erosion::SkeletonDoubt> doubt_of(const std::string& sentence) {
    if (const auto few = numbers_in(
            sentence, "the coarse skeleton has # grains left: too few for its constrictions to mean anything"
        )) {
        return erosion::SkeletonDoubt{static_cast<std::int64_t>(few->front()), 0};
    }
    const auto narrow = numbers_in(
        sentence,
        "the cell is only # coarse diameters wide (at least # wanted): the coarse skeleton has lost its meaning"
    );
    return narrow ? std::optional(erosion::SkeletonDoubt{0, narrow->front()}) : std::nullopt;
}

std::optional<erosion::TargetReached> target_of(const std::string& sentence) {
    const std::size_t end = std::min(sentence.find("; "), sentence.size());
    const bool has_doubt = end < sentence.size();
    const auto doubt = has_doubt ? doubt_of(sentence.substr(end + 2)) : std::nullopt;
    const auto reached = [&](erosion::ErodedTarget::Of of, const char* form) {
        const auto found = numbers_in(sentence.substr(0, end), form);
        return found && doubt.has_value() == has_doubt
                   ? std::optional(erosion::TargetReached{found->front() / 100, found->back() / 100, of, doubt})
                   : std::nullopt;
    };
    const auto of_fines = reached(erosion::ErodedTarget::Of::Fines, "# % of the fines has left, # % was asked for");
    return of_fines ? of_fines
                    : reached(erosion::ErodedTarget::Of::Solids, "# % of the solids has left, # % was asked for");
}

} // namespace

erosion::Ending ending_of_sentence(const std::string& sentence) {
    if (sentence.empty()) {
        return {};
    }
    if (sentence == "nothing leaves any more") {
        return {erosion::NothingLeaves{}};
    }
    if (sentence == "what leaves cannot be told from the twin's noise") {
        return {erosion::NoiseDecides{}};
    }
    if (const auto doubt = doubt_of(sentence)) {
        return {*doubt};
    }
    if (const auto target = target_of(sentence)) {
        return {*target};
    }
    if (const auto failed = numbers_in(
            sentence, "the skeleton fails: it does not carry its stresses any more and strained by more than # %"
        )) {
        return {erosion::SkeletonFailed{failed->front() / 100}};
    }
    if (const auto restless = numbers_in(
            sentence, "the skeleton fails: after # steps under its stresses it is not at rest and carries # % of "
                      "them, or [balance] asks too much"
        )) {
        return {erosion::SkeletonRestless{static_cast<std::int64_t>(restless->front()), restless->back() / 100}};
    }
    if (const auto none = numbers_in(sentence, "no grain is left to be removed after pass # of #")) {
        return {erosion::NoneToRemove{static_cast<int>(none->front()), static_cast<int>(none->back())}};
    }
    return {erosion::OtherWording{sentence}};
}

} // namespace suffuse::record
