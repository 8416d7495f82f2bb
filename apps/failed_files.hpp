#pragma once
// Files of several that could not be read or judged: each is reported, and work goes on with the others.

#include "suffuse/base/error.hpp"

#include <nlohmann/json.hpp>

#include "apps/complaint.hpp"
#include "apps/exit_code.hpp"
#include <string>

namespace suffuse::apps {

class FailedFiles {
public:
    /// @param count of all files: one alone fails as any other
    explicit FailedFiles(std::size_t count) : is_alone_(count == 1) {}

    /// Works at one of the files.
    template <class Work>
    void attempt(const std::string& file, const Console& console, Work work) {
        try {
            work();
        } catch (const CaseError&) {
            report(file, console);
        } catch (const IoError&) {
            report(file, console);
        }
    }

    [[nodiscard]] const nlohmann::json& errors() const { return errors_; }

    [[nodiscard]] int code() const { return code_; } ///< of the first

    void add_to(nlohmann::json& document) const {
        if (!errors_.empty()) {
            document["errors"] = errors_;
        }
    }

private:
    /// The exception in flight.
    void report(const std::string& file, const Console& console) {
        if (is_alone_) {
            throw;
        }
        ReportedError error = report_current_error(console);
        error.json["file"] = file;
        code_ = code_ == Done ? error.code : code_;
        errors_.push_back(std::move(error.json));
    }

    bool is_alone_;
    nlohmann::json errors_ = nlohmann::json::array();
    int code_ = Done;
};

} // namespace suffuse::apps
