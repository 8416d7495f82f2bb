#include "suffuse/io/checkpoint.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/state_hash.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/contact/carry_over.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/io/hdf5_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace suffuse::io {
namespace {

constexpr std::int64_t schema = 1; // raised when a name or a meaning changes
const std::string kind = "suffuse state";
const std::string unfinished_bytes = "unfinished", unfinished_hash = "unfinished_hash";
const std::string last_stress = "servo/stress"; // states of before the servo answered to it do not hold it
// States of before shear stresses could be released do not hold these.
const std::string shear_modulus_name = "servo/shear_modulus", shear_stress_name = "servo/shear_stress";

// Each list below binds every member of its struct by name: a new member stops the compiler until it is saved too.

template <class Table, class Visit>
void list_grains(Table& table, Visit&& visit) {
    auto& [position, velocity, spin, force, torque, radius, mass, inertia, id, motion, fine] = table;
    visit("grains/position", "m", position);
    visit("grains/velocity", "m/s", velocity);
    visit("grains/spin", "rad/s", spin);
    visit("grains/force", "N", force);
    visit("grains/torque", "N m", torque);
    visit("grains/radius", "m", radius);
    visit("grains/mass", "kg", mass);
    visit("grains/inertia", "kg m2", inertia);
    visit("grains/id", "", id);
    visit("grains/motion", "0 free, 1 held", motion);
    visit("grains/fine", "", fine);
}

template <class Whole, class Part>
using LikeConst = std::conditional_t<std::is_const_v<Whole>, const Part, Part>;

template <class Table, class Visit>
void list_contacts(Table& table, Visit&& visit) {
    LikeConst<Table, contact::ContactPairs>& pairs = table;
    LikeConst<Table, contact::MemoryOf<double>>& memory = table;
    auto& [first, second, image] = pairs;
    auto& [shear_force, bending, normal, overlap, twisting, bonded] = memory;
    visit("contacts/first", "row of grains", first);
    visit("contacts/second", "row of grains", second);
    visit("contacts/image", "periods", image);
    visit("contacts/shear_force", "N", shear_force);
    visit("contacts/bending", "N m", bending);
    visit("contacts/normal", "", normal);
    visit("contacts/overlap", "m", overlap);
    visit("contacts/twisting", "N m", twisting);
    visit("contacts/bonded", "", bonded);
}

/// All but the contacts, which a file holds without the rows that carry no memory.
template <class State, class Visit>
void list_world(State& world, Visit&& visit) {
    auto& [cell, reference_h, grains, material, contacts, servo, clock, seed] = world;
    auto& [h, velocity_gradient] = cell;
    auto& [modulus, stress, held_stress, mean_stress, mean_rate, shear_modulus, shear_stress] = servo;
    auto& [step, time] = clock;
    visit("cell/h", "m", h);
    visit("cell/velocity_gradient", "1/s", velocity_gradient);
    visit("cell/reference_h", "m", reference_h);
    visit("servo/modulus", "Pa", modulus);
    visit(last_stress, "Pa", stress);
    visit("servo/held_stress", "Pa", held_stress);
    visit("servo/mean_stress", "Pa", mean_stress);
    visit("servo/mean_rate", "1/s", mean_rate);
    visit(shear_modulus_name, "Pa", shear_modulus);
    visit(shear_stress_name, "Pa", shear_stress);
    visit("clock/step", "", step);
    visit("clock/time", "s", time);
    visit("seed", "", seed);
    grains::list_members(material, [&](const grains::Member& member, auto& value) {
        visit(std::string("material/") + member.name, member.unit, value, member.is_newer);
    });
    list_grains(grains, visit);
}

/// Writes each member as the array it is.
class Saver {
public:
    explicit Saver(Hdf5Writer& file) : file_(file) {}

    template <class T>
    void operator()(const std::string& name, const std::string& unit, const T& number, bool = false) {
        file_.write(name, {}, &number, unit);
    }

    void operator()(const std::string& name, const std::string& unit, const grains::ContactLaw& law, bool) {
        (*this)(name, unit, static_cast<std::uint8_t>(law));
    }

    void operator()(const std::string& name, const std::string& unit, const Vec3& v) {
        file_.write(name, {3}, &v.x, unit);
    }

    void operator()(const std::string& name, const std::string& unit, const Mat3& m) {
        file_.write(name, {3, 3}, m.m[0].data(), unit);
    }

    template <class T>
    void operator()(const std::string& name, const std::string& unit, const std::vector<T>& column) {
        file_.write(name, {column.size()}, column.data(), unit);
    }

    void operator()(const std::string& name, const std::string& unit, const std::vector<grains::Motion>& column) {
        std::vector<std::uint8_t> plain;
        std::ranges::transform(column, std::back_inserter(plain), [](auto m) { return static_cast<std::uint8_t>(m); });
        (*this)(name, unit, plain);
    }

