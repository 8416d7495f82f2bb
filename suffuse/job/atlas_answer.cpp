#include "suffuse/job/atlas_answer.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/surrogate.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/stability/unstable_split.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::job {
namespace {

using nlohmann::json;
using stability::FlowWay;

/// Those that say something of it: between level and upward, both.
std::vector<atlas::Flow> flows_of(const std::optional<FlowWay>& way) {
    std::vector<atlas::Flow> flows;
    if (!way || way->rise > 0) {
        flows.push_back(atlas::Flow::Up);
    }
    if (!way || (way->rise >= 0 && *way != stability::upward)) {
        flows.push_back(atlas::Flow::Level);
    }
    return flows;
}

/// "6.5", "3.5 to 10".
std::string range_text(double least, double most) {
    return least == most ? short_number(least) : short_number(least) + " to " + short_number(most);
}

std::string extent_of(const std::vector<atlas::Row>& rows) {
    if (rows.empty()) {
        return "no rows";
    }
    const auto [narrow, wide] = std::ranges::minmax(rows, {}, &atlas::Row::size_ratio);
    const auto [few, many] = std::ranges::minmax(rows, {}, &atlas::Row::fines_content);
    return fmt::format(
        "D50/d50 {} and {} % of fines", range_text(narrow.size_ratio, wide.size_ratio),
        range_text(100 * few.fines_content, 100 * many.fines_content)
    );
}

void split_soil(const grains::Grading& measured, const std::optional<double>& finer_than, AtlasAnswer& answer) {
    const auto split =
        finer_than ? stability::UnstableSplit{*finer_than, "as specified"} : stability::find_unstable_split(measured);
    if (!split) {
        answer.no_parts = stability::no_split_text(measured);
        return;
    }
    const auto ratio = grains::size_ratio(measured, split->finer_than);
    if (!ratio) {
        answer.no_parts = fmt::format(
            "split at {} mm, the curve does not reach the middle of both parts", short_number(1e3 * split->finer_than)
        );
        return;
    }
    const double content = grains::passing(measured, split->finer_than);
    answer.parts =
        TwoParts{split->finer_than, split->reason, *ratio, content, grains::width_between(measured, 0, content)};
}

/// i_c of a sample of the atlas with the soil's density of grains.
double heave_of(const atlas::Node& node, double grain_density) {
    return stability::terzaghi_gradient(node.porosity, grain_density);
}

json value_json(const std::optional<atlas::Value>& value, double factor = 1) {
    return value ? json(factor * value->mean) : json(nullptr);
}

json deviation_json(const std::optional<atlas::Value>& value) {
    return value ? or_null(value->deviation) : json(nullptr);
}

/// What a gradient is at least that is not known.
json floor_json(const std::optional<atlas::Value>& value, const atlas::Floor& floor, double factor = 1) {
    return value || !floor.gradient ? json(nullptr) : json(factor * *floor.gradient);
}

json row_json(const atlas::Row& row) {
    return {
        {"ratio", row.size_ratio},
        {"fines", row.fines_content},
        {"seed", row.seed},
        {"density", atlas::name_of(row.density)},
        {"flow", atlas::name_of(row.flow)},
        {"porosity", row.porosity},
        {"i1", or_null(row.moves_1.gradient)},
        {"i10", or_null(row.moves_10.gradient)}};
}

json found_json(const TwoParts& parts, const atlas::Found& found, const AtlasFlow& flow, double grain_density) {
    json rows = json::array();
    for (const atlas::Row& row : found.rows) {
        rows.push_back(row_json(row));
    }
    const atlas::Node node = found.node.value_or(atlas::Node{});
    const bool is_inside = found.node.has_value();
    const double heave = is_inside ? heave_of(node, grain_density) : 0;
    return {
        {"size_ratio", parts.size_ratio},
        {"fines_content", parts.fines_content},
        {"fines_width", or_null(parts.fines_width)},
        {"wide_fines", parts.has_wide_fines()},
        {"density", atlas::name_of(found.density)},
        {"flow", atlas::name_of(found.flow)},
        {"inside", is_inside},
        {"porosity", is_inside ? json(node.porosity) : json(nullptr)},
        {"alpha", is_inside ? json(node.alpha.mean) : json(nullptr)},
        {"i1_over_ic", value_json(node.moves_1)},
        {"i10_over_ic", value_json(node.moves_10)},
        {"i1", value_json(node.moves_1, heave)},
        {"i10", value_json(node.moves_10, heave)},
        {"i1_at_most", node.moves_1 && node.moves_1->is_at_most},
        {"i10_at_most", node.moves_10 && node.moves_10->is_at_most},
        {"lower_bounds",
         {{"i1_over_ic", floor_json(node.moves_1, node.least_1)},
          {"i10_over_ic", floor_json(node.moves_10, node.least_10)},
          {"i1", floor_json(node.moves_1, node.least_1, heave)},
          {"i10", floor_json(node.moves_10, node.least_10, heave)}}},
        {"seeds", is_inside ? json(found.seeds()) : json(nullptr)},
        {"deviation",
         {{"alpha", is_inside ? or_null(node.alpha.deviation) : json(nullptr)},
          {"i1_over_ic", deviation_json(node.moves_1)},
          {"i10_over_ic", deviation_json(node.moves_10)}}},
        {"interpolated", found.is_interpolated},
        {"interpolation_error", {{"i1", or_null(flow.error.moves_1)}, {"i10", or_null(flow.error.moves_10)}}},
        {"sifting", found.sifting()},
        {"rows", rows}};
}

} // namespace

AtlasAnswer
consult_atlas(const grains::Grading& measured, const stability::AssessSpec& spec, const std::vector<atlas::Row>& rows) {
    AtlasAnswer answer;
    answer.extent = extent_of(rows);
    split_soil(measured, spec.finer_than, answer);
    if (!answer.parts) {
        return answer;
    }
    for (const atlas::Flow flow : flows_of(spec.seepage ? spec.seepage->flow : std::nullopt)) {
        AtlasFlow of_flow{flow, {}, atlas::error_of_interpolation(rows, flow)};
        for (const atlas::Density density : atlas::densities_of(rows, flow)) {
            of_flow.of_density.push_back(
                atlas::look_up(rows, answer.parts->size_ratio, answer.parts->fines_content, density, flow)
            );
        }
        answer.flows.push_back(of_flow);
    }
    return answer;
}

json atlas_json(const AtlasAnswer& answer, const stability::AssessSpec& spec) {
    const double grain_density = spec.seepage.value_or(stability::Seepage{}).grain_density;
    json list = json::array();
    for (const AtlasFlow& flow : answer.flows) {
        for (const atlas::Found& found : flow.of_density) {
            list.push_back(found_json(*answer.parts, found, flow, grain_density));
        }
    }
    return list;
}

} // namespace suffuse::job
