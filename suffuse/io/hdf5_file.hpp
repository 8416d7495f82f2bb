#pragma once
// HDF5 files as named arrays with a unit, and named texts. A file is made in memory and then written at once, so that a
// full disk cannot leave a damaged one and HDF5 never holds a file that it cannot close. A file holds the SHA-256 of
// its bytes, and is refused where one of them has changed. HDF5 serves one thread at a time, so that a thread waits
// while another one has a file open.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

class DigestWithin;

/// Array sizes; none for a single number.
using Shape = std::vector<std::size_t>;

/// T is double, int32, uint32, int64, uint64 or uint8. Both classes throw IoError where something fails.
class Hdf5Writer {
public:
    Hdf5Writer();
    ~Hdf5Writer();
    Hdf5Writer(const Hdf5Writer&) = delete;
    Hdf5Writer& operator=(const Hdf5Writer&) = delete;

    /// Adds an array, last index fastest; `name` may hold groups, "grains/radius". `unit` is kept as an attribute.
    template <class T>
    void write(const std::string& name, const Shape& shape, const T* values, const std::string& unit);

    /// Adds a text of any length.
    void write_text(const std::string& name, const std::string& text);

    /// Adds a text as an attribute of the file itself; up to 64 kB.
    void write_attribute(const std::string& name, const std::string& text);

    /// Completes the file on disk: it is there in full, or an IoError says why not and the old one remains.
    void save(const std::filesystem::path& path);

    /// The bytes of the completed file, which are there until more is added.
    [[nodiscard]] std::string_view image();

private:
    std::unique_lock<std::recursive_mutex> lock_;
    std::int64_t file_ = -1;
};

class Hdf5Reader {
public:
    /// Refuses a file whose bytes are not those that were written.
    explicit Hdf5Reader(const std::filesystem::path& path);

    /// Of the bytes of a file. @param name of where they are from, in messages
    Hdf5Reader(std::string_view image, const std::string& name);
    ~Hdf5Reader();
    Hdf5Reader(const Hdf5Reader&) = delete;
    Hdf5Reader& operator=(const Hdf5Reader&) = delete;

    /// Whether the file holds its SHA-256, which its bytes then met; those of earlier versions do not.
    [[nodiscard]] bool has_digest() const { return has_digest_; }

    [[nodiscard]] bool has(const std::string& name) const;

    /// Sizes of an array.
    [[nodiscard]] Shape shape(const std::string& name) const;

    /// All values of an array; its type in the file must be that of T.
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& name) const;

    [[nodiscard]] std::string read_text(const std::string& name) const;
    [[nodiscard]] std::string unit(const std::string& name) const;
    [[nodiscard]] std::string attribute(const std::string& name) const;

    /// Names of what a group holds, in alphabetical order; none where there is no such group.
    [[nodiscard]] std::vector<std::string> names(const std::string& group) const;

    /// Throws IoError about this file.
    [[noreturn]] void complain(const std::string& message) const;

private:
    struct Unopened {
        std::string name;
    };

    explicit Hdf5Reader(Unopened file);
    void check_digest(const std::function<void(DigestWithin&)>& add_bytes);
    void add_bytes_on_disk(DigestWithin& digest) const;
    [[nodiscard]] std::string attached(const std::string& object, const std::string& name) const;

    std::unique_lock<std::recursive_mutex> lock_;
    std::string path_;
    std::int64_t file_ = -1;
    bool has_digest_ = false;
};

} // namespace suffuse::io
