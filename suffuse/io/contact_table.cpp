#include "suffuse/io/contact_table.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/io/columns.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::io {
namespace {

constexpr std::string_view header = "first,second,shear_x,shear_y,shear_z,moment_x,moment_y,moment_z";

class ContactReader {
public:
    ContactReader(const std::string& file, std::string_view text, const grains::Grains& grains)
        : reader_(file, text), grains_(grains) {}

    std::vector<dem::GivenContact> read() {
        if (!reader_.next()) {
            reader_.complain("the file is empty, expected a table of contacts");
        }
        return reader_.line().starts_with("ITEM:") ? read_dump() : read_table();
    }

private:
    [[nodiscard]] std::uint32_t row_of(std::string_view field, std::size_t counted_from) const {
        const std::size_t number = to_count(reader_, field, "grain");
        if (number < counted_from || number - counted_from >= grains_.size()) {
            reader_.complain(fmt::format(
                "found grain {}, expected {} to {}: the packing has {} grains", number, counted_from,
                grains_.size() + counted_from - 1, grains_.size()
            ));
        }
        return static_cast<std::uint32_t>(number - counted_from);
    }

    void check_fields(std::size_t found, std::size_t expected) const {
        if (found != expected) {
            reader_.complain(fmt::format("found {} fields, expected {}", found, expected));
        }
    }

    [[nodiscard]] dem::GivenContact pair_in(std::string_view a, std::string_view b, std::size_t counted_from) const {
        const dem::GivenContact pair{row_of(a, counted_from), row_of(b, counted_from), {}, {}, reader_.number()};
        if (pair.first == pair.second) {
            reader_.complain("found a grain in contact with itself, expected two");
        }
        return pair;
    }

    std::vector<dem::GivenContact> read_table() {
        if (reader_.line() != header) {
            reader_.complain(fmt::format("found \"{}\", expected the header {}", reader_.line(), header));
        }
        std::vector<dem::GivenContact> contacts;
        while (reader_.next()) {
            const auto f = split_at(reader_.line(), ',');
            check_fields(f.size(), 8);
            dem::GivenContact& contact = contacts.emplace_back(pair_in(f[0], f[1], 0));
            contact.shear_force = vector_in(reader_, f, {2, 3, 4});
            contact.moment = vector_in(reader_, f, {5, 6, 7});
        }
        return contacts;
    }

    std::vector<dem::GivenContact> read_dump() {
        std::optional<std::vector<dem::GivenContact>> last;
        std::size_t entries = 0;
        do {
            if (reader_.line().starts_with("ITEM: ENTRIES")) {
                last = read_entries(entries);
            } else if (reader_.line() == "ITEM: NUMBER OF ENTRIES" && reader_.next()) {
                entries = to_count(reader_, reader_.line(), "number of entries");
            }
        } while (reader_.next());
        if (!last) {
            reader_.complain("found no section ITEM: ENTRIES, expected one");
        }
        return *last;
    }

    [[nodiscard]] std::vector<dem::GivenContact> read_entries(std::size_t entries) {
        constexpr std::size_t needed = 11;
        const auto words = split_at_blanks(reader_.line()); // ITEM:, ENTRIES, and a name a column
        const std::size_t skipped = words.size() > 2 && words[2] == "index" ? 1 : 0;
        if (words.size() - 2 - skipped != needed) {
            reader_.complain(fmt::format(
                "found {} columns, expected {}: two atoms, shear force, rolling force and the vector between them "
                "(docs/packings.md has the commands)",
                words.size() - 2 - skipped, needed
            ));
        }
        std::vector<dem::GivenContact> contacts;
        for (std::size_t k = 0; k < entries; ++k) {
            if (!reader_.next()) {
                reader_.complain(fmt::format("the file ends, expected {} contacts, found {}", entries, k));
            }
            add_entry(contacts, skipped, needed);
        }
        return contacts;
    }

    void add_entry(std::vector<dem::GivenContact>& contacts, std::size_t at, std::size_t needed) const {
        const auto f = split_at_blanks(reader_.line());
        check_fields(f.size(), at + needed);
        dem::GivenContact contact = pair_in(f[at], f[at + 1], 1);
        contact.shear_force = vector_in(reader_, f, {at + 2, at + 3, at + 4});
        const Vec3 rolling = vector_in(reader_, f, {at + 5, at + 6, at + 7});
        const Vec3 between = vector_in(reader_, f, {at + 8, at + 9, at + 10});
        const double distance = norm(between), r1 = grains_.radius[contact.first], r2 = grains_.radius[contact.second];
        if (!(distance > 0)) {
            reader_.complain("found two atoms in one place, expected a vector between them");
        }
        contact.moment = r1 * r2 / ((r1 + r2) * distance) * cross(between, rolling);
        if (distance < r1 + r2) { // LAMMPS lists near neighbors, too
            contacts.push_back(contact);
        }
    }

    LineReader reader_;
    const grains::Grains& grains_;
};

} // namespace

void export_contacts(const std::filesystem::path& path, const dem::World& world) {
    CsvWriter table(path, header);
    for (const dem::ContactView& contact : dem::inspect_contacts(world)) {
        table.row(contact.i, contact.j, contact.shear_force, contact.moment);
    }
    table.finish();
}

std::vector<dem::GivenContact> read_contacts(const std::filesystem::path& path, const grains::Grains& grains) {
    const std::string text = read_text(path);
    return ContactReader(path.string(), text, grains).read();
}

} // namespace suffuse::io
