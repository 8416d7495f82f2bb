#pragma once
// Files of the checkout for the tests, above all the reference's: JSON, compressed or not, from tests/reference.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace suffuse::test {

/// Where a file or folder of the checkout is, `examples/replay` say.
std::string in_checkout(const std::string& path);

/// Text of a file under tests/reference, decompressed where it is compressed.
std::string read_reference(const std::string& name);

nlohmann::json read_reference_json(const std::string& name);

} // namespace suffuse::test
