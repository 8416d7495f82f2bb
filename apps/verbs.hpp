#pragma once
// The verbs: each takes the command line and answers with an exit code.

#include "suffuse/base/units.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/plan/plan.hpp"

#include "apps/command_line.hpp"
#include "apps/console.hpp"
#include <filesystem>
#include <string>

namespace suffuse::apps {

/// Does what the command line says. @throws UsageError, and the errors of the library.
int perform(const CommandLine& line, const Console& console);

int sweep_verb(const CommandLine& line, const Console& console);
int cache_verb(const CommandLine& line, const Console& console);
int new_verb(const CommandLine& line, const Console& console);
int check_verb(const CommandLine& line, const Console& console);
int explain_verb(const CommandLine& line, const Console& console);
int schema_verb(const CommandLine& line, const Console& console);
int plan_verb(const CommandLine& line, const Console& console);
int run_verb(const CommandLine& line, const Console& console);
int resume_verb(const CommandLine& line, const Console& console);
int report_verb(const CommandLine& line, const Console& console);
int figures_verb(const CommandLine& line, const Console& console);
int compare_verb(const CommandLine& line, const Console& console);
int verify_verb(const CommandLine& line, const Console& console);
int watch_verb(const CommandLine& line, const Console& console);
int bench_verb(const CommandLine& line, const Console& console);
int import_verb(const CommandLine& line, const Console& console);
int export_verb(const CommandLine& line, const Console& console);
int assess_verb(const CommandLine& line, const Console& console);

/// The case with its preset and overrides; its warnings are told.
casefile::Case load_asked_case(const CommandLine& line, const Console& console);

/// What the command line says of the cache, or `usual` where it says nothing; empty: none.
std::filesystem::path cache_folder(const CommandLine& line, const std::filesystem::path& usual);

/// Sets the number of threads: as asked, or one for each core.
void set_threads(int asked);

/// JSON as text; what is not UTF-8 is replaced.
std::string json_text(const nlohmann::json& json);

/// One problem of a case.
nlohmann::json problem_json(const Diagnostic& problem);

/// Edges "LX,LY,LZ" or nine numbers by rows, in meters or with units -> cell matrix [m]. @throws UsageError.
Mat3 cell_of(const std::string& text);

/// A number in SI, or a text with its unit. @throws UsageError, naming the flag.
double quantity_of(const std::string& text, Dimension dimension, const std::string& flag, bool bare_is_si);

} // namespace suffuse::apps
