#pragma once
// The error family. Errors are thrown at doors, with the numbers as fields; kernels count and report in values.

#include <cstdint>
#include <source_location>
#include <stdexcept>
#include <string>
#include <utility>

namespace suffuse {

/// Anything that the user or the machine can mend. `what()` says what, where and what to do.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What was requested, by a flag or an argument, cannot be; the message ends with what to do.
struct UsageError : Error {
    using Error::Error;
};

/// A case or data file requests something impossible. The message is complete as it stands, place included.
struct CaseError : Error {
    CaseError(const std::string& message, std::string file_path = {}, int line_number = 0)
        : Error(message), file(std::move(file_path)), line(line_number) {}

    std::string file;
    int line; ///< 1-based; 0 where there is none
};

/// Geometry that the method cannot treat: coincident grains, a cell narrower than a grain.
struct GeometryError : Error {
    using Error::Error;
};

/// A linear solver that did not reach its tolerance.
struct SolverError : Error {
    SolverError(const std::string& message, int iterations_done, double residual_left)
        : Error(message), iterations(iterations_done), residual(residual_left) {}

    int iterations;
    double residual; ///< relative [-]
};

/// The simulated state left what the model can describe: not a number, overlaps too large, a stress out of reach.
struct StateError : Error {
    using Error::Error;
};

/// A file that cannot be read or written.
struct IoError : Error {
    using Error::Error;
};

/// A long stage was requested to stop (Ctrl-C, time limit); the state has been saved or is as before the call.
struct Interrupted : Error {
    using Error::Error;
};

/// A broken promise between our own functions.
struct Bug : std::logic_error {
    explicit Bug(const std::string& message, std::source_location place = std::source_location::current())
        : std::logic_error(
              std::string(place.file_name()) + ":" + std::to_string(place.line()) + ": " + message +
              " (a defect of suffuse, please report it)"
          ) {}
};

/// Guards a module's door in all builds: throws Bug when a caller of our own broke the contract.
inline void expects(bool condition, const char* message, std::source_location place = std::source_location::current()) {
    if (!condition) {
        throw Bug(message, place);
    }
}

} // namespace suffuse
