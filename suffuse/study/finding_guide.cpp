#include "suffuse/study/finding_guide.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace suffuse::study {
namespace {

constexpr std::string_view second_erosion =
    "In a well balanced sample the water finds the grains that carry nothing, and takes all of them in pass 1. Fines "
    "that carry load are held by forces millions of times the seepage force. A speed threshold over a state that is "
    "not balanced well enough takes such fines too, mostly in pass 2: that order is the paper's, and it is noise. The "
    "twin of the probe, the same sample without water, distinguishes the two. A sample that was unloaded between the "
    "passes loses more fines, because the unloading released them.";

constexpr std::string_view kept_skeleton =
    "It depends on the preparation of the sample. The paper keeps the intergranular void ratio e_g constant without "
    "describing how. Compacted with adhesion alone, e_g rises with every percent of fines, and the fines stay idle for "
    "long. If it is kept, by a search for one e_g or by putting the fines into a skeleton made first, the fines fill "
    "its voids at some fines content. That content follows from e_g and the size ratio; the paper gives neither.";

constexpr std::array<std::pair<std::string_view, std::string_view>, 16> guide{{
    {"E1", "Without water there is no seepage force, and the rule takes no grain without one. At any gradient a grain "
           "that carries nothing accelerates; the rule decides how soon it counts as detached."},
    {"E2", "Grains that carry nothing move freely; the others move only as far as their contacts deform. How far apart "
           "the two groups are depends on how well the initial state was balanced."},
    {"E3", "A grain with two contacts or fewer can carry no load in equilibrium, but for a chain of two. Grains with "
           "more leave only where the rule takes noise, or where the seepage force is very large."},
    {"E4", second_erosion},
    {"E5", second_erosion},
    {"E6", "Each grain that leaves adds its volume to the pores. The porosity falls on resettling if loaded grains "
           "have left: like E4, it depends on pass 2."},
    {"E7", second_erosion},
    {"M1", kept_skeleton},
    {"M2", "Compacted at the lowest friction, coarse grains are densest when the fines just fill their voids. The "
           "fines content depends on the size ratio."},
    {"M3", "A constant e_g results from the preparation, not from the soil. Compacted with adhesion alone, e_g rises "
           "from the first fines on."},
    {"M4", kept_skeleton},
    {"M5", "Coarse grains lose contact when fines push them apart. The number of fine grains also outgrows that of "
           "coarse ones, and shares are of the number of contacts."},
    {"M6", kept_skeleton},
    {"M7", kept_skeleton},
    {"M8", kept_skeleton},
    {"M9", "The paper expects it and did not simulate it. The loss of fines that carry nothing can go unnoticed; the "
           "effect of losing loaded fines depends on how the skeleton was kept."},
}};

} // namespace

std::string_view background_of(std::string_view id) {
    const auto found = std::ranges::find(guide, id, &std::pair<std::string_view, std::string_view>::first);
    return found == guide.end() ? std::string_view{} : found->second;
}

} // namespace suffuse::study
