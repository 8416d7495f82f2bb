#pragma once
// A new case of the user's own soil, written from its grading curve: whole, by a surrogate, or on its filter.

#include "apps/console.hpp"
#include "apps/grading_input.hpp"
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::apps {

struct NewFile {
    std::filesystem::path path;
    std::string text;
};

/// Writes all, or none where one exists. @return their paths. @throws UsageError
std::vector<std::string> write_new(const std::vector<NewFile>& files);

/// What to call with the case in this folder.
void print_next_steps(const std::filesystem::path& folder, const Console& console);

/// As typed: sizes and stresses with their units; empty where it is left to the program.
struct SoilRequest {
    std::string curve_file;
    std::string folder; ///< of the case; empty: that of the soil's name
    std::string sizes;  ///< the part of the curve that is modeled
    std::string fines;  ///< size below which grains are fine
    std::string sample; ///< of a file of several curves
    ReadingFlags reading;
    std::optional<std::int64_t> particles; ///< of the quick preset
    std::string pressure;                  ///< on the soil
    std::optional<double> gradient;
    std::string filter;        ///< grading curve of what is to hold that soil
    std::string filter_sample; ///< of a file of several curves
    bool surrogate = false;
    std::string flow; ///< which way the water goes through fines that have weight
};

/// @return the exit code
int new_from_soil(const SoilRequest& request, const Console& console);

} // namespace suffuse::apps
