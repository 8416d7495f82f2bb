#include "suffuse/atlas/interpolation_error.hpp"

#include "suffuse/atlas/node.hpp"

#include <cmath>
#include <iterator>
#include <map>

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

/// Nodes by their place along a line of the grid.
using Line = std::map<double, const Node*>;

void leave_out_each(const Line& line, Squares& of_1, Squares& of_10) {
    if (line.size() < 3) {
        return;
    }
    for (auto middle = std::next(line.begin()); std::next(middle) != line.end(); ++middle) {
        const auto before = std::prev(middle), after = std::next(middle);
        const double share = (middle->first - before->first) / (after->first - before->first);
        const Node predicted = blend({{before->second, 1 - share}, {after->second, share}});
        of_1.add(predicted.moves_1, middle->second->moves_1);
        of_10.add(predicted.moves_10, middle->second->moves_10);
    }
}

} // namespace

InterpolationError error_of_interpolation(const std::vector<Row>& rows, Flow flow) {
    Squares of_1, of_10;
    for (const Density density : {Density::Loose, Density::Medium, Density::Dense}) {
        const std::vector<Node> nodes = gather_nodes(rows, density, flow);
        std::map<double, Line> of_one_ratio, of_one_content;
        for (const Node& node : nodes) {
            of_one_ratio[node.size_ratio][node.fines_content] = &node;
            of_one_content[node.fines_content][std::log(node.size_ratio)] = &node;
        }
        for (const auto* const lines : {&of_one_ratio, &of_one_content}) {
            for (const auto& [at, line] : *lines) {
                leave_out_each(line, of_1, of_10);
            }
        }
    }
    return {of_1.root_of_mean(), of_10.root_of_mean()};
}

} // namespace suffuse::atlas
