#pragma once
// Facts as JSON: the keys of stage.json, and the names of results.cbor and of half-done stages.

#include "suffuse/facts/fact.hpp"
#include "suffuse/record/or_null.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace suffuse::record {

/// Writes each fact of a list under its key. What is not finite, or missing, is null.
template <class Rows, class Of>
void put_facts(nlohmann::json& numbers, const Rows& rows, const Of& of) {
    facts::for_each_row(rows, [&](const auto& row) {
        if (!row.key.empty()) {
            std::string path = "/" + std::string(row.key);
            std::ranges::replace(path, '.', '/');
            nlohmann::json value = row.of(of);
            numbers[nlohmann::json::json_pointer(path)] =
                value.is_number_float() ? or_null(value.template get<double>()) : std::move(value);
        }
    });
}

template <class Rows, class Of>
nlohmann::json facts_json(const Rows& rows, const Of& of) {
    nlohmann::json numbers = nlohmann::json::object();
    put_facts(numbers, rows, of);
    return numbers;
}

/// The members of a structure to the bit, under the names that they are saved by.
template <class Rows, class Of>
void save_facts(nlohmann::json& saved, const Rows& rows, const Of& of) {
    facts::for_each_row(rows, [&]<class R>(const R& row) {
        if constexpr (R::is_member) {
            if (!row.saved.empty()) {
                saved[std::string(row.saved)] = row.of(of);
            }
        }
    });
}

/// Reads what save_facts wrote. What earlier versions did not save keeps its default.
template <class Rows, class Of>
void load_facts(const nlohmann::json& saved, const Rows& rows, Of& of) {
    facts::for_each_row(rows, [&]<class R>(const R& row) {
        if constexpr (R::is_member) {
            if (const auto found = row.saved.empty() ? saved.end() : saved.find(std::string(row.saved));
                found != saved.end()) {
                found->get_to(row.of(of));
            }
        }
    });
}

} // namespace suffuse::record
