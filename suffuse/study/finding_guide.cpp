#include "suffuse/study/finding_guide.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace suffuse::study {
namespace {

constexpr std::string_view second_erosion =
    "In a well balanced sample the water finds the grains that carry nothing, and takes all of them in pass 1. Fines "
    "that carry load are held by forces millions of times the water's pull. A speed threshold over a state that is not "
    "balanced well enough takes such fines too, mostly in pass 2: that order is the paper's, and it is noise. What "
    "tells is the twin of the probe, the same sample without water. A sample that was unloaded between the passes "
    "loses more fines, and its own unloading set them free.";

constexpr std::string_view kept_skeleton =
    "How the sample was prepared decides. The paper keeps the intergranular void ratio e_g, and does not say how. "
    "Compacted with adhesion alone, e_g rises with every percent of fines, and the fines stay idle for long. Kept, by "
    "a "
    "search for one e_g or by putting the fines into a skeleton made first, the fines fill its voids at some fines "
    "content. That one follows from e_g and the size ratio, and the paper gives neither number.";

constexpr std::array<std::pair<std::string_view, std::string_view>, 16> guide{{
    {"E1", "Without water no force pulls, and the rule takes no grain on which none does. At any gradient a grain that "
           "carries nothing accelerates: how soon it is called detached is a matter of the rule."},
    {"E2", "Grains that carry nothing fly freely, the others move as far as their contacts give way. How far the two "
           "groups lie apart depends on how well the state before was balanced."},
    {"E3", "A grain with two contacts or fewer can carry no load in equilibrium, but for a chain of two. Grains with "
           "more leave only where the rule takes noise, or where the water pulls very hard."},
    {"E4", second_erosion},
    {"E5", second_erosion},
    {"E6", "Each grain that leaves adds its volume to the pores. The fall on resettling follows where grains that "
           "carried load have left: it depends on pass 2 as E4 does."},
    {"E7", second_erosion},
    {"M1", kept_skeleton},
    {"M2", "Compacted at the lowest friction, coarse grains are densest when the fines just fill their voids. The size "
           "ratio of the two decides where."},
    {"M3", "A constant e_g is a way of preparing samples, not something that they do by themselves. Compacted with "
           "adhesion alone, e_g rises from the first fines on."},
    {"M4", kept_skeleton},
    {"M5",
     "Coarse grains lose touch when fines push them apart. The number of fine grains also outgrows that of coarse "
     "ones, and shares are of the number of contacts."},
    {"M6", kept_skeleton},
    {"M7", kept_skeleton},
    {"M8", kept_skeleton},
    {"M9",
     "The paper expects it and did not simulate it. Fines that carry nothing can go unnoticed; how much those that "
     "carry are missed depends on how the skeleton was kept."},
}};

} // namespace

std::string_view background_of(std::string_view id) {
    const auto found = std::ranges::find(guide, id, &std::pair<std::string_view, std::string_view>::first);
    return found == guide.end() ? std::string_view{} : found->second;
}

} // namespace suffuse::study
