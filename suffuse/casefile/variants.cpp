#include "suffuse/casefile/variants.hpp"

#include "suffuse/base/state_hash.hpp"
#include "suffuse/casefile/row_fields.hpp"
#include "suffuse/casefile/sweep_value.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::casefile {

namespace {

bool is_chosen(const Stage& stage, const std::map<std::string, Scalar>& values) {
    return std::all_of(stage.only.begin(), stage.only.end(), [&](const Sweep& only) {
        const auto found = values.find(only.key);
        return found != values.end() && std::any_of(only.values.begin(), only.values.end(), [&](const Scalar& value) {
                   return same_value(value, found->second);
               });
    });
}

} // namespace

bool same_value(const Scalar& a, const Scalar& b) {
    const std::optional<Quantity> x = quantity_of(a), y = quantity_of(b);
    return a == b || (x && y && x->value == y->value && x->dimension == y->dimension);
}

std::string short_name(const std::string& key) {
    return key == "fines_content" ? "fc" : key.substr(key.rfind('.') + 1);
}

std::string folder_of(const std::string& key, const Scalar& value) {
    std::string text = print_value(make_node(value));
    if (key == "fines_content") {
        const std::optional<Quantity> share = quantity_of(value);
        if (share && share->dimension == dimension::none) { // otherwise reported where the soil is read
            text = fmt::format("{:.6g}", share->value * 100);
        }
    }
    std::string plain;
    for (const char c : text) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_';
        if (is_plain) {
            plain += c;
        }
        if (c == '%') {
            plain += "pct";
        }
    }
    return short_name(key) + "=" + plain;
}

std::size_t count_variants(const Study& study) {
    constexpr std::size_t countless = 1'000'000'000;
    std::size_t count = static_cast<std::size_t>(study.replicates);
    for (const Sweep& sweep : study.sweep) {
        count = std::min(countless, count * sweep.values.size());
    }
    return count;
}

std::vector<Variant> list_variants(const Study& study, std::uint64_t seed) {
    Variant first;
    first.folder = study.name;
    std::vector<Variant> list{first};
    for (const Sweep& sweep : study.sweep) {
        std::vector<Variant> longer;
        for (const Variant& variant : list) {
            for (const Scalar& value : sweep.values) {
                longer.push_back(variant);
                longer.back().values[sweep.key] = value;
                longer.back().folder += fmt::format("/{}", folder_of(sweep.key, value));
            }
        }
        list = std::move(longer);
    }
    std::vector<Variant> all;
    for (Variant& variant : list) {
        variant.values.merge(values_of_row(study, variant.values));
        const auto swept = variant.values.find("seed");
        const auto* own = swept == variant.values.end() ? nullptr : std::get_if<std::int64_t>(&swept->second);
        const std::uint64_t base = own == nullptr ? seed : static_cast<std::uint64_t>(*own);
        for (int replicate = 1; replicate <= study.replicates; ++replicate) {
            all.push_back(variant);
            all.back().replicate = replicate;
            if (study.replicates > 1) {
                all.back().folder += fmt::format("/rep={}", replicate);
            }
            StateHash mixed;
            mixed.add(base);
            mixed.add(replicate);
            all.back().seed = replicate == 1 ? base : mixed.value();
        }
    }
    return all;
}

std::vector<Stage> chosen_stages(const std::vector<Stage>& stages, const std::map<std::string, Scalar>& values) {
    std::vector<Stage> chosen;
    std::vector<int> row(stages.size(), -1); // of the stage that ends in the state that this one would leave
    for (std::size_t k = 0; k < stages.size(); ++k) {
        const int parent = stages[k].parent < 0 ? -1 : row[static_cast<std::size_t>(stages[k].parent)];
        if (!is_chosen(stages[k], values)) {
            row[k] = parent;
            continue;
        }
        row[k] = static_cast<int>(chosen.size());
        chosen.push_back(stages[k]);
        chosen.back().parent = parent;
    }
    return chosen;
}

Place place_in_sweep(const Node& list, const Scalar& value) {
    for (const Node& item : list.items) {
        if (item.is_scalar() && scalar_of(item) == value) {
            return item.place;
        }
    }
    return list.place;
}

} // namespace suffuse::casefile
