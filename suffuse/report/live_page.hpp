#pragma once
// The page that stands in place of the report while a run is under way: where it is, what is done, how long it may
// take. A file that loads itself anew, without script and without server; who opens it early ends up at the report.

#include <string>
#include <vector>

namespace suffuse::report {

struct LiveRow {
    std::string stage, verb;
    std::string status; ///< "done", "running", "waits", "failed"
    std::string time;   ///< that it took, or that the plan gives it
    std::string state;  ///< its numbers
};

struct LivePage {
    std::string title, run;
    std::string at;       ///< when this was written
    double share = 0;     ///< of the stages that are done
    std::string progress; ///< "3 of 10 stages"
    std::string left;     ///< how long the rest may take; empty once nothing more comes
    std::vector<LiveRow> rows;
    std::string ending;      ///< why nothing more comes, in a sentence; empty while the run is under way
    std::string command;     ///< with which it goes on after a stop; may be empty
    int refresh_seconds = 3; ///< used while the run is under way
};

/// HTML, whole.
std::string render_live_page(const LivePage& page);

} // namespace suffuse::report
