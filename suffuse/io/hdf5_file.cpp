#include "suffuse/io/hdf5_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/digest_within.hpp"
#include "suffuse/io/hdf5_handle.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <numeric>
#include <string_view>
#include <type_traits>
#include <unistd.h>
#include <utility>

namespace suffuse::io {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>, "the header hides HDF5's handles as 64-bit integers");

/// One for the process, as the library is. Recursive: a thread may read one file while it makes another.
std::recursive_mutex& library_mutex() {
    static std::recursive_mutex mutex;
    return mutex;
}

/// HDF5 would print its errors; ours are thrown instead.
void keep_quiet() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

template <class T>
hid_t memory_type() {
    if constexpr (std::is_same_v<T, double>) {
        return H5T_NATIVE_DOUBLE;
    }
    if constexpr (std::is_same_v<T, std::int32_t>) {
        return H5T_NATIVE_INT32;
    }
    if constexpr (std::is_same_v<T, std::uint32_t>) {
        return H5T_NATIVE_UINT32;
    }
    if constexpr (std::is_same_v<T, std::int64_t>) {
        return H5T_NATIVE_INT64;
    }
    if constexpr (std::is_same_v<T, std::uint64_t>) {
        return H5T_NATIVE_UINT64;
    }
    if constexpr (std::is_same_v<T, std::uint8_t>) {
        return H5T_NATIVE_UINT8;
    }
}

Handle text_type(std::size_t length) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text type");
    H5Tset_size(type, std::max<std::size_t>(length, 1)); // HDF5 knows no text of length zero
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}

Handle space_of(const Shape& shape) {
    const std::vector<hsize_t> sizes(shape.begin(), shape.end());
    return {
        shape.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr),
        H5Sclose, "an array of this shape"};
}

/// A text at an array, or at the root where `object` is the file.
void attach(hid_t object, const std::string& name, const std::string& text) {
    const Handle type = text_type(text.size()), one = space_of({});
    const Handle attribute(
        H5Acreate2(object, name.c_str(), type, one, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "the attribute " + name
    );
    require(H5Awrite(attribute, type, text.c_str()) >= 0, "the attribute " + name);
}

Handle create_dataset(hid_t file, const std::string& name, hid_t type, hid_t space) {
    const Handle groups(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "a property list");
    H5Pset_create_intermediate_group(groups, 1);
    const Handle timeless(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "a property list");
    H5Pset_obj_track_times(timeless, false); // the same state has the same bytes, whenever it is saved
    return {H5Dcreate2(file, name.c_str(), type, space, groups, timeless, H5P_DEFAULT), H5Dclose, "to add " + name};
}

/// Values of an array, or the largest number there is where the product is beyond that.
std::size_t count_of(const Shape& sizes) {
    std::size_t count = 1;
    for (const std::size_t size : sizes) {
        if (__builtin_mul_overflow(count, size, &count)) {
            return std::numeric_limits<std::size_t>::max();
        }
    }
    return count;
}

/// Whether what is stored can be `count` values of `size` bytes: of a damaged file, a shape may require more than any
/// memory holds.
bool can_hold(hid_t data, std::size_t count, std::size_t size) {
    constexpr std::size_t best_compression = 1100; // of gzip, for files that were packed again
    const std::size_t stored = H5Dget_storage_size(data);
    return count == 0 || (size > 0 && (count - 1) / best_compression <= stored / size);
}

/// How a file in memory is opened.
Handle in_memory() {
    constexpr std::size_t growth = std::size_t{1} << 20;
    constexpr hbool_t on_disk = 0;
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "a property list");
    require(H5Pset_fapl_core(access, growth, on_disk) >= 0, "a file in memory");
    return access;
}

/// HDF5 distinguishes files in memory by name.
std::string name_in_memory(const void* owner) {
    return fmt::format("suffuse {}", fmt::ptr(owner));
}

constexpr const char* damaged = "it is not an HDF5 file, or it is damaged";

// A file with either of these has a digest: no damage to one name or one value makes it a file of before there were
// any.
const std::string digest_array = "sha256", digest_mark = "digest";
constexpr const char* digest_meaning = "SHA-256 of this file, the 64 digits of the array sha256 taken as zeros";

/// Where the digits of the digest are in the file, HADDR_UNDEF where there is no room for them.
haddr_t place_of_digest(hid_t file) {
    const hid_t data = H5Dopen2(file, digest_array.c_str(), H5P_DEFAULT);
    const haddr_t place = data < 0 ? HADDR_UNDEF : H5Dget_offset(data);
    H5Dclose(data);
    hsize_t size = 0;
    const bool is_whole = H5Fget_filesize(file, &size) >= 0 && size >= DigestWithin::digits;
    return is_whole && place <= size - DigestWithin::digits ? place : HADDR_UNDEF;
}

