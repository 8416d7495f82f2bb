#include "apps/options.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/io/text_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <functional>
#include <optional>

namespace suffuse::apps {
namespace {

/// Empty where `text` is a number from `least` to `most`, else what it should be: CLI11's own words have all the digits
/// of the largest number there is.
template <class T>
std::string complaint_of_range(const std::string& text, T least, T most, const std::string& expected) {
    const std::optional<T> value = io::number_of<T>(text);
    const bool is_good = value && *value >= least && *value <= most;
    return is_good ? "" : fmt::format("{} is not {}", text, expected);
}

std::string take_ratio(std::string& text, double least, double most, const std::string& expected) {
    try {
        text = fmt::format("{}", parse_quantity(text, dimension::none));
    } catch (const UnitError& problem) {
        const bool is_number = !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) != 0;
        return is_number ? fmt::format("{}; {}", problem.what(), problem.help)
                         : fmt::format("{} is not {}", text, expected);
    }
    return complaint_of_range(text, least, most, expected);
}

/// Takes every text: its words stand in the type of the option, as those of CLI::IsMember do.
struct Suggestion : CLI::Validator {
    explicit Suggestion(const std::function<std::vector<std::string>()>& words) {
        desc_function_ = [words] { return fmt::format("{{{}}}", fmt::join(words(), ",")); };
    }
};

} // namespace

Option& Option::type(const std::string& name) {
    option_->type_name(name);
    return *this;
}

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
    option_->check(CLI::IsMember(words));
    return *this;
}

Option& Option::suggest(const std::vector<std::string>& words) {
    option_->check(Suggestion([words] { return words; }));
    return *this;
}

Option& Option::suggest(std::vector<std::string> (*words)()) {
    option_->check(Suggestion(words));
    return *this;
}

Option& Option::whole_number(std::int64_t least, std::int64_t most) {
    const std::string expected = fmt::format("a whole number from {} to {}", least, most);
    option_->check(CLI::Validator(
        [=](std::string& text) { return complaint_of_range(text, least, most, expected); }, std::string()
    ));
    return *this;
}

Option& Option::not_negative() {
    option_->check(CLI::Validator(
        [](std::string& text) {
            return complaint_of_range(text, 0.0, std::numeric_limits<double>::max(), "a number of 0 or more");
        },
        std::string()
    ));
    return *this;
}

Option& Option::ratio(double least, double most) {
    const std::string expected = most < std::numeric_limits<double>::max()
                                     ? fmt::format("a number from {} to {}, or as in {:.4g}%", least, most, 50 * most)
                                     : fmt::format("a number of {} or more, or as in 30%", least);
    option_->transform(
        CLI::Validator([=](std::string& text) { return take_ratio(text, least, most, expected); }, std::string())
    );
    return *this;
}

Option& Option::needs(const Option& other) {
    option_->needs(other.option_);
    return *this;
}

Option& Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}

Option& Option::of_group(const std::string& text) {
    option_->group(text);
    return *this;
}

Option Options::argument(const std::string& name, std::string& value, const std::string& text) {
    return Option(verb_->add_option(name, value, text));
}

Option Options::arguments(const std::string& name, std::vector<std::string>& values, const std::string& text) {
    return Option(verb_->add_option(name, values, text));
}

template <class T>
Option Options::value(const std::string& names, T& value, const std::string& text) {
    return Option(verb_->add_option(names, value, text));
}

template Option Options::value(const std::string&, std::string&, const std::string&);
template Option Options::value(const std::string&, int&, const std::string&);
template Option Options::value(const std::string&, std::int64_t&, const std::string&);
template Option Options::value(const std::string&, double&, const std::string&);
template Option Options::value(const std::string&, std::optional<std::int64_t>&, const std::string&);
template Option Options::value(const std::string&, std::optional<double>&, const std::string&);

Option Options::values(const std::string& names, std::vector<std::string>& values, const std::string& text) {
    return Option(verb_->add_option(names, values, text)->expected(1)->take_all()->allow_extra_args(false));
}

Option Options::flag(const std::string& names, bool& is_given, const std::string& text) {
    return Option(verb_->add_flag(names, is_given, text));
}

Options Options::below(const std::string& name, const std::string& text, const std::string& example) const {
    CLI::App* const verb = verb_->add_subcommand(name, text);
    verb->footer(example);
    return Options(*verb);
}

void Options::keep_choice(std::string& chosen) {
    verb_->callback([verb = verb_, &chosen] { chosen = verb->get_name(); });
}

} // namespace suffuse::apps
