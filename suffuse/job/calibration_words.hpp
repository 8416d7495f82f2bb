#pragma once
// The answer of a calibration as people read it, from calibration.json.

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::job {

/// How far its intervals can be trusted: one sentence, without capital and point.
inline constexpr std::string_view calibration_caution =
    "intervals are checked for simulated drained tests of the linear law alone";
/// Where that stands in full.
inline constexpr std::string_view calibration_caution_page = "docs/how-to/calibrate.md#how-far-to-trust-the-intervals";

/// "contact.rolling_friction" -> "rolling friction", "void_ratio.low" -> "void ratio of low"
std::string key_in_words(const std::string& key);

/// A value in SI as the case has it: "4.14 GPa", "21.9°". @param parameter of calibration.json
std::string value_in_words(const nlohmann::json& parameter, double value);

/// "18.7 to 28.8°"
std::string interval_in_words(const nlohmann::json& parameter);

/// "the volumetric strain of these tests": what would identify a parameter, by its key `identified_by`.
std::string_view remedy_in_words(std::string_view key);

/// "volumetric strain" for "volumetric_strain"
std::string quantity_in_words(const std::string& quantity);

/// One to three sentences: the parameters with their intervals, and which the tests leave open.
std::vector<std::string> verdict_of(const nlohmann::json& calibration);

/// The largest ones about the answer, at most three, with what would remove each: bounds, misfits, failed samples.
std::vector<std::string> doubts_on(const nlohmann::json& calibration);

} // namespace suffuse::job