std::string stripped(std::string text) { // the one blank that stands for an empty text, and padding
    while (!text.empty() && text.back() == '\0') {
        text.pop_back();
    }
    return text;
}

} // namespace

Hdf5Writer::Hdf5Writer() : lock_(library_mutex()) {
    keep_quiet();
    file_ = H5Fcreate(name_in_memory(this).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, in_memory());
    require(file_ >= 0, "a file in memory");
}

Hdf5Writer::~Hdf5Writer() {
    H5Fclose(file_);
}

template <class T>
void Hdf5Writer::write(const std::string& name, const Shape& shape, const T* values, const std::string& unit) {
    const Handle space = space_of(shape);
    const Handle data = create_dataset(file_, name, memory_type<T>(), space);
    const bool any = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) > 0;
    if (any) {
        require(H5Dwrite(data, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, "values of " + name);
    }
    attach(data, "unit", unit);
}

void Hdf5Writer::write_attribute(const std::string& name, const std::string& text) {
    attach(file_, name, text);
}

void Hdf5Writer::write_text(const std::string& name, const std::string& text) {
    const Handle type = text_type(text.size()), one = space_of({});
    const Handle data = create_dataset(file_, name, type, one);
    require(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0, "text of " + name);
}

void Hdf5Writer::save(const std::filesystem::path& path) {
    write_file(path, image());
}

std::string_view Hdf5Writer::image() {
    if (H5Lexists(file_, digest_array.c_str(), H5P_DEFAULT) <= 0) {
        write_attribute(digest_mark, digest_meaning);
        write_text(digest_array, std::string(DigestWithin::digits, '0'));
    }
    require(H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0, "to complete the file in memory");
    const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
    // The image where the memory driver holds it: a copy would double what a large state takes.
    void* handle = nullptr;
    require(size > 0 && H5Fget_vfd_handle(file_, H5P_DEFAULT, &handle) >= 0, "the image of the file");
    char* const bytes = *static_cast<char**>(handle);
    const std::string_view image{bytes, static_cast<std::size_t>(size)};
    const haddr_t place = place_of_digest(file_);
    require(place != HADDR_UNDEF, "the place of the digest");
    DigestWithin digest(place);
    digest.add(image);
    digest.found().copy(bytes + place, DigestWithin::digits);
    return image;
}

// The public constructors hand over to this one, so that an error in them closes what they have opened.
Hdf5Reader::Hdf5Reader(Unopened file) : lock_(library_mutex()), path_(std::move(file.name)) {
    keep_quiet();
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : Hdf5Reader(Unopened{path.string()}) {
    if (!std::filesystem::exists(path)) {
        complain("there is no such file");
    }
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "a property list");
    require(H5Pset_fapl_sec2(access) >= 0, "a file on disk");
    file_ = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access);
    if (file_ < 0) {
        complain(damaged);
    }
    check_digest([this](DigestWithin& digest) { add_bytes_on_disk(digest); });
}

Hdf5Reader::Hdf5Reader(std::string_view image, const std::string& name) : Hdf5Reader(Unopened{name}) {
    const Handle access = in_memory();
    // HDF5 copies the bytes, as it may write to its own.
    require(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()) >= 0, "the image of a file");
    file_ = H5Fopen(name_in_memory(this).c_str(), H5F_ACC_RDONLY, access);
    if (file_ < 0) {
        complain(damaged);
    }
    check_digest([image](DigestWithin& digest) { digest.add(image); });
}

Hdf5Reader::~Hdf5Reader() {
    if (file_ >= 0) {
        H5Fclose(file_);
    }
}

void Hdf5Reader::complain(const std::string& message) const {
    throw IoError(fmt::format("cannot read {}: {}", path_, message));
}

void Hdf5Reader::check_digest(const std::function<void(DigestWithin&)>& add_bytes) {
    if (!has(digest_array) && H5Aexists(file_, digest_mark.c_str()) <= 0) {
        return;
    }
    const haddr_t place = place_of_digest(file_);
    if (place != HADDR_UNDEF) {
        DigestWithin digest(place);
        add_bytes(digest);
        has_digest_ = digest.recorded() == digest.found();
    }
    if (!has_digest_) {
        complain("it was changed or damaged after it was written; use a whole copy of it, or make it anew");
    }
}

