// A state whose arrays have other shapes, types and values than ours is refused, or is a world as the program takes it
// for granted. The bytes say what is put where; the file around them is made by HDF5, for that library's own parsing of
// damaged files is not ours to mend.

#include "suffuse/io/checkpoint.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/hdf5_file.hpp"

#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/scratch_file.hpp"
#include <array>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace {

using namespace suffuse;
using fuzz::Bytes;

/// What a good state of two grains and one contact has.
struct Array {
    std::string name;
    char type; ///< d double, l int64, L uint64, i int32, u uint32, b byte, t text
    io::Shape shape;
};

std::vector<Array> make_arrays() {
    std::vector<Array> list{
        {"kind", 't', {}},
        {"schema", 'l', {}},
        {"cell/h", 'd', {3, 3}},
        {"cell/velocity_gradient", 'd', {3, 3}},
        {"cell/reference_h", 'd', {3, 3}},
        {"servo/modulus", 'd', {}},
        {"servo/held_stress", 'd', {3}},
        {"servo/mean_stress", 'd', {3}},
        {"servo/mean_rate", 'd', {3}},
        {"clock/step", 'l', {}},
        {"clock/time", 'd', {}},
        {"seed", 'L', {}}};
    const grains::Material material;
    grains::list_members(material, [&](const grains::Member& member, const auto& value) {
        list.push_back(
            {std::string("material/") + member.name, std::is_enum_v<std::decay_t<decltype(value)>> ? 'b' : 'd', {}}
        );
    });
    const std::vector<Array> tables{
        {"grains/position", 'd', {2, 3}},  {"grains/velocity", 'd', {2, 3}}, {"grains/spin", 'd', {2, 3}},
        {"grains/force", 'd', {2, 3}},     {"grains/torque", 'd', {2, 3}},   {"grains/radius", 'd', {2}},
        {"grains/mass", 'd', {2}},         {"grains/inertia", 'd', {2}},     {"grains/id", 'u', {2}},
        {"grains/motion", 'b', {2}},       {"grains/fine", 'b', {2}},        {"contacts/first", 'u', {1}},
        {"contacts/second", 'u', {1}},     {"contacts/image", 'i', {1, 3}},  {"contacts/shear_force", 'd', {1, 3}},
        {"contacts/bending", 'd', {1, 3}}, {"contacts/normal", 'd', {1, 3}}, {"contacts/overlap", 'd', {1}},
        {"contacts/twisting", 'd', {1}},   {"contacts/bonded", 'b', {1}},    {"attributes/case", 't', {}},
        {"unfinished", 'b', {3}}};
    list.insert(list.end(), tables.begin(), tables.end());
    return list;
}

const std::vector<Array>& arrays() {
    static const std::vector<Array> list = make_arrays();
    return list;
}

template <class T>
void write_array(io::Hdf5Writer& file, const std::string& name, const io::Shape& shape, Bytes& bytes) {
    std::size_t count = 1;
    for (const std::size_t size : shape) {
        count *= size;
    }
    std::vector<T> values(count);
    for (T& value : values) {
        std::array<std::uint8_t, sizeof(T)> raw{};
        raw[0] = bytes.next();
        raw[sizeof(T) - 1] = raw[0] > 200 ? bytes.next() : 0; // mostly small numbers
        std::memcpy(&value, raw.data(), sizeof(T));
    }
    file.write(name, shape, values.data(), "m");
}

void write(io::Hdf5Writer& file, const Array& array, Bytes& bytes) {
    const std::string name(array.name);
    switch (array.type) {
    case 'd':
        return write_array<double>(file, name, array.shape, bytes);
    case 'l':
        return write_array<std::int64_t>(file, name, array.shape, bytes);
    case 'L':
        return write_array<std::uint64_t>(file, name, array.shape, bytes);
    case 'i':
        return write_array<std::int32_t>(file, name, array.shape, bytes);
    case 'u':
        return write_array<std::uint32_t>(file, name, array.shape, bytes);
    case 'b':
        return write_array<std::uint8_t>(file, name, array.shape, bytes);
    case 't':
        return file.write_text(name, name == "kind" ? "suffuse state" : std::string(bytes.next(), 'x'));
    default:
        return; // it is missing
    }
}

/// The array in another form, or one that is not there.
Array changed(Array array, Bytes& bytes) {
    constexpr std::string_view types = "dlLiubt-";
    array.type = types[bytes.next() % types.size()];
    array.shape.resize(bytes.next() % 4);
    for (std::size_t& size : array.shape) {
        size = bytes.next() % 5;
    }
    return array;
}

void check_promises(const dem::World& world) {
    const std::size_t grains = world.grains.size();
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        if (world.contacts.first[c] >= grains || world.contacts.second[c] >= grains) {
            std::abort();
        }
    }
    static_cast<void>(dem::state_hash(world));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes{data, size};
    std::vector<Array> list = arrays();
    for (int left = bytes.next() % 4; left > 0; --left) {
        Array& array = list[bytes.next() % list.size()];
        array = changed(array, bytes);
    }
    const std::string path = fuzz::scratch_file(nullptr, 0);
    {
        io::Hdf5Writer file;
        for (const Array& array : list) {
            if (array.name == "schema" && array.type == 'l' && array.shape.empty()) {
                const std::int64_t known = 1;
                file.write("schema", {}, &known, "");
            } else {
                write(file, array, bytes);
            }
        }
        file.save(path);
    }
    try {
        check_promises(io::load_world(path).world);
    } catch (const IoError&) {
    }
    return 0;
}
