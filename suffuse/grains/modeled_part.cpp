#include "suffuse/grains/modeled_part.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sample_size.hpp"
#include "suffuse/grains/sampling.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::grains {
namespace {

constexpr int steps = 100;    // of the mass of a fraction
constexpr int most_left = 90; // of these may be left out

/// To three digits, up or down.
double round_size(double size, bool up) {
    const double unit = std::pow(10.0, std::floor(std::log10(size)) - 2);
    constexpr double rounding = 1e-9;
    return unit * (up ? std::ceil(size / unit - rounding) : std::floor(size / unit + rounding));
}

/// The number of grains that the counts of fines and coarse grains and the width of the cell require.
double counted(const Grading& grading, double finer_than, const Representative& spec) {
    const double finest = grading.diameter.front(), coarsest = grading.diameter.back();
    const double content = passing(grading, finer_than), all = grains_per_volume(grading);
    const double fine = content * grains_per_volume(part_between(grading, finest, finer_than));
    const Grading skeleton = part_between(grading, finer_than, coarsest);
    const double coarse = (1 - content) * grains_per_volume(skeleton);
    constexpr std::size_t drawn = 101; // so that one of them is the median
    const double median = sample_diameters(skeleton, drawn)[drawn / 2];
    const double wide = std::max(spec.cell_width * size_at(grading, 1), spec.skeleton_width * median);
    const double width = all * wide * wide * wide * (1 - sized_porosity);
    return std::max({spec.fine * all / fine, spec.coarse * all / coarse, width});
}

/// The curve without these shares of its fine and of its coarse mass.
struct Cut {
    Cut(const Grading& grading, const FractionEnds& ends, int fine_left, int coarse_left) {
        const double fines = passing(grading, ends.finer_than), below = passing(grading, ends.coarser_than);
        const auto share = [](int left) { return static_cast<double>(left) / steps; };
        finest =
            fine_left == 0 ? grading.diameter.front() : round_size(size_at(grading, fines * share(fine_left)), true);
        coarsest = coarse_left == 0 ? grading.diameter.back()
                                    : round_size(size_at(grading, 1 - (1 - below) * share(coarse_left)), false);
        fines_kept = 1 - passing(grading, finest) / fines;
        coarse_kept = (passing(grading, coarsest) - below) / (1 - below);
    }

    double finest, coarsest;
    double fines_kept, coarse_kept; ///< of their mass
};

/// A size between `good` and `bad` as near to `bad` as the curve can be followed, by halves on a logarithmic scale.
template <class IsGood>
double last_good(double good, double bad, IsGood is_good) {
    constexpr double near = 1.005;
    while (std::max(good / bad, bad / good) > near) {
        const double middle = std::sqrt(good * bad);
        (is_good(middle) ? good : bad) = middle;
    }
    return good;
}

/// The last good size on the way from `start` to `end`, rounded inwards; nothing where not even the start is good.
template <class IsGood>
std::optional<double> last_followed(double start, double end, bool rounds_up, IsGood is_good) {
    return is_good(start) ? std::optional(round_size(last_good(start, end, is_good), rounds_up)) : std::nullopt;
}

} // namespace

double representative_count(const Grading& grading, double finer_than, const Representative& spec) {
    const double content = passing(grading, finer_than);
    expects(content > 0 && content < 1, "fines and coarse grains both have mass");
    return std::max(counted(grading, finer_than, spec), grains_needed(grading, spec.tolerance));
}

std::optional<ModeledPart>
find_modeled_part(const Grading& grading, const FractionEnds& ends, double most, const Representative& spec) {
    if (passing(grading, ends.coarser_than) >= 1) {
        return std::nullopt; // the curve ends within the gap
    }
    const auto is_enough = [&](int fine_left, int coarse_left) {
        const Cut cut(grading, ends, fine_left, coarse_left);
        if (!(cut.fines_kept > 0 && cut.coarse_kept > 0)) {
            return false;
        }
        const Grading part = part_between(grading, cut.finest, cut.coarsest);
        return counted(part, ends.finer_than, spec) <= most && can_follow(part, most, spec.tolerance);
    };
    int both = 0; // share left out of either fraction
    while (both <= most_left && !is_enough(both, both)) {
        ++both;
    }
    if (both > most_left) {
        return std::nullopt;
    }
    int fine_left = both, coarse_left = both; // and then as little as will do, of the one that gains more
    while (fine_left > 0 && is_enough(fine_left - 1, both)) {
        --fine_left;
    }
    while (coarse_left > 0 && is_enough(both, coarse_left - 1)) {
        --coarse_left;
    }
    (fine_left <= coarse_left ? coarse_left : fine_left) = both;
    const Cut cut(grading, ends, fine_left, coarse_left);
    return ModeledPart{cut.finest, cut.coarsest, cut.fines_kept, cut.coarse_kept};
}

std::optional<double> followed_above(const Grading& grading, double particles, double tolerance) {
    const double finest = size_at(grading, 0), coarsest = size_at(grading, 1);
    return last_followed(size_at(grading, 0.9), finest, true, [&](double size) {
        return can_follow(part_between(grading, size, coarsest), particles, tolerance);
    });
}

std::optional<double> followed_below(const Grading& grading, double particles, double tolerance) {
    const double finest = size_at(grading, 0), coarsest = size_at(grading, 1);
    return last_followed(size_at(grading, 0.1), coarsest, false, [&](double size) {
        return can_follow(part_between(grading, finest, size), particles, tolerance);
    });
}

} // namespace suffuse::grains
