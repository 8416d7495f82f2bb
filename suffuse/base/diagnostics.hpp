#pragma once
// What is wrong with a case: each problem with its place and one thing to do, all of them at once.

#include "suffuse/base/error.hpp"
#include "suffuse/base/place.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace suffuse {

struct Diagnostic {
    std::string code;         ///< "E203", stable; `explain` knows it
    std::string file;         ///< as the user named it; "--set" for an override
    int line = 0, column = 0; ///< from 1, in characters; 0 where there is none
    int length = 1;           ///< characters to underline
    std::string source_line;  ///< the line itself; empty where there is none
    std::string message;
    std::string label; ///< short, next to the carets
    std::string help;  ///< one thing to do
    bool is_warning = false;
};

/// Where a line of a source begins.
struct LineMark {
    std::shared_ptr<const Source> source;
    int line = 1; ///< from 1
    std::size_t begin = 0;
};

/// A line of the source, from 1, without its end; empty where there is none.
std::string line_of(const Source& source, int line);

/// Collects problems while a case is read.
class Problems {
public:
    /// `label` stands next to the carets, `help` below; both may be empty.
    void
    error(std::string code, const Place& place, std::string message, std::string help = {}, std::string label = {});
    void
    warning(std::string code, const Place& place, std::string message, std::string help = {}, std::string label = {});

    /// Adds to the help of the first error.
    void advise(const std::string& help);

    /// All that another list holds, behind what this one does.
    void take_over(const Problems& other);

    [[nodiscard]] bool has_errors() const;

    /// In the order of the files and lines; the same problem at the same place once.
    [[nodiscard]] std::vector<Diagnostic> sorted() const;

private:
    void add(Diagnostic diagnostic, const Place& place);

    std::vector<Diagnostic> list_;
    LineMark last_line_; ///< problems come in the order of the lines, mostly
};

/// Source line with carets and help for each, then a line that counts them; of several warnings of one code, and of
/// more than three errors with the same help in one file, the first, the others in a line each. `color` uses terminal
/// colors.
std::string render(const std::vector<Diagnostic>& list, bool color = false);

/// "2 errors, 1 warning".
std::string count_problems(const std::vector<Diagnostic>& list);

/// A case that cannot be run: `what()` is the rendered text, `problems` the list.
struct CaseProblems : CaseError {
    explicit CaseProblems(std::vector<Diagnostic> list);

    std::vector<Diagnostic> problems;
};

} // namespace suffuse
