#include "suffuse/contact/carry_over.hpp"

#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace suffuse::contact {
namespace {

constexpr std::uint32_t no_source = 0xffffffffU;

struct Source {
    std::uint32_t row; ///< of the old table, or no_source
    float sign;        ///< -1 where the two grains changed places
};

neighbors::Pair pair_of(const ContactPairs& contacts, std::size_t c) {
    return {contacts.first[c], contacts.second[c], contacts.image[c]};
}

/// A run of rows of the table to be, and the rows that their memory comes from.
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
};

/// Consecutive runs of rows, and where each begins in the table to be.
class Runs {
public:
    explicit Runs(std::vector<NewRows> runs) : runs_(std::move(runs)) {
        for (const NewRows& run : runs_) {
            begin_.push_back(rows_);
            rows_ += run.source.size();
        }
    }

    template <class Real>
    void put_into(ContactPairs& table, MemoryOf<Real>& memory, const OptionalMemory& optional) const {
        table.first.resize(rows_);
        table.second.resize(rows_);
        table.image.resize(rows_);
        for_each([&](const NewRows& run, std::size_t begin) {
            const auto at = static_cast<std::ptrdiff_t>(begin);
            std::ranges::copy(run.first, table.first.begin() + at);
            std::ranges::copy(run.second, table.second.begin() + at);
            std::ranges::copy(run.image, table.image.begin() + at);
        });
        std::vector<Real> spare; // lends its storage to one column after the other
        rearrange(memory.shear_force, spare);
        rearrange(memory.bending, spare);
        rearrange(memory.normal, spare);
        rearrange(memory.overlap, false, spare);
        if (optional.twisting) {
            rearrange(memory.twisting, spare);
        } else {
            memory.twisting.clear();
        }
        std::vector<std::uint8_t> bonded;
        if (optional.bonds) {
            rearrange(memory.bonded, false, bonded);
        } else {
            memory.bonded = {};
        }
    }

private:
    template <class Visit>
    void for_each(Visit&& visit) const {
        parallel_for(runs_.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t r = first; r < last; ++r) {
                visit(runs_[r], begin_[r]);
            }
        });
    }

    /// Takes the values of a column from their sources, zero where there is none; `odd` ones with the sign.
    template <class Value>
    void rearrange(std::vector<Value>& column, bool odd, std::vector<Value>& spare) const {
        spare.resize(rows_);
        for_each([&](const NewRows& run, std::size_t begin) {
            for (std::size_t k = 0; k < run.source.size(); ++k) {
                const auto [row, sign] = run.source[k];
                const Value old = row == no_source || column.empty() ? Value{} : column[row];
                spare[begin + k] = odd && sign < 0 ? -old : old;
            }
        });
        std::swap(column, spare);
    }

    template <class Real>
    void rearrange(VectorColumnOf<Real>& column, std::vector<Real>& spare) const {
        rearrange(column.x, true, spare);
        rearrange(column.y, true, spare);
        rearrange(column.z, true, spare);
    }

    std::vector<NewRows> runs_;
    std::vector<std::size_t> begin_;
    std::size_t rows_ = 0;
};

/// The wanted pairs of the first grains `begin` to `end`, and those of the rows `row` to `last_row` that touch.
template <class Real>
NewRows merge(
    const ContactPairs& table, const MemoryOf<Real>& memory, std::size_t row, std::size_t last_row,
    const neighbors::PairList& pairs, std::size_t begin, std::size_t end, std::span<const std::uint8_t> wanted
) {
    NewRows rows;
    const std::size_t first_pair = pairs.start_of(begin), seen = pairs.start_of(end) - first_pair;
    rows.reserve(
        wanted.empty() ? seen : static_cast<std::size_t>(std::ranges::count(wanted.subspan(first_pair, seen), 1))
    );
    const auto keep_touching_before = [&](auto&& is_before) {
        for (; row < last_row && is_before(pair_of(table, row)); ++row) {
            if (memory.touches(row)) {
                rows.append(pair_of(table, row), {static_cast<std::uint32_t>(row), 1});
            }
        }
    };
    pairs.for_each_of(begin, end, [&](std::size_t k, const neighbors::Pair& pair) {
        if (!wanted.empty() && wanted[k] == 0) {
            return;
        }
        keep_touching_before([&](const neighbors::Pair& other) { return other < pair; });
        const bool known = row < last_row && pair_of(table, row) == pair;
        rows.append(pair, {known ? static_cast<std::uint32_t>(row++) : no_source, 1});
    });
    keep_touching_before([](const neighbors::Pair&) { return true; });
    return rows;
}