void Hdf5Reader::add_bytes_on_disk(DigestWithin& digest) const {
    void* descriptor = nullptr;
    require(H5Fget_vfd_handle(file_, H5P_DEFAULT, &descriptor) >= 0, "the file on disk");
    std::vector<char> part(std::size_t{1} << 16);
    for (off_t at = 0;;) {
        const ssize_t size = pread(*static_cast<int*>(descriptor), part.data(), part.size(), at);
        if (size == 0) {
            return;
        }
        if (size > 0) {
            digest.add({part.data(), static_cast<std::size_t>(size)});
            at += size;
        } else if (errno != EINTR) {
            complain(std::strerror(errno));
        }
    }
}

bool Hdf5Reader::has(const std::string& name) const {
    for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) { // HDF5 needs every group on the way
        if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) {
            return false;
        }
        if (end == std::string::npos) {
            return true;
        }
    }
}

Shape Hdf5Reader::shape(const std::string& name) const {
    if (!has(name)) {
        complain(fmt::format("{} is missing", name));
    }
    const Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
    const Handle space(H5Dget_space(data), H5Sclose, name);
    const int rank = H5Sget_simple_extent_ndims(space);
    require(rank >= 0, "the shape of " + name);
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    require(H5Sget_simple_extent_dims(space, sizes.data(), nullptr) >= 0, "the shape of " + name);
    return {sizes.begin(), sizes.end()};
}

template <class T>
std::vector<T> Hdf5Reader::read(const std::string& name) const {
    const Shape sizes = shape(name);
    const Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
    const Handle type(H5Dget_type(data), H5Tclose, name);
    if (H5Tequal(type, memory_type<T>()) <= 0) {
        complain(fmt::format("{} is of another type than expected", name));
    }
    const std::size_t count = count_of(sizes);
    if (!can_hold(data, count, sizeof(T))) {
        complain(fmt::format("the values of {} are damaged", name));
    }
    std::vector<T> values(count);
    if (!values.empty() && H5Dread(data, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
        complain(fmt::format("the values of {} are damaged", name));
    }
    return values;
}

std::string Hdf5Reader::read_text(const std::string& name) const {
    if (!has(name)) {
        complain(fmt::format("{} is missing", name));
    }
    const Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
    const Handle type(H5Dget_type(data), H5Tclose, name);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) {
        complain(fmt::format("{} is no text", name));
    }
    const Handle space(H5Dget_space(data), H5Sclose, name);
    const std::size_t size = H5Tget_size(type);
    if (H5Sget_simple_extent_npoints(space) != 1 || !can_hold(data, 1, size)) {
        complain(fmt::format("{} is no single text", name));
    }
    std::string text(size, '\0');
    if (H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) {
        complain(fmt::format("the text {} is damaged", name));
    }
    return stripped(std::move(text));
}

std::string Hdf5Reader::unit(const std::string& name) const {
    if (!has(name)) {
        complain(fmt::format("{} is missing", name));
    }
    return attached(name, "unit");
}

std::string Hdf5Reader::attribute(const std::string& name) const {
    return attached("/", name);
}

std::string Hdf5Reader::attached(const std::string& object, const std::string& name) const {
    const std::string what = fmt::format("the attribute {} of {}", name, object);
    const Handle attribute(
        H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what
    );
    const Handle type(H5Aget_type(attribute), H5Tclose, what), space(H5Aget_space(attribute), H5Sclose, what);
    const bool is_text = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
    if (!is_text || H5Sget_simple_extent_npoints(space) != 1) {
        complain(what + " is no single text");
    }
    std::string text(H5Tget_size(type), '\0');
    require(H5Aread(attribute, type, text.data()) >= 0, what);
    return stripped(std::move(text));
}

std::vector<std::string> Hdf5Reader::names(const std::string& group) const {
    std::vector<std::string> found;
    if (!has(group)) {
        return found;
    }
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
    };
    const Handle opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, group);
    require(H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &found) >= 0, "the names in " + group);
    return found;
}

// The types that files hold; a further one is added here and in memory_type.
#define SUFFUSE_HDF5_TYPE(T)                                                                                           \
    template void Hdf5Writer::write<T>(const std::string&, const Shape&, const T*, const std::string&);                \
    template std::vector<T> Hdf5Reader::read<T>(const std::string&) const;
SUFFUSE_HDF5_TYPE(double)
SUFFUSE_HDF5_TYPE(std::int32_t)
SUFFUSE_HDF5_TYPE(std::uint32_t)
SUFFUSE_HDF5_TYPE(std::int64_t)
SUFFUSE_HDF5_TYPE(std::uint64_t)
SUFFUSE_HDF5_TYPE(std::uint8_t)
#undef SUFFUSE_HDF5_TYPE

} // namespace suffuse::io
