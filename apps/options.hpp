#pragma once
// How a verb says which arguments and flags it has. The parser's own header takes five seconds to compile, and only
// what reads the command line or describes it as a whole includes that one.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
class Option;
} // namespace CLI

namespace suffuse::apps {

/// An argument or a flag, and which values it takes.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option& type(const std::string& name); ///< what stands for its value in the help
    Option& required();
    Option& one_of(const std::vector<std::string>& words);
    /// Words that a shell may complete; others are taken, too. The function is called where they are needed.
    Option& suggest(const std::vector<std::string>& words);
    Option& suggest(std::vector<std::string> (*words)());
    Option& whole_number(std::int64_t least, std::int64_t most);
    Option& not_negative();
    /// As a case has them: a bare number, one with %, or a quotient. "30%" and "3m/10m" become "0.3".
    Option& ratio(double least, double most = std::numeric_limits<double>::max());
    Option& needs(const Option& other);
    Option& excludes(const Option& other);
    Option& of_group(const std::string& text); ///< one line of the help for all options of a text

private:
    CLI::Option* option_;
};

/// What may follow a verb, in the order of the help. Values stay as they are where nothing is given; they must outlive
/// the reading of the command line.
class Options {
public:
    explicit Options(CLI::App& verb) : verb_(&verb) {}

    Option argument(const std::string& name, std::string& value, const std::string& text);
    /// One or more of a kind.
    Option arguments(const std::string& name, std::vector<std::string>& values, const std::string& text);
    /// Text, a number, or an std::optional of one (options.cpp lists them). @param names "-o,--output"
    template <class T>
    Option value(const std::string& names, T& value, const std::string& text);
    /// One that may be repeated.
    Option values(const std::string& names, std::vector<std::string>& values, const std::string& text);
    Option flag(const std::string& names, bool& is_given, const std::string& text);

    /// A verb below this one.
    [[nodiscard]] Options below(const std::string& name, const std::string& text, const std::string& example) const;
    /// Puts the name of this verb into `chosen` where it is called.
    void keep_choice(std::string& chosen);

private:
    CLI::App* verb_;
};

} // namespace suffuse::apps