/// The table of these rows, whose memory `sources` has.
Contacts table_of(NewRows rows, Contacts sources) {
    const OptionalMemory optional = optional_memory(sources);
    std::vector<NewRows> one_run;
    one_run.push_back(std::move(rows));
    Runs(std::move(one_run)).put_into(sources, sources, optional);
    return sources;
}

} // namespace

template <class Real>
void carry_over(
    ContactPairs& table, MemoryOf<Real>& memory, const neighbors::PairList& pairs, std::span<const std::uint8_t> wanted,
    const OptionalMemory& optional
) {
    // A run of the table for each run of first grains, the last one to the table's end.
    constexpr std::size_t run_grains = 1024;
    std::vector<NewRows> runs(std::max<std::size_t>(1, (pairs.grains() + run_grains - 1) / run_grains));
    parallel_for(runs.size(), 1, [&](std::size_t first, std::size_t last) {
        const auto start = [&](std::size_t run) {
            const auto row = std::ranges::lower_bound(table.first, run * run_grains);
            return run == runs.size() ? table.size() : static_cast<std::size_t>(row - table.first.begin());
        };
        for (std::size_t r = first; r < last; ++r) {
            const std::size_t begin = r * run_grains, end = std::min(pairs.grains(), begin + run_grains);
            runs[r] = merge(table, memory, start(r), start(r + 1), pairs, begin, end, wanted);
        }
    });
    Runs(std::move(runs)).put_into(table, memory, optional);
}

template void
carry_over(ContactPairs&, MemoryOf<double>&, const neighbors::PairList&, std::span<const std::uint8_t>, const OptionalMemory&);
template void
carry_over(ContactPairs&, MemoryOf<float>&, const neighbors::PairList&, std::span<const std::uint8_t>, const OptionalMemory&);

void carry_over(
    Contacts& table, const neighbors::PairList& pairs, std::span<const std::uint8_t> wanted,
    const OptionalMemory& optional
) {
    carry_over(table, table, pairs, wanted, optional);
}

Contacts touching_rows(const Contacts& contacts) {
    Contacts table = contacts;
    carry_over(table, {}, {}, optional_memory(contacts));
    return table;
}

Contacts chosen_rows(const Contacts& contacts, std::span<const std::uint8_t> chosen) {
    NewRows rows;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (chosen[c] != 0) {
            rows.append(pair_of(contacts, c), {static_cast<std::uint32_t>(c), 1});
        }
    }
    return table_of(std::move(rows), contacts);
}

Contacts joined(const Contacts& some, const Contacts& others) {
    Contacts all = some;
    const std::size_t rows = some.size() + others.size();
    const auto extend = [&](auto& column, const auto& more, bool is_there = true) {
        column.resize(is_there ? some.size() : 0);
        column.insert(column.end(), more.begin(), more.end());
        column.resize(is_there ? rows : 0);
    };
    const auto extend_vectors = [&](VectorColumn& column, const VectorColumn& more, bool is_there = true) {
        extend(column.x, more.x, is_there);
        extend(column.y, more.y, is_there);
        extend(column.z, more.z, is_there);
    };
    const OptionalMemory a = optional_memory(some), b = optional_memory(others);
    extend(all.first, others.first);
    extend(all.second, others.second);
    extend(all.image, others.image);
    extend(all.overlap, others.overlap);
    extend_vectors(all.shear_force, others.shear_force);
    extend_vectors(all.bending, others.bending);
    extend_vectors(all.normal, others.normal);
    extend_vectors(all.twisting, others.twisting, a.twisting || b.twisting);
    extend(all.bonded, others.bonded, a.bonds || b.bonds);
    std::vector<std::uint32_t> order(rows);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t c, std::uint32_t d) { return pair_of(all, c) < pair_of(all, d); });
    NewRows sorted;
    sorted.reserve(rows);
    for (const std::uint32_t c : order) {
        sorted.append(pair_of(all, c), {c, 1});
    }
    return table_of(std::move(sorted), std::move(all));
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
    return table_of(std::move(rows), contacts);
}

} // namespace suffuse::contact
