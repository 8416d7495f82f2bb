#include "suffuse/run/probed_samples.hpp"

#include "suffuse/run/result_json.hpp"

namespace suffuse::run {
namespace {

constexpr std::size_t most_samples = 6; ///< as many as there are colors

report::ProbedDirection describe(const triaxial::StressProbe& probe, int axis) {
    const auto lateral = [&](const Vec3& v) { return 0.5 * (v[(axis + 1) % 3] + v[(axis + 2) % 3]); };
    return {
        probe.angle,
        probe.normalized,
        probe.stress[axis],
        lateral(probe.stress),
        probe.strain[axis],
        lateral(probe.strain),
        nlohmann::json(probe.answer).get<std::string>()};
}

} // namespace

std::vector<report::ProbedSample> gather_probed_samples(const std::vector<FinishedStage>& stages) {
    std::vector<report::ProbedSample> samples;
    for (const FinishedStage& stage : stages) {
        const auto* spec = std::get_if<triaxial::StressProbeSpec>(&stage.stage->spec);
        if (spec == nullptr || samples.size() == most_samples) {
            continue;
        }
        report::ProbedSample sample;
        sample.name = stage.variant->folder + "/" + stage.stage->name;
        for (const auto& probe : stage.numbers.at("stress_probes").get<std::vector<triaxial::StressProbe>>()) {
            sample.directions.push_back(describe(probe, spec->axis));
        }
        samples.push_back(std::move(sample));
    }
    return samples;
}

} // namespace suffuse::run
