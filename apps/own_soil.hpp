#pragma once
// A soil of the user's as a case can model it: from a measured grading curve to a closed one, with the size below which
// its grains are fine and the number of grains that stand for it. What was decided on the way is kept as sentences.

#include "suffuse/base/error.hpp"
#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/flow_way.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace suffuse::apps {

/// Grains of a quick sample unless specified otherwise. How long it runs depends on its sizes too: what is much finer
/// needs stiffer contacts, and those shorter steps.
inline constexpr double most_quick_grains = 20'000;

struct OwnSoil {
    std::string name;              ///< of the file, fit for a table of a case and a folder
    grains::Grading grading;       ///< from 0 to 100 %
    std::string left_out;          ///< "the 4 % finer than 0.063 mm, which were not measured"; empty where nothing is
    grains::Grading measured;      ///< the curve as given, with what is left out
    double finer_than = 0;         ///< [m]
    double fines_content = 0;      ///< of the modeled curve [-]
    double fines_of_whole = 0;     ///< likewise of the whole soil, as `assess` says [-]
    std::string reason;            ///< why that size
    std::int64_t quick_grains = 0; ///< of the quick preset
    bool is_size_given = false;    ///< so many were requested
};

/// Sizes [m] between which a curve is modeled.
using SizeRange = std::pair<double, double>;

/// A soil whose sizes are too far apart for one sample, and what can be simulated in its place.
struct TooWide : CaseError {
    TooWide(const std::string& message, const std::optional<SizeRange>& part, bool surrogate)
        : CaseError(message), sizes(part), has_surrogate(surrogate) {}

    std::optional<SizeRange> sizes; ///< of a part of it
    bool has_surrogate;
};

/// What the user decides of it.
struct OwnSoilSpec {
    std::string words;                          ///< of a command that reads the curve: "table.csv --sample TP1"
    std::optional<SizeRange> sizes = {};        ///< the whole curve unless given
    std::optional<double> finer_than = {};      ///< found on the curve unless given [m]
    std::optional<std::int64_t> particles = {}; ///< of the quick preset; as few as will do unless given
};

/// "till" of "data/till.csv": in letters, digits, - and _, as tables of a case are named.
std::string soil_name(const std::string& path);

/// The grains between the ends of a curve alone, from 0 to 100 %: whatever lies beyond an open end has no known size.
/// @throws CaseError where nothing lies between them
grains::Grading measured_part(const grains::Grading& measured, const std::string& path);

/// "the 4 % finer than 0.063 mm": what lies beyond the modeled sizes [m], of the mass that was measured or not.
std::string left_out_of(const grains::Grading& measured, double finest, double coarsest);

/// "13.8 % of the modeled part, 20 % of the whole soil"; "20 % of the mass" where all of it is modeled.
std::string fines_text(const OwnSoil& soil);

/// @param path for messages, and for the soil's name
/// @throws TooWide saying at which sizes to cut
OwnSoil model_own_soil(const grains::Grading& measured, const std::string& path, const OwnSoilSpec& spec);

using stability::FlowWay;

/// What the soil is under. Assumed where the user does not say.
struct OwnConditions {
    std::optional<double> pressure = {}; ///< [Pa]
    std::optional<double> gradient = {}; ///< hydraulic [-]
    std::optional<FlowWay> flow = {};    ///< nothing: fines have no weight
};

inline constexpr double assumed_pressure = 100e3; ///< [Pa]
inline constexpr double assumed_gradient = 0.05;  ///< [-]

/// The case and its grading as files, and where they belong in its folder.
std::string own_case_text(const OwnSoil& soil, const OwnConditions& conditions);
std::string own_grading_text(const grains::Grading& measured, const std::string& path);

} // namespace suffuse::apps
