#include "suffuse/atlas/interpolation_error.hpp"

#include "suffuse/atlas/node.hpp"

#include <cmath>

namespace suffuse::atlas {
namespace {

class Squares {
public:
    void add(const std::optional<Value>& predicted, const std::optional<Value>& found) {
        if (predicted && found) {
            const double error = predicted->mean / found->mean - 1;
            sum_ += error * error;
            ++count_;
        }
    }

    [[nodiscard]] std::optional<double> root_of_mean() const {
        return count_ == 0 ? std::nullopt : std::optional(std::sqrt(sum_ / count_));
    }

private:
    double sum_ = 0;
    int count_ = 0;
};

} // namespace

InterpolationError error_of_interpolation(const std::vector<Row>& rows, Flow flow) {
    Squares of_1, of_10;
    for (const Density density : {Density::Loose, Density::Medium, Density::Dense}) {
        const std::vector<Node> nodes = gather_nodes(rows, density, flow);
        for (const auto& [left_out, neighbors] : grid_of(nodes).left_out()) {
            const Node predicted = blend(weighted(nodes, neighbors));
            of_1.add(predicted.moves_1, nodes[left_out].moves_1);
            of_10.add(predicted.moves_10, nodes[left_out].moves_10);
        }
    }
    return {of_1.root_of_mean(), of_10.root_of_mean()};
}

} // namespace suffuse::atlas
