#pragma once
// One verb of the program: what it is called, which options it has and what it does. Each stands in a file of its own,
// verb_NAME.cpp, and has its row in verbs.hpp.

#include "suffuse/base/error.hpp"

#include "apps/command_line.hpp"
#include "apps/console.hpp"
#include "apps/options.hpp"
#include <string>
#include <utility>

namespace suffuse::apps {

class Verb {
public:
    /// @param text one line for the help
    Verb(std::string name, std::string text, std::string example)
        : name_(std::move(name)), text_(std::move(text)), example_(std::move(example)) {}

    Verb(const Verb&) = delete; // the parser knows where its options are
    Verb& operator=(const Verb&) = delete;
    virtual ~Verb() = default;

    [[nodiscard]] const std::string& name() const { return name_; }

    [[nodiscard]] const std::string& text() const { return text_; }

    [[nodiscard]] const std::string& example() const { return example_; }

    /// Describes its options, which are members with their defaults.
    virtual void add_to(Options&) {}

    /// Reports wrong use that a single option does not show, before anything else is looked at. @throws UsageError.
    virtual void check() const {}

    /// What is to be printed at once, for a verb that describes the program itself; empty: it acts.
    [[nodiscard]] virtual std::string printed(const CLI::App&) const { return {}; }

    /// Does it. @return the exit code. @throws UsageError, and the errors of the library.
    [[nodiscard]] virtual int act(const CommandLine&, const Console&) const {
        throw Bug("a verb that neither prints nor acts: " + name_);
    }

private:
    std::string name_, text_, example_;
};

} // namespace suffuse::apps