    void operator()(const std::string& name, const std::string& unit, const std::vector<Vec3>& column) {
        static_assert(sizeof(Vec3) == 3 * sizeof(double) && std::is_standard_layout_v<Vec3>);
        file_.write(name, {column.size(), 3}, reinterpret_cast<const double*>(column.data()), unit);
    }

    void operator()(const std::string& name, const std::string& unit, const std::vector<cell::Image>& column) {
        std::vector<std::int32_t> periods;
        for (const cell::Image& image : column) {
            periods.insert(periods.end(), {image.a, image.b, image.c});
        }
        file_.write(name, {column.size(), 3}, periods.data(), unit);
    }

    void operator()(const std::string& name, const std::string& unit, const contact::VectorColumn& column) {
        std::vector<Vec3> rows(column.size());
        for (std::size_t c = 0; c < rows.size(); ++c) {
            rows[c] = column[c];
        }
        (*this)(name, unit, rows);
    }

private:
    Hdf5Writer& file_;
};

/// Reads each member back, and refuses arrays of another shape.
class Loader {
public:
    explicit Loader(const Hdf5Reader& file) : file_(file) {}

    /// @param is_newer states of before do not hold it: their world has the default
    template <class T>
    void operator()(const std::string& name, const std::string&, T& number, bool is_newer = false) {
        if (!is_newer || file_.has(name)) {
            number = values<T>(name, {}).front();
        }
    }

    void operator()(const std::string& name, const std::string& unit, grains::ContactLaw& law, bool is_newer) {
        auto number = static_cast<std::uint8_t>(law);
        (*this)(name, unit, number, is_newer);
        if (number >= contact::springs.size()) {
            std::vector<std::string> known;
            for (const contact::Spring& spring : contact::springs) {
                known.push_back(fmt::format("{} ({})", static_cast<int>(spring.law), spring.words.name));
            }
            file_.complain(fmt::format("{} holds {}, expected {}", name, number, fmt::join(known, " or ")));
        }
        law = static_cast<grains::ContactLaw>(number);
    }

    void operator()(const std::string& name, const std::string&, Vec3& v) {
        const bool is_newer = name == last_stress || name == shear_modulus_name || name == shear_stress_name;
        if (!is_newer || file_.has(name)) {
            v = vector(values<double>(name, {3}), 0);
        }
    }

    void operator()(const std::string& name, const std::string&, Mat3& m) {
        const auto found = values<double>(name, {3, 3});
        for (std::size_t k = 0; k < found.size(); ++k) {
            m.m[k / 3][k % 3] = found[k];
        }
    }

    template <class T>
    void operator()(const std::string& name, const std::string&, std::vector<T>& column) {
        column = values<T>(name, {rows(name)});
    }

    void operator()(const std::string& name, const std::string&, std::vector<grains::Motion>& column) {
        for (const std::uint8_t m : values<std::uint8_t>(name, {rows(name)})) {
            if (m > static_cast<std::uint8_t>(grains::Motion::Held)) {
                file_.complain(fmt::format("{} holds {}, expected 0 or 1", name, m));
            }
            column.push_back(static_cast<grains::Motion>(m));
        }
    }

    void operator()(const std::string& name, const std::string&, std::vector<Vec3>& column) {
        const auto found = values<double>(name, {rows(name), 3});
        column.resize(found.size() / 3);
        for (std::size_t k = 0; k < column.size(); ++k) {
            column[k] = vector(found, k);
        }
    }

    void operator()(const std::string& name, const std::string&, std::vector<cell::Image>& column) {
        const auto found = values<std::int32_t>(name, {rows(name), 3});
        for (std::size_t k = 0; k < found.size(); k += 3) {
            column.push_back({found[k], found[k + 1], found[k + 2]});
        }
    }

    void operator()(const std::string& name, const std::string& unit, contact::VectorColumn& column) {
        std::vector<Vec3> found;
        (*this)(name, unit, found);
        for (const Vec3& v : found) {
            column.push_back(v);
        }
    }

private:
    [[nodiscard]] std::size_t rows(const std::string& name) const {
        const Shape shape = file_.shape(name);
        return shape.empty() ? 0 : shape.front();
    }

    template <class T>
    [[nodiscard]] std::vector<T> values(const std::string& name, const Shape& expected) const {
        const Shape found = file_.shape(name);
        if (found != expected) {
            file_.complain(fmt::format("{} has another shape than expected", name));
        }
        return file_.read<T>(name);
    }

