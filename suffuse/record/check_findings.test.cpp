#include "suffuse/record/check_findings.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace suffuse::record {
namespace {

/// Of two grains.
erosion::ProbeResult good_probe() {
    erosion::ProbeResult probe;
    probe.id = {3, 5};
    probe.diameter = probe.fluid_force = {1, 2};
    probe.coordination = {4, 0};
    probe.speed.resize(2);
    probe.by_velocity = probe.by_displacement = {0, 1};
    return probe;
}

erosion::MobilityResult good_mobility() {
    erosion::MobilityResult mobility;
    mobility.ramp.resize(1);
    mobility.id = {3};
    mobility.diameter = mobility.mass = mobility.mobile_gradient = {1};
    mobility.bears_load = {0};
    return mobility;
}

erosion::Transport good_transport() {
    erosion::Transport transport;
    transport.id = {3};
    transport.diameter = transport.mass = transport.travel = transport.progress = {1};
    transport.path = transport.constriction = {1};
    transport.throats = {1};
    transport.fate = {erosion::Fate::Left};
    return transport;
}

flow::ThroatFlux good_flux() {
    flow::ThroatFlux flux;
    flux.quantile = flux.carried = {0, 0.5, 1};
    flux.diameter = flux.flux_10 = flux.flux_50 = flux.flux_90 = {1, 2};
    return flux;
}

/// Of every kind.
StageFindings good_findings() {
    StageFindings findings;
    findings.probes = {good_probe()};
    findings.mobility = good_mobility();
    findings.throat_flux = good_flux();
    erosion::PassResult pass;
    pass.probe = good_probe();
    pass.mobility = good_mobility();
    pass.transport = good_transport();
    pass.throat_flux_before = pass.throat_flux_after = good_flux();
    findings.erosion.emplace().passes = {pass};
    return findings;
}

std::string missing_after(const std::function<void(StageFindings&)>& change) {
    StageFindings findings = good_findings();
    change(findings);
    return what_is_missing(findings);
}

TEST(CheckedFindings, OfARunMissNothing) {
    EXPECT_EQ(what_is_missing(good_findings()), "");
    EXPECT_EQ(what_is_missing({}), "");
}

TEST(CheckedFindings, OfEarlierVersionsMayLackColumnsThatCameLater) {
    EXPECT_EQ(missing_after([](StageFindings& f) { f.probes[0].twin_speed = {1, 2}; }), "");
    EXPECT_EQ(
        missing_after([](StageFindings& f) { f.probes[0].twin_speed = {1}; }), "a probe has 2 of id and 1 of twin_speed"
    );
}

TEST(CheckedFindings, NeedARowAGrain) {
    EXPECT_EQ(missing_after([](StageFindings& f) { f.probes[0].speed.clear(); }), "a probe has 2 of id and 0 of speed");
    EXPECT_EQ(missing_after([](StageFindings& f) { f.probes[0].id.clear(); }), "a probe has 0 of id and 2 of diameter");
    EXPECT_EQ(
        missing_after([](StageFindings& f) { f.mobility->mass.push_back(1); }), "mobility has 1 of id and 2 of mass"
    );
    EXPECT_EQ(
        missing_after([](StageFindings& f) { f.throat_flux->carried.pop_back(); }),
        "throat_flux has 3 of quantile and 2 of carried"
    );
    EXPECT_EQ(
        missing_after([](StageFindings& f) { f.throat_flux->flux_50 = {1}; }),
        "throat_flux has 2 of diameter and 1 of flux_50"
    );
}

TEST(CheckedFindings, NeedARampThatMovedGrains) {
    EXPECT_EQ(missing_after([](StageFindings& f) { f.mobility->ramp.clear(); }), "mobility has no ramp");
}

TEST(CheckedFindings, OfEveryPassAreLookedAt) {
    const std::vector<std::function<void(erosion::PassResult&)>> changes = {
        [](auto& pass) { pass.probe.coordination.clear(); }, [](auto& pass) { pass.mobility->bears_load.clear(); },
        [](auto& pass) { pass.transport.fate.clear(); }, [](auto& pass) { pass.throat_flux_before.flux_90.clear(); },
        [](auto& pass) { pass.throat_flux_after.quantile.clear(); }};
    for (const auto& change : changes) {
        EXPECT_NE(missing_after([&](StageFindings& f) { change(f.erosion->passes[0]); }), "");
    }
}

} // namespace
} // namespace suffuse::record
