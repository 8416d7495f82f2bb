#pragma once
// The programs that run the tasks of a sweep, as one table: the script that each of them reads, how it is submitted,
// and how a task that was stopped in time comes back.
//
// In a text of the table, @key@ stands for a value. A line with a key whose value is empty is left out.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::apps {

struct Engine {
    std::string_view name;       ///< as --emit has it
    std::string_view title;      ///< as prose has it
    std::string_view file;       ///< its script in the folder of the run, the first one if there are several
    std::string_view tried;      ///< version that ran the script; empty: only the syntax of the script was checked
    int most_tasks = 0;          ///< of an array, where it cannot be asked; 0: it has no arrays, and any number will do
    std::string_view limit;      ///< a command that prints how many tasks an array may have here; empty: there is none
    std::string_view log;        ///< name of a task's log, with its pattern for the number of the task
    std::string_view directives; ///< lines that it reads in the script
    std::string_view index;      ///< variable with the number of the task in its array
    std::string_view go_on;      ///< commands after a task that was stopped in time, in a `case` on its exit code
    std::string_view submit;     ///< a command that submits $script and prints the job's number
    std::string_view job;        ///< how a job is named where another one waits for it
    std::string_view joint;      ///< between two such names
    std::string_view gather;     ///< a command that submits $script to begin when $jobs have ended
    std::string_view whole;      ///< the script, where the engine reads tasks by itself; empty: tasks.txt, or an array
    std::string_view command;    ///< what the user types
};

const std::vector<Engine>& engines();

/// By its name, or null.
const Engine* find_engine(std::string_view name);

/// "slurm", "pbs" and so on.
std::vector<std::string> engine_names();

/// A text of the table with its values. @throws Bug where one is missing.
std::string fill_template(std::string_view text, const std::map<std::string, std::string>& values);

} // namespace suffuse::apps
