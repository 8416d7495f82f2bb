#include "suffuse/laboratory/test_quantities.hpp"

#include <algorithm>
#include <array>

namespace suffuse::laboratory {
namespace {

constexpr std::array<std::string_view, 3> kinds{"triaxial", "oedometer", "permeameter"};
constexpr std::array<std::string_view, 11> names{"test",     "testname", "testno", "testid", "sample", "samplename",
                                                 "sampleid", "specimen", "name",   "id",     "versuch"};

constexpr Dimension discharge{3, 0, -1, 0};

} // namespace

std::span<const std::string_view> test_kind_names() {
    return kinds;
}

std::optional<TestKind> test_kind_named(std::string_view name) {
    const auto found = std::ranges::find(kinds, name);
    return found == kinds.end() ? std::nullopt : std::optional(static_cast<TestKind>(found - kinds.begin()));
}

std::span<const QuantityRow> quantity_rows() {
    using enum TestKind;
    static const std::array<QuantityRow, 14> rows{
        {{Quantity::AxialStrain,
          "axial_strain",
          "axial strain",
          dimension::none,
          "%",
          {Triaxial, Oedometer},
          {"axialstrain", "verticalstrain", "eps1", "epsilon1", "epsa", "epsilona", "epsz", "ea"}},
         {Quantity::VolumetricStrain,
          "volumetric_strain",
          "volumetric strain",
          dimension::none,
          "%",
          {Triaxial},
          {"volumetricstrain", "volumestrain", "volstrain", "epsv", "epsilonv", "epsvol", "epsilonvol"}},
         {Quantity::VoidRatio,
          "void_ratio",
          "void ratio",
          dimension::none,
          "1",
          {Triaxial, Oedometer, Permeameter},
          {"voidratio", "voidsratio", "porenzahl", "e"}},
         {Quantity::DeviatorStress,
          "deviator_stress",
          "deviator stress",
          dimension::pressure,
          "kPa",
          {Triaxial},
          {"deviatorstress", "deviatoricstress", "deviator", "sigma1sigma3", "q"}},
         {Quantity::MeanStress,
          "mean_stress",
          "mean stress",
          dimension::pressure,
          "kPa",
          {Triaxial},
          {"meanstress", "meanpressure", "sigmam", "p"}},
         {Quantity::AxialStress,
          "axial_stress",
          "axial stress",
          dimension::pressure,
          "kPa",
          {Triaxial, Oedometer},
          {"axialstress", "verticalstress", "sigma1", "sigmaa", "sigmav", "sigmaz"}},
         {Quantity::RadialStress,
          "radial_stress",
          "radial stress",
          dimension::pressure,
          "kPa",
          {Triaxial},
          {"radialstress", "lateralstress", "confiningstress", "confiningpressure", "sigma3", "sigmar", "sigmah"}},
         {Quantity::PorePressure,
          "pore_pressure",
          "pore pressure",
          dimension::pressure,
          "kPa",
          {Triaxial, Oedometer},
          {"porepressure", "porewaterpressure", "pwp", "u"}},
         {Quantity::Time,
          "time",
          "time",
          dimension::time,
          "s",
          {Triaxial, Oedometer, Permeameter},
          {"time", "elapsedtime", "zeit", "t"}},
         {Quantity::Gradient,
          "gradient",
          "hydraulic gradient",
          dimension::none,
          "1",
          {Permeameter},
          {"gradient", "hydraulicgradient", "meangradient", "i"}},
         {Quantity::HeadDifference,
          "head_difference",
          "head difference",
          dimension::length,
          "m",
          {Permeameter},
          {"headdifference", "headloss", "head", "dh", "deltah"}},
         {Quantity::Discharge,
          "discharge",
          "discharge",
          discharge,
          "mL/s",
          {Permeameter},
          {"discharge", "flowrate", "flow", "outflow", "q"}},
         {Quantity::Velocity,
          "velocity",
          "filter velocity",
          dimension::velocity,
          "mm/s",
          {Permeameter},
          {"velocity", "filtervelocity", "darcyvelocity", "dischargevelocity", "v"}},
         {Quantity::Mass,
          "mass",
          "mass carried out",
          dimension::mass,
          "g",
          {Permeameter},
          {"mass", "erodedmass", "massloss", "erodedsoil", "soilloss", "m"}}}};
    return rows;
}

const QuantityRow& row_of(Quantity quantity) {
    return quantity_rows()[static_cast<std::size_t>(quantity)];
}

std::span<const std::string_view> name_words() {
    return names;
}

} // namespace suffuse::laboratory
