#pragma once
// What the page can request, in four parts: a soil's criteria, a case and its price, the runs, and the tasks of a
// sweep. Fields of a form are called as the options of the program are.

#include "apps/studio/http.hpp"
#include "apps/studio/program.hpp"
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::studio {

struct Studio {
    std::filesystem::path folder;      ///< of the runs
    std::vector<std::string> examples; ///< that a case can start from
    std::mutex starting;               ///< held from the look at the memory until a run has published its own plan
};

void add_soil_routes(httplib::Server& server);
void add_case_routes(httplib::Server& server, Studio& studio);
void add_run_routes(httplib::Server& server, Studio& studio);
void add_sweep_routes(httplib::Server& server, Studio& studio);

/// A field of a form; empty where it is not given.
std::string field(const httplib::Request& request, const std::string& name);

/// "--fines=0.2mm" for each of these fields that is given.
void add_options(
    const httplib::Request& request, const std::vector<std::string_view>& names, std::vector<std::string>& words
);

/// Writes a file of a form into a folder. @return its name there. @throws Refusal 400 where it is not given
std::string take_upload(const httplib::Request& request, const std::string& name, const std::filesystem::path& folder);

/// Writes a case of the page and its data, fields "case" and "file:data/dam.csv", into a folder. @throws Refusal 400
/// for a name of a file that leads elsewhere
void take_case(const httplib::Request& request, const std::filesystem::path& folder);

/// What came of a call: {"result", "talk"}; or {"error", "talk"}, the error with its problems as the program wrote it.
void answer_call(httplib::Response& response, const ProgramCall& call);

} // namespace suffuse::studio
