#pragma once
// JSON and CBOR of files that anybody may have written.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace suffuse::record {

/// Discarded where the text is no JSON, or nested deeper than anything of ours: what reads on from there calls itself
/// for each level, and a file of brackets alone would end it for want of stack.
nlohmann::json parse_json(std::string_view text);

/// The same of CBOR.
nlohmann::json parse_cbor(std::span<const std::uint8_t> bytes);

} // namespace suffuse::record
