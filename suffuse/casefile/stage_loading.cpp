#include "suffuse/casefile/stage_loading.hpp"

#include "suffuse/dem/settle.hpp"

namespace suffuse::casefile {

namespace {

using Named = std::optional<cell::Loading>;

struct LoadingAtEnd {
    Named operator()(const ImportSpec&) const { return {}; }

    Named operator()(const packing::PackSpec&) const { return {}; }

    Named operator()(const packing::CompactSpec& spec) const {
        cell::Loading loading = dem::isotropic_stress(spec.pressure);
        loading.shear_released = spec.shear_released;
        return loading;
    }

    Named operator()(const dem::SettleSpec& spec) const { return spec.loading; }

    Named operator()(const triaxial::TriaxialSpec&) const { return {}; } // its own rows report errors

    Named operator()(const triaxial::StressProbeSpec&) const { return {}; }

    Named operator()(const triaxial::StiffnessSpec&) const { return {}; }

    Named operator()(const dem::AdvanceSpec&) const { return {}; } // whose end need not be balanced

    Named operator()(const flow::FlowSpec&) const { return {}; }

    Named operator()(const erosion::DetachStageSpec&) const { return {}; }

    Named operator()(const erosion::ErodeSpec&) const { return {}; } // under what it finds

    Named operator()(const erosion::RemoveSpec&) const { return {}; }

    Named operator()(const erosion::MigrateSpec&) const { return {}; }
};

} // namespace

std::optional<cell::Loading> loading_at_end(const StageSpec& spec) {
    return std::visit(LoadingAtEnd{}, spec);
}

bool could_release_shear(const StageSpec& spec) {
    const auto* const compact = std::get_if<packing::CompactSpec>(&spec);
    return compact != nullptr && !compact->shear_released && compact->protocol != packing::Protocol::Slow;
}

} // namespace suffuse::casefile
