#include "suffuse/run/water_numbers.hpp"

#include "suffuse/facts/mobility.hpp"
#include "suffuse/facts/pass.hpp"
#include "suffuse/record/fact_json.hpp"
#include "suffuse/record/result_json.hpp"

namespace suffuse::run {

using nlohmann::json;
using record::facts_json;
using record::put_facts;

json mobility_numbers(const erosion::MobilityResult& mobility) {
    json numbers = facts_json(facts::mobility, mobility);
    json& ramp = numbers["mobility"] = json::array();
    for (const erosion::MobilityStep& step : mobility.ramp) {
        ramp.push_back(facts_json(facts::mobility_step, step));
        ramp.back()["floats"] = erosion::floats(mobility, step.gradient);
    }
    if (mobility.specified_gradient) {
        put_facts(numbers, facts::mobility_at_gradient, mobility);
        if (const auto safety = erosion::factor_of_safety(mobility); safety && !safety->factor) {
            numbers["factor_of_safety_at_least"] = safety->at_least;
        }
    }
    return numbers;
}

json pass_numbers(const erosion::PassResult& pass) {
    json numbers = facts_json(facts::pass, pass);
    put_facts(numbers, facts::pass_with_water, pass);
    numbers["flow_before"] = facts_json(facts::flow_source, pass.probe.flow);
    numbers["flow_after"] = facts_json(facts::flow_source, pass.flow_after);
    if (pass.transport.distance > 0) {
        numbers["transport"] = facts_json(facts::transport, pass.transport);
    }
    if (pass.mobility) {
        numbers.update(mobility_numbers(*pass.mobility));
    } else {
        numbers["probe"] = facts_json(facts::probe, pass.probe);
    }
    return numbers;
}

} // namespace suffuse::run
