#pragma once
// Changes of a document that keep it a document: bytes changed at random seldom get past its parser.

#include <nlohmann/json.hpp>

#include "tests/fuzz/byte_source.hpp"

namespace suffuse::fuzz {

/// One change at a place in `document`: another value, or a row or key removed, doubled or moved.
void change(nlohmann::json& document, Bytes& bytes);

} // namespace suffuse::fuzz
