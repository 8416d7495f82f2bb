#include "apps/complaint.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/readable.hpp"
#include "suffuse/base/render_within.hpp"

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/own_soil.hpp"
#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <utility>

namespace suffuse::apps {
namespace {

struct Complaint {
    int code;
    std::string kind, message;
    bool rendered = false; ///< with its source line already
    nlohmann::json problems = nlohmann::json::array();
    nlohmann::json instead = {}; ///< what can be simulated in place of it, where the error says so
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
    } catch (const TooWide& error) {
        Complaint complaint{BadCase, "case", error.what()};
        complaint.instead = {{"sizes", nullptr}, {"surrogate", error.has_surrogate}};
        if (error.sizes) {
            complaint.instead["sizes"] = {error.sizes->first, error.sizes->second};
        }
        return complaint;
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

} // namespace

ReportedError report_current_error(const Console& console) {
    const Complaint complaint = current_complaint(console.has_color());
    console.error(complaint.rendered ? complaint.message : harmless(complaint.message), complaint.rendered);
    nlohmann::json document{
        {"kind", complaint.kind},
        {"exit_code", complaint.code},
        {"message", readable(complaint.message)},
        {"problems", complaint.problems}};
    if (!complaint.instead.is_null()) {
        document["instead"] = complaint.instead;
    }
    return {complaint.code, document};
}

int complain_about_current(const Console& console) {
    const ReportedError error = report_current_error(console);
    console.document(json_text({{"error", error.json}}));
    return error.code;
}

} // namespace suffuse::apps
