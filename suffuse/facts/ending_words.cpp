#include "suffuse/facts/ending_words.hpp"

#include "suffuse/erosion/passage.hpp"

#include <fmt/format.h>

namespace suffuse::facts {
namespace {

using erosion::Ending;
using erosion::NoiseDecides;
using erosion::NoneToRemove;
using erosion::NothingLeaves;
using erosion::OtherWording;
using erosion::SkeletonDoubt;
using erosion::SkeletonFailed;
using erosion::SkeletonRestless;
using erosion::TargetReached;

struct Words {
    std::string operator()(std::monostate) const { return ""; }

    std::string operator()(const NothingLeaves&) const { return "nothing leaves any more"; }

    std::string operator()(const NoiseDecides&) const {
        return "the fines that leave cannot be distinguished from the twin's noise";
    }

    std::string operator()(const SkeletonDoubt& doubt) const {
        return doubt.width > 0
                   ? fmt::format(
                         "the cell is only {:.1f} coarse diameters wide (at least {} required): the coarse skeleton is "
                         "no longer meaningful",
                         doubt.width, erosion::narrowest_skeleton
                     )
                   : fmt::format(
                         "the coarse skeleton has {} grains left: too few for meaningful constrictions", doubt.coarse
                     );
    }

    std::string operator()(const SkeletonFailed& failed) const {
        return fmt::format(
            "the skeleton fails: it no longer carries its stresses and strained by more than {:.3g} %",
            100 * failed.most_strain
        );
    }

    std::string operator()(const SkeletonRestless& restless) const {
        return fmt::format(
            "the skeleton fails: after {} steps under its stresses it is not at rest and carries {:.3g} % of them, or "
            "[balance] is too strict",
            restless.steps, 100 * restless.carried
        );
    }

    std::string operator()(const TargetReached& reached) const {
        return fmt::format(
            "{:.3g} % of the {} has left, {:.3g} % was specified{}", 100 * reached.share, name_of(reached.of),
            100 * reached.specified, reached.doubt ? "; " + (*this)(*reached.doubt) : ""
        );
    }

    std::string operator()(const NoneToRemove& none) const {
        return fmt::format("no grain is left to be removed after pass {} of {}", none.pass, none.passes);
    }

    std::string operator()(const OtherWording& other) const { return other.words; }
};

} // namespace

std::string words_of(const Ending& ending) {
    return std::visit(Words{}, ending.why);
}

} // namespace suffuse::facts
