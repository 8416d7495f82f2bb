#pragma once
// The command line -> one plain value. Wrong use is reported with the nearest word that would have been right.

#include "suffuse/base/error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::apps {

enum class Color { Auto, Always, Never };

struct CommandLine {
    std::string verb;  ///< empty: `text` is all there is to say
    std::string text;  ///< help or version
    std::string typed; ///< the whole command, quoted as for a shell

    bool quiet = false, verbose = false, json = false;
    Color color = Color::Auto;
    std::string color_word = "auto"; ///< as typed

    std::string subject; ///< case file, run folder, key, state: the verb's first argument
    std::string other;   ///< of `compare`: the second run
    std::string tolerance;
    bool paper = false; ///< `compare` with the paper's findings
    std::string output; ///< -o
    std::string preset;
    std::vector<std::string> overrides; ///< --set
    std::vector<std::string> studies;   ///< --study
    std::string until;                  ///< stage
    std::string time_limit;             ///< with its unit
    int threads = 0;                    ///< 0: all cores
    std::string cache;                  ///< folder of the cache of stages
    bool no_cache = false;
    std::string sample;                    ///< of `resume`: this one alone
    std::string emit;                      ///< of `sweep`: slurm or parallel
    std::string collect;                   ///< of `sweep`: folder of a run
    std::optional<double> cache_limit;     ///< [GB]
    bool clear = false;                    ///< the cache
    std::string from;                      ///< template of `new`
    std::string psd, sizes;                ///< grading curve of `new`, and the part of it that is modeled
    std::string pressure;                  ///< of `new`: on the soil, with its unit
    std::optional<std::int64_t> particles; ///< of `new`: grains of the quick preset
    std::string bench;                     ///< "step" or "flow"
    std::string mode = "reference";        ///< of `bench step`
    std::string unit;                      ///< of `import`: what a length of 1 in its file stands for
    std::string packing, cell, time_step, density, format;
    std::vector<std::string> figures; ///< of `figures`: numbers or names
    std::int64_t steps = 2000;
    int replicate = 1;
    double gradient = 0.05;

    std::string fines;                      ///< of `assess`: size below which grains are fine, with its unit
    std::optional<double> seepage_gradient; ///< of `assess` and `new`
    std::optional<double> relative_density, porosity, stress_share;
    bool coarse_fabric = false; ///< uniformity of the coarse part alone
};

/// @throws UsageError.
CommandLine read_command_line(int argc, const char* const* argv);

} // namespace suffuse::apps
