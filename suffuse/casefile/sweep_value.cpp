#include "suffuse/casefile/sweep_value.hpp"

#include "suffuse/casefile/node.hpp"

namespace suffuse::casefile {

std::optional<Quantity> quantity_of(const Scalar& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
        try {
            return parse_quantity(*text);
        } catch (const UnitError&) {
            return std::nullopt;
        }
    }
    if (const auto* integer = std::get_if<std::int64_t>(&value)) {
        return Quantity{static_cast<double>(*integer), dimension::none, false};
    }
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? std::optional(Quantity{*number, dimension::none, false}) : std::nullopt;
}

std::string written(const Scalar& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? *text : print_value(make_node(value));
}

} // namespace suffuse::casefile
