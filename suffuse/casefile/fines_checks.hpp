#pragma once
// Which grains are fine, and are there any? Of stages that move, remove or weigh them.

#include "suffuse/casefile/reader.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace suffuse::casefile {

/// Where a key of the stage stands in the case.
using PlaceOfKey = std::function<Place(std::string_view key)>;

/// Reports a stage whose fines nobody names, a soil that has none of them or nothing else, and fines that enter where
/// they cannot.
void check_fines(ReadContext& context, const Variant& variant, const Stage& stage, const PlaceOfKey& place);

} // namespace suffuse::casefile
