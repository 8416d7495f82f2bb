#pragma once
// What the atlas says of a soil: linear in fines content and in the logarithm of the size ratio, within the cells whose
// corners all exist. It never extrapolates: outside of them it names the nearest rows.

#include "suffuse/atlas/node.hpp"

namespace suffuse::atlas {

/// A size ratio so near to one of the atlas is taken for it.
inline constexpr double same_ratio = 0.03;

/// More sifting than this is reported [-].
inline constexpr double much_sifting = 0.01;

/// One density and flow.
struct Found {
    Density density = Density::Loose;
    Flow flow = Flow::Up;
    std::optional<Node> node;     ///< none outside the atlas
    bool is_interpolated = false; ///< between nodes
    std::vector<Row> rows;        ///< of the nodes that were used; outside, of the nearest one

    /// Of the node with the fewest samples.
    [[nodiscard]] int seeds() const;
    /// Share of the fines' mass, the largest of the rows [-].
    [[nodiscard]] double sifting() const;
};

Found look_up(const std::vector<Row>& rows, double size_ratio, double fines_content, Density density, Flow flow);

/// Those of the densities that a flow has any rows of.
std::vector<Density> densities_of(const std::vector<Row>& rows, Flow flow);

} // namespace suffuse::atlas
