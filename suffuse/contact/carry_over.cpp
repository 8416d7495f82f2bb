#include "suffuse/contact/carry_over.hpp"

#include <algorithm>

namespace suffuse::contact {
namespace {

constexpr std::uint32_t no_source = 0xffffffffU;

struct Source {
    std::uint32_t row; ///< of the old table, or no_source
    float sign;        ///< -1 where the two grains changed places
};

/// Rearranges a column in place; `spare` lends its storage.
void rearrange(std::vector<double>& column, const std::vector<Source>& sources, bool odd, std::vector<double>& spare) {
    spare.resize(sources.size());
    for (std::size_t c = 0; c < sources.size(); ++c) {
        const auto [row, sign] = sources[c];
        spare[c] = row == no_source || column.empty() ? 0.0 : (odd ? sign * column[row] : column[row]);
    }
    std::swap(column, spare);
}

void rearrange(VectorColumn& column, const std::vector<Source>& sources, std::vector<double>& spare) {
    rearrange(column.x, sources, true, spare);
    rearrange(column.y, sources, true, spare);
    rearrange(column.z, sources, true, spare);
}

/// Gives `table`, whose pairs are already the new ones, the memory of the rows that they come from.
void rearrange_memory(Contacts& table, const std::vector<Source>& sources, const OptionalMemory& memory) {
    std::vector<double> spare;
    rearrange(table.shear_force, sources, spare);
    rearrange(table.bending, sources, spare);
    rearrange(table.normal, sources, spare);
    rearrange(table.overlap, sources, false, spare);
    if (memory.twisting) {
        rearrange(table.twisting, sources, spare);
    } else {
        table.twisting.clear();
    }
    std::vector<std::uint8_t> bonded(memory.bonds ? sources.size() : 0);
    for (std::size_t c = 0; c < bonded.size(); ++c) {
        const std::uint32_t row = sources[c].row;
        bonded[c] = row == no_source || table.bonded.empty() ? std::uint8_t{0} : table.bonded[row];
    }
    table.bonded = std::move(bonded);
}

neighbors::Pair pair_of(const Contacts& contacts, std::size_t c) {
    return {contacts.first[c], contacts.second[c], contacts.image[c]};
}

/// The pairs of a table to be, and the rows that their memory comes from.
struct NewRows {
    std::vector<std::uint32_t> first, second;
    std::vector<cell::Image> image;
    std::vector<Source> source;

    void reserve(std::size_t rows) {
        first.reserve(rows);
        second.reserve(rows);
        image.reserve(rows);
        source.reserve(rows);
    }

    void append(const neighbors::Pair& pair, const Source& from) {
        first.push_back(pair.first);
        second.push_back(pair.second);
        image.push_back(pair.image);
        source.push_back(from);
    }

    void move_into(Contacts& table, const OptionalMemory& memory) {
        table.first = std::move(first);
        table.second = std::move(second);
        table.image = std::move(image);
        rearrange_memory(table, source, memory);
    }
};

} // namespace

OptionalMemory optional_memory(const Contacts& contacts) {
    return {contacts.twisting.size() > 0, !contacts.bonded.empty()};
}

void carry_over(
    Contacts& table, const neighbors::PairList& pairs, std::span<const std::uint8_t> wanted,
    const OptionalMemory& memory
) {
    NewRows rows;
    rows.reserve(
        wanted.empty() ? pairs.size() : wanted.size() - static_cast<std::size_t>(std::ranges::count(wanted, 0))
    );
    std::size_t c = 0;
    const auto keep_touching_before = [&](auto&& is_before) {
        for (; c < table.size() && is_before(pair_of(table, c)); ++c) {
            if (table.touches(c)) {
                rows.append(pair_of(table, c), {static_cast<std::uint32_t>(c), 1});
            }
        }
    };
    pairs.for_each([&](std::size_t k, const neighbors::Pair& pair) {
        if (!wanted.empty() && wanted[k] == 0) {
            return;
        }
        keep_touching_before([&](const neighbors::Pair& other) { return other < pair; });
        const bool known = c < table.size() && pair_of(table, c) == pair;
        rows.append(pair, {known ? static_cast<std::uint32_t>(c++) : no_source, 1});
    });
    keep_touching_before([](const neighbors::Pair&) { return true; });
    rows.move_into(table, memory);
}

Contacts touching_rows(const Contacts& contacts) {
    Contacts table = contacts;
    carry_over(table, {}, {}, optional_memory(contacts));
    return table;
}

Contacts renumbered(const Contacts& contacts, std::span<const std::uint32_t> new_row) {
    struct Row {
        neighbors::Pair pair;
        Source source;
    };

    std::vector<Row> sorted;
    sorted.reserve(contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::uint32_t i = new_row[contacts.first[c]], j = new_row[contacts.second[c]];
        if (i == removed_row || j == removed_row) {
            continue;
        }
        const cell::Image image = contacts.image[c];
        const auto source = static_cast<std::uint32_t>(c);
        if (i <= j) {
            sorted.push_back({{i, j, image}, {source, 1}});
        } else {
            sorted.push_back({{j, i, -image}, {source, -1}});
        }
    }
    std::sort(sorted.begin(), sorted.end(), [](const Row& a, const Row& b) { return a.pair < b.pair; });
    NewRows rows;
    for (const Row& row : sorted) {
        rows.append(row.pair, row.source);
    }
    Contacts table = contacts;
    rows.move_into(table, optional_memory(contacts));
    return table;
}

} // namespace suffuse::contact
