#include "suffuse/record/check_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

namespace suffuse::record {
namespace {

/// A column's name and rows.
struct Rows {
    const char* name;
    std::size_t rows;
    bool may_be_none = false; ///< of earlier versions
};

std::string find_short(const std::string& table, const Rows& first, std::initializer_list<Rows> others) {
    for (const Rows& other : others) {
        if (other.rows != first.rows && !(other.may_be_none && other.rows == 0)) {
            return fmt::format("{} has {} of {} and {} of {}", table, first.rows, first.name, other.rows, other.name);
        }
    }
    return "";
}

std::string look_at(const erosion::ProbeResult& probe) {
    return find_short(
        "a probe", {"id", probe.id.size()},
        {{"diameter", probe.diameter.size()},
         {"fluid_force", probe.fluid_force.size()},
         {"coordination", probe.coordination.size()},
         {"speed", probe.speed.size()},
         {"twin_speed", probe.twin_speed.size(), true},
         {"displacement", probe.displacement.size(), true},
         {"free_speed", probe.free_speed.size(), true},
         {"free_displacement", probe.free_displacement.size(), true},
         {"by_velocity", probe.by_velocity.size()},
         {"by_displacement", probe.by_displacement.size()}}
    );
}

std::string look_at(const erosion::MobilityResult& mobility) {
    return mobility.ramp.empty() ? "mobility has no ramp"
                                 : find_short(
                                       "mobility", {"id", mobility.id.size()},
                                       {{"diameter", mobility.diameter.size()},
                                        {"mass", mobility.mass.size()},
                                        {"mobile_gradient", mobility.mobile_gradient.size()},
                                        {"bears_load", mobility.bears_load.size()}}
                                   );
}

std::string look_at(const erosion::Transport& transport) {
    return find_short(
        "transport", {"id", transport.id.size()},
        {{"diameter", transport.diameter.size()},
         {"mass", transport.mass.size()},
         {"travel", transport.travel.size()},
         {"progress", transport.progress.size()},
         {"path", transport.path.size()},
         {"throats", transport.throats.size()},
         {"constriction", transport.constriction.size()},
         {"fate", transport.fate.size()}}
    );
}

std::string look_at(const flow::ThroatFlux& flux) {
    const std::string shares =
        find_short("throat_flux", {"quantile", flux.quantile.size()}, {{"carried", flux.carried.size()}});
    return !shares.empty() ? shares
                           : find_short(
                                 "throat_flux", {"diameter", flux.diameter.size()},
                                 {{"flux_10", flux.flux_10.size()},
                                  {"flux_50", flux.flux_50.size()},
                                  {"flux_90", flux.flux_90.size()}}
                             );
}

/// The first of them that is missing.
std::string first_of(std::initializer_list<std::string> found) {
    const auto first = std::ranges::find_if(found, [](const std::string& words) { return !words.empty(); });
    return first == found.end() ? "" : *first;
}

std::string look_at(const erosion::PassResult& pass) {
    return first_of(
        {look_at(pass.probe), pass.mobility ? look_at(*pass.mobility) : "", look_at(pass.transport),
         look_at(pass.throat_flux_before), look_at(pass.throat_flux_after)}
    );
}

template <class T>
std::string look_at_all(const std::vector<T>& all) {
    for (const T& one : all) {
        if (std::string words = look_at(one); !words.empty()) {
            return words;
        }
    }
    return "";
}

} // namespace

std::string what_is_missing(const StageFindings& findings) {
    return first_of(
        {look_at_all(findings.probes), findings.mobility ? look_at(*findings.mobility) : "",
         findings.erosion ? look_at_all(findings.erosion->passes) : "",
         findings.throat_flux ? look_at(*findings.throat_flux) : ""}
    );
}

} // namespace suffuse::record
