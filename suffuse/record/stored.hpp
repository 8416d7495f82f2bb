#pragma once
// Files that a run has left: where one does not hold what is taken from it, an IoError names it and says what helps.

#include "suffuse/base/error.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace suffuse::record {

/// @param found what is wrong with the file; or with one in it, where it is a folder
IoError not_as_stored(const std::filesystem::path& file, const std::string& found);

/// What nlohmann's library found, without its own numbers.
std::string words_of(const nlohmann::json::exception& error);

/// What `take` takes from what was read of `file`: keys may be missing there, and values be of other types.
template <class Take>
auto take_from(const std::filesystem::path& file, const Take& take) {
    try {
        return take();
    } catch (const nlohmann::json::exception& error) {
        throw not_as_stored(file, words_of(error));
    }
}

} // namespace suffuse::record
