#pragma once
// Which throats of the coarse skeleton a fine grain passes: the facets of the coarse grains' triangulation that its
// center crosses, as `flow-path` counts them. A sphere whose center goes from one pore into the next is no wider than
// the room in their facet (pores/facet_room.hpp): the narrowest throat passed is an upper bound of its size.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/pores/locate.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// Pores between the grains of a world that are coarse.
struct CoarsePores {
    explicit CoarsePores(const dem::World& world);

    std::vector<Vec3> position; ///< coarse [m]
    pores::PoreNetwork network;
    pores::PoreLocator locator;
};

class CoarseThroats {
public:
    /// @param start where the travelers are [m]
    CoarseThroats(std::shared_ptr<const CoarsePores> pores, std::span<const Vec3> start);

    CoarseThroats(const dem::World& world, std::span<const Vec3> start)
        : CoarseThroats(std::make_shared<const CoarsePores>(world), start) {}

    /// Moves traveler p straight to `place` [m], and enters what it passes on the way.
    void follow(std::size_t p, const Vec3& place, PassedThroats& passed);

private:
    /// A traveler: where it was last, in which pore, and in which period of it.
    struct Traveler {
        Vec3 at;
        pores::PoreLocator::Place in;
    };

    /// Corner opposite to the facet by which it leaves its pore; 4: it does not.
    [[nodiscard]] std::size_t way_out(const Traveler& traveler, const Vec3& to, std::size_t came_by) const;

    std::shared_ptr<const CoarsePores> pores_;
    std::vector<Traveler> traveler_;
};

} // namespace suffuse::erosion
