#pragma once
// How libFuzzer changes an input that is a document: within its values, seldom its bytes.

#include "tests/fuzz/change_json.hpp"
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace suffuse::fuzz {

/// @param read, write from bytes to JSON and back @return the new size
template <class Read, class Write>
std::size_t mutate_document(
    std::uint8_t* data, std::size_t size, std::size_t largest, unsigned seed, const Read& read, const Write& write
) {
    std::minstd_rand chance(seed);
    nlohmann::json document = read(std::string(reinterpret_cast<const char*>(data), size));
    if (document.is_discarded() || chance() % 8 == 0) {
        return LLVMFuzzerMutate(data, size, largest);
    }
    std::vector<std::uint8_t> choices(64);
    for (std::uint8_t& each : choices) {
        each = static_cast<std::uint8_t>(chance() >> 8U);
    }
    Bytes bytes{choices.data(), choices.size()};
    change(document, bytes);
    const std::string text = write(document);
    if (text.size() > largest) {
        return LLVMFuzzerMutate(data, size, largest);
    }
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

} // namespace suffuse::fuzz
