#include "suffuse/contact/carry_over.hpp"

#include <algorithm>

namespace suffuse::contact {
namespace {

constexpr std::uint32_t no_source = 0xffffffffU;

struct Source {
    std::uint32_t row; ///< of the old table, or no_source
    double sign;       ///< -1 where the two grains changed places
};

void gather(const std::vector<double>& from, const std::vector<Source>& sources, bool odd, std::vector<double>& to) {
    to.resize(sources.size());
    for (std::size_t c = 0; c < sources.size(); ++c) {
        const auto [row, sign] = sources[c];
        to[c] = row == no_source || from.empty() ? 0.0 : (odd ? sign * from[row] : from[row]);
    }
}

void gather(const VectorColumn& from, const std::vector<Source>& sources, VectorColumn& to) {
    gather(from.x, sources, true, to.x);
    gather(from.y, sources, true, to.y);
    gather(from.z, sources, true, to.z);
}

void gather_memory(
    const Contacts& from, const std::vector<Source>& sources, const OptionalMemory& memory, Contacts& to
) {
    gather(from.shear_force, sources, to.shear_force);
    gather(from.bending, sources, to.bending);
    gather(from.normal, sources, to.normal);
    gather(from.overlap, sources, false, to.overlap);
    to.twisting.clear();
    to.bonded.clear();
    if (memory.twisting) {
        gather(from.twisting, sources, to.twisting);
    }
    if (memory.bonds) {
        to.bonded.resize(sources.size());
        for (std::size_t c = 0; c < sources.size(); ++c) {
            const std::uint32_t row = sources[c].row;
            to.bonded[c] = row == no_source || from.bonded.empty() ? std::uint8_t{0} : from.bonded[row];
        }
    }
}

neighbors::Pair pair_of(const Contacts& contacts, std::size_t c) {
    return {contacts.first[c], contacts.second[c], contacts.image[c]};
}

void clear_pairs(Contacts& table) {
    table.first.clear(), table.second.clear(), table.image.clear();
}

void append(Contacts& table, const neighbors::Pair& pair) {
    table.first.push_back(pair.first);
    table.second.push_back(pair.second);
    table.image.push_back(pair.image);
}

} // namespace

OptionalMemory optional_memory(const Contacts& contacts) {
    return {contacts.twisting.size() > 0, !contacts.bonded.empty()};
}

void carry_over(
    const Contacts& old, std::span<const neighbors::Pair> pairs, const OptionalMemory& memory, Contacts& table
) {
    clear_pairs(table);
    std::vector<Source> sources;
    sources.reserve(pairs.size() + 16);
    std::size_t c = 0;
    const auto keep_touching_before = [&](auto&& is_before) {
        for (; c < old.size() && is_before(pair_of(old, c)); ++c) {
            if (!old.touches(c)) {
                continue;
            }
            append(table, pair_of(old, c));
            sources.push_back({static_cast<std::uint32_t>(c), 1});
        }
    };
    for (const neighbors::Pair& pair : pairs) {
        keep_touching_before([&](const neighbors::Pair& other) { return other < pair; });
        const bool known = c < old.size() && pair_of(old, c) == pair;
        append(table, pair);
        sources.push_back({known ? static_cast<std::uint32_t>(c++) : no_source, 1});
    }
    keep_touching_before([](const neighbors::Pair&) { return true; });
    gather_memory(old, sources, memory, table);
}

Contacts touching_rows(const Contacts& contacts) {
    Contacts table;
    carry_over(contacts, {}, optional_memory(contacts), table);
    return table;
}

Contacts renumbered(const Contacts& contacts, std::span<const std::uint32_t> new_row) {
    struct Row {
        neighbors::Pair pair;
        Source source;
    };

    std::vector<Row> rows;
    rows.reserve(contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::uint32_t i = new_row[contacts.first[c]], j = new_row[contacts.second[c]];
        if (i == removed_row || j == removed_row) {
            continue;
        }
        const cell::Image image = contacts.image[c];
        const auto source = static_cast<std::uint32_t>(c);
        if (i <= j) {
            rows.push_back({{i, j, image}, {source, 1}});
        } else {
            rows.push_back({{j, i, cell::Image{} - image}, {source, -1}});
        }
    }
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.pair < b.pair; });
    Contacts table;
    std::vector<Source> sources;
    for (const Row& row : rows) {
        append(table, row.pair);
        sources.push_back(row.source);
    }
    gather_memory(contacts, sources, optional_memory(contacts), table);
    return table;
}

} // namespace suffuse::contact
