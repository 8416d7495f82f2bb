// The program: the command line in, an exit code out. Every error that nothing below can answer for ends here, once,
// with its words and its code.

#include "suffuse/base/error.hpp"
#include "suffuse/base/readable.hpp"
#include "suffuse/base/render_within.hpp"

#include <fmt/format.h>

#include "apps/command_line.hpp"
#include "apps/console.hpp"
#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/process_limits.hpp"
#include "apps/standard_streams.hpp"
#include "apps/stop_signal.hpp"
#include "apps/verb.hpp"
#include <algorithm>
#include <exception>
#include <filesystem>
#include <malloc.h>
#include <new>
#include <string_view>

namespace suffuse::apps {
namespace {

struct Complaint {
    int code;
    std::string kind, message;
    bool rendered = false; ///< with its source line already
    nlohmann::json problems = nlohmann::json::array();
};

Complaint complaint_about(const CaseProblems& error, bool color) {
    Complaint complaint{BadCase, "case", render_within(error.problems, color, source_width()), true};
    for (const Diagnostic& problem : error.problems) {
        complaint.problems.push_back(problem_json(problem));
    }
    return complaint;
}

/// What the exception in flight means to the user.
Complaint current_complaint(bool color) {
    try {
        throw;
    } catch (const UsageError& error) {
        return {WrongUse, "usage", error.what()};
    } catch (const CaseProblems& error) {
        return complaint_about(error, color);
    } catch (const CaseError& error) {
        return {BadCase, "case", error.what()};
    } catch (const IoError& error) {
        return {InputOutput, "io", error.what()};
    } catch (const std::filesystem::filesystem_error& error) {
        return {InputOutput, "io", error.what()};
    } catch (const suffuse::Interrupted& error) {
        return {Interrupted, "interrupted", error.what()};
    } catch (const Error& error) {
        return {Failed, "run", error.what()};
    } catch (const std::bad_alloc&) {
        return {
            InputOutput, "memory",
            "out of memory; suffuse plan CASE shows how much a case needs, --memory limits what a run may use"};
    } catch (const std::exception& error) {
        return {OurDefect, "defect", error.what()};
    } catch (...) {
        return {
            OurDefect, "defect",
            "something other than an exception was thrown (a defect of suffuse, please report it)"};
    }
}

/// Names of files come from the user and could hold what moves a terminal's cursor.
std::string harmless(std::string message) {
    constexpr std::size_t most = 4000;
    if (message.size() > most) {
        message = message.substr(0, most) + " ...";
    }
    std::replace_if(
        message.begin(), message.end(),
        [](char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f; }, '?'
    );
    return message;
}

int complain(const Complaint& complaint, const Console& console) {
    console.error(complaint.rendered ? complaint.message : harmless(complaint.message), complaint.rendered);
    console.document(json_text(
        {{"error",
          {{"kind", complaint.kind},
           {"exit_code", complaint.code},
           {"message", readable(complaint.message)},
           {"problems", complaint.problems}}}}
    ));
    return complaint.code;
}

int run_program(int argc, const char* const* argv) {
    CommandLine early; // what an error about the command line itself needs to know
    early.json = std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
    Console console(early);
    try {
        raise_stack_limit();
        const ParsedCommand command = read_command_line(argc, argv);
        console = Console(command.line);
        if (!command.text.empty()) {
            Console().result(command.text);
            Console().finish();
            return Done;
        }
        raise_file_limit();
        const int code = command.verb->act(command.line, console);
        console.finish();
        return code;
    } catch (...) {
        return complain(current_complaint(console.has_color()), console);
    }
}

} // namespace
} // namespace suffuse::apps

int main(int argc, char** argv) {
    // Large tables go back to the system when they are freed; left to itself, the allocator would keep them after the
    // first, and a sample would hold half as much again.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    suffuse::apps::fill_closed_streams();
    suffuse::apps::ignore_write_signals();
    return suffuse::apps::run_program(argc, argv);
}
