#include "suffuse/io/named_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view save_as_csv = "open it there and save the table as CSV";
constexpr std::string_view save_as_utf8 = "save it as UTF-8";
constexpr std::string_view with_paraview =
    "write a state.h5 of suffuse by `suffuse export FILE -o grains.csv`; load another program's file into ParaView and "
    "save it as .vtp or .csv, or write its x, y, z, r with Python's h5py";
constexpr std::string_view with_gsd =
    "write x, y, z, r of its last frame: python3 -c \"import sys, numpy as n, gsd.hoomd as g; p = "
    "g.open(sys.argv[1])[-1].particles; n.savetxt('grains.txt', n.c_[p.position, p.diameter / 2])\" {}";
constexpr std::string_view with_numpy =
    "write it as text: python3 -c \"import sys, numpy as n; n.savetxt('grains.txt', n.load(sys.argv[1]))\" {}";
constexpr std::string_view with_ovito = "load it into OVITO and export extended XYZ with position and radius";

constexpr std::array rows{
    NamedFile{"\xdf\x65\xdf\x65\xdf\x65\xdf\x65"sv, "a GSD file of HOOMD-blue", with_gsd},
    NamedFile{"\x89HDF\r\n\x1a\n"sv, "an HDF5 file", with_paraview},
    NamedFile{"CDF\x01"sv, "a NetCDF file", with_ovito},
    NamedFile{"CDF\x02"sv, "a NetCDF file", with_ovito},
    NamedFile{"LammpS RestartT"sv, "a restart file of LAMMPS", "write a data file: lmp -restart2data {} grains.data"},
    NamedFile{"\x93NUMPY"sv, "an array of NumPy", with_numpy},
    NamedFile{"BZh"sv, "packed with bzip2", "unpack it first: bunzip2 -k {}"},
    NamedFile{
        "\xfd"
        "7zXZ\0"sv,
        "packed with xz", "unpack it first: unxz -k {}"},
    NamedFile{"\x28\xb5\x2f\xfd"sv, "packed with zstd", "unpack it first: unzstd {}"},
    NamedFile{
        "PK\x03\x04"sv, "a zip archive, a workbook (.xlsx, .ods) or arrays of NumPy (.npz)",
        "unpack it first: unzip {}; of a workbook save the sheet as CSV"},
    NamedFile{"7z\xbc\xaf\x27\x1c"sv, "packed with 7-Zip", "unpack it first: 7z x {}"},
    NamedFile{"\xd0\xcf\x11\xe0"sv, "a workbook of the old kind (.xls)", save_as_csv},
    NamedFile{"%PDF"sv, "a PDF", "take the numbers from the program that made it"},
    NamedFile{"\xff\xfe"sv, "UTF-16 text", save_as_utf8},
    NamedFile{"\xfe\xff"sv, "UTF-16 text", save_as_utf8},
};

} // namespace

std::span<const NamedFile> named_files() {
    return rows;
}

void refuse_named_file(const std::filesystem::path& path, std::string_view begin) {
    const auto found = std::ranges::find_if(rows, [&](const NamedFile& row) { return begin.starts_with(row.begin); });
    if (found == rows.end()) {
        return;
    }
    const std::string file = path.string();
    std::string advice(found->advice);
    if (const std::size_t at = advice.find("{}"); at != std::string::npos) {
        advice.replace(at, 2, shell_word(file));
    }
    throw CaseError(fmt::format("{}: this file is {}; {}", file, found->name, advice), file);
}

} // namespace suffuse::io