    static Vec3 vector(const std::vector<double>& values, std::size_t k) {
        return {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
    }

    const Hdf5Reader& file_;
};

/// What the rest of the program takes for granted of a world's tables.
void check_tables(const Hdf5Reader& file, const dem::World& world) {
    const std::size_t grains = world.grains.size(), contacts = world.contacts.size();
    list_grains(world.grains, [&](const char* name, const char*, const auto& column) {
        if (column.size() != grains) {
            file.complain(fmt::format("{} has {} rows, expected {}", name, column.size(), grains));
        }
    });
    list_contacts(world.contacts, [&](const std::string& name, const char*, const auto& column) {
        const bool optional = name == "contacts/twisting" || name == "contacts/bonded";
        if (column.size() != contacts && !(optional && column.size() == 0)) {
            file.complain(fmt::format("{} has {} rows, expected {}", name, column.size(), contacts));
        }
    });
    for (std::size_t c = 0; c < contacts; ++c) {
        if (world.contacts.first[c] >= grains || world.contacts.second[c] >= grains) {
            file.complain(fmt::format(
                "contact {} is between grains {} and {}, but there are {} grains", c, world.contacts.first[c],
                world.contacts.second[c], grains
            ));
        }
    }
}

std::uint64_t hash_of(std::span<const std::uint8_t> bytes) {
    StateHash hash;
    hash.add(bytes);
    return hash.value();
}

/// Anything may stand in these bytes, so that damage would pass for what a stage did; states of before have no hash.
std::vector<std::uint8_t> read_unfinished(const Hdf5Reader& file) {
    if (!file.has(unfinished_bytes)) {
        return {};
    }
    std::vector<std::uint8_t> bytes = file.read<std::uint8_t>(unfinished_bytes);
    if (file.has(unfinished_hash) &&
        file.read<std::uint64_t>(unfinished_hash) != std::vector<std::uint64_t>{hash_of(bytes)}) {
        file.complain("what its stage needs to go on was changed or damaged");
    }
    return bytes;
}

void write_world(
    Hdf5Writer& file, const dem::World& world, const Attributes& attributes, const Attributes& made_by,
    std::span<const std::uint8_t> unfinished
) {
    Attributes origin = made_by;
    origin.insert({{"program", std::string("suffuse ") + version()}, {"commit", commit()}});
    origin.emplace("seed", std::to_string(world.seed));
    for (const auto& [name, text] : origin) {
        file.write_attribute(name, text);
    }
    file.write_text("kind", kind);
    file.write("schema", {}, &schema, "");
    for (const auto& [name, text] : attributes) {
        expects(!name.empty() && name.find('/') == std::string::npos, "an attribute's name holds no slash");
        expects(text.find('\0') == std::string::npos, "an attribute's text holds no zero byte");
        file.write_text("attributes/" + name, text);
    }
    if (!unfinished.empty()) {
        file.write(unfinished_bytes, {unfinished.size()}, unfinished.data(), "CBOR");
        const std::uint64_t hash = hash_of(unfinished);
        file.write(unfinished_hash, {}, &hash, "");
    }
    Saver save(file);
    list_world(world, save);
    const contact::Contacts touching = contact::touching_rows(world.contacts);
    list_contacts(touching, save);
}

Checkpoint read_world(const Hdf5Reader& file) {
    if (!file.has("kind") || !file.has("schema") || file.read_text("kind") != kind) {
        file.complain("it is not a state saved by suffuse");
    }
    if (!file.shape("schema").empty()) {
        file.complain("its schema is not one number");
    }
    const std::int64_t found = file.read<std::int64_t>("schema").front();
    if (found != schema) {
        file.complain(
            fmt::format("it is of schema {}, this program reads {}; use the version that wrote it", found, schema)
        );
    }
    Checkpoint checkpoint;
    list_world(checkpoint.world, Loader(file));
    if (!file.has(last_stress)) {
        checkpoint.world.servo.modulus = {}; // it looks anew
    }
    list_contacts(checkpoint.world.contacts, Loader(file));
    check_tables(file, checkpoint.world);
    for (const std::string& name : file.names("attributes")) {
        checkpoint.attributes[name] = file.read_text("attributes/" + name);
    }
    checkpoint.unfinished = read_unfinished(file);
    checkpoint.is_hashed = file.has_digest();
    return checkpoint;
}

} // namespace

void save_world(
    const std::filesystem::path& path, const dem::World& world, const Attributes& attributes, const Attributes& made_by,
    std::span<const std::uint8_t> unfinished
) {
    Hdf5Writer file;
    write_world(file, world, attributes, made_by, unfinished);
    file.save(path);
}

Checkpoint load_world(const std::filesystem::path& path) {
    return read_world(Hdf5Reader(path));
}

std::string origin_of(const std::filesystem::path& path, const std::string& name) {
    try {
        return Hdf5Reader(path).attribute(name);
    } catch (const IoError&) {
        return "";
    }
}

std::string world_to_bytes(const dem::World& world) {
    Hdf5Writer file;
    write_world(file, world, {}, {}, {});
    return std::string(file.image());
}

dem::World world_from_bytes(std::string_view bytes) {
    return read_world(Hdf5Reader(bytes, "the bytes of a state")).world;
}

} // namespace suffuse::io
