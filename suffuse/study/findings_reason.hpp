#pragma once
// Why a finding on erosion is not met, or is met by noise: sentences with the run's own numbers.

#include "suffuse/erosion/result.hpp"

#include <optional>
#include <string>

namespace suffuse::study {

/// Grains of a pass that left with at least so many contacts.
std::int64_t left_with_at_least(const erosion::PassResult& pass, int contacts);

/// That a pass took grains which its own twin without water does not distinguish; empty where it did not. Only a rule
/// on speed can.
std::string describe_noise(const erosion::PassResult* pass);

/// Why a second pass finds no grain that carries load, or too few.
std::string describe_few_active(const erosion::ErosionResult& erosion, const erosion::PassResult* second);

/// Why the skeleton noticed the first pass: load carrying grains left in it; empty where none did.
std::string describe_active_in_first(const erosion::PassResult* first);

} // namespace suffuse::study
