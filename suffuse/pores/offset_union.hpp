#pragma once
// Union-find on a periodic graph: sets of nodes that are joined, each node knowing by how many periods it is displaced
// from the root of its set.

#include "suffuse/cell/cell.hpp"

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace suffuse::pores {

class OffsetUnion {
public:
    /// A node and periods: "node, moved by offset".
    struct Place {
        std::uint32_t node = 0;
        cell::Image offset;
    };

    explicit OffsetUnion(std::size_t nodes) : parent_(nodes), offset_(nodes), size_(nodes, 1) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    /// The root of the node's set: the node is displaced from it by `offset`.
    Place find(std::uint32_t node) {
        std::uint32_t root = node;
        cell::Image offset;
        while (parent_[root] != root) {
            offset = offset + offset_[root];
            root = parent_[root];
        }
        // Path compression: all nodes on the way point at the root from now on.
        for (cell::Image rest = offset; parent_[node] != root && node != root;) {
            const cell::Image step = std::exchange(offset_[node], rest);
            node = std::exchange(parent_[node], root);
            rest = rest - step;
        }
        return {root, offset};
    }

    struct Joined {
        std::uint32_t kept = 0;     ///< root of the joined set
        std::uint32_t absorbed = 0; ///< that of the set added to it; the same where the edge closes a loop
        cell::Image loop;           ///< periods that the closed loop leads through
    };

    /// Joins node `p` with node `q` moved by `image`.
    Joined join(std::uint32_t p, std::uint32_t q, const cell::Image& image) {
        const Place a = find(p), b = find(q);
        // p = a.node + a.offset meets q + image = b.node + b.offset + image, so b.node is displaced from a.node by:
        const cell::Image between = a.offset - b.offset - image;
        if (a.node == b.node) {
            return {a.node, a.node, between};
        }
        const bool keep_a = size_[a.node] >= size_[b.node];
        const std::uint32_t kept = keep_a ? a.node : b.node, absorbed = keep_a ? b.node : a.node;
        parent_[absorbed] = kept;
        offset_[absorbed] = keep_a ? between : -between;
        size_[kept] += size_[absorbed];
        return {kept, absorbed, {}};
    }

private:
    std::vector<std::uint32_t> parent_;
    std::vector<cell::Image> offset_; ///< the node is its parent moved by these periods
    std::vector<std::uint32_t> size_;
};

} // namespace suffuse::pores
