#pragma once
// The springs of the touching contacts as one linear network, all of them sticking: what small motions of the grains
// meet.

#include "suffuse/contact/sum_plan.hpp"
#include "suffuse/dem/world.hpp"

#include <vector>

namespace suffuse::dem {

/// Small displacements and rotations of the grains, or the forces and torques that go with them. Behind the rows of the
/// grains a network keeps what one domain exerts on the grains of others.
struct Motions {
    std::vector<Vec3> shift; ///< [m] or [N]
    std::vector<Vec3> turn;  ///< [rad] or [N m]
};

class SpringNetwork {
public:
    /// Of the contacts that the last step found; before the first step of those of the geometry.
    /// @param shear_ratio ks/kn; 0: only normal springs act; @param least_overlap over the smaller radius, that
    /// contacts are taken to have at least: some laws grow stiffer as a sample is loaded
    SpringNetwork(const World& world, double shear_ratio, double least_overlap = 0);

    /// Rows of the motions.
    [[nodiscard]] std::size_t rows() const { return plan_.rows(); }

    /// That touch.
    [[nodiscard]] std::size_t contacts() const { return springs_.size(); }

    /// `out` = K `in`: forces and torques that hold the grains so against the springs, on all threads, summed in one
    /// order.
    void apply(const Motions& in, Motions& out) const;

private:
    struct Spring {
        std::uint32_t first, second, second_sum; ///< grains; row that the second one's share goes to
        double stiffness;                        ///< normal [N/m]
        Vec3 normal;
    };

    template <bool Shears>
    void add_springs(std::size_t domain, const Motions& in, Motions& out) const;

    const World& world_;
    double shear_ratio_;
    contact::SumPlan plan_;
    std::vector<Spring> springs_; ///< rows of the plan's table
};

} // namespace suffuse::dem
