#include "suffuse/io/packing_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/named_file.hpp"
#include "suffuse/io/packing_readers.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace suffuse::io {
namespace {

ImportedPacking parse_any(const PackingSource& source) {
    for (const PackingReader& reader : packing_readers()) {
        if (!reader.recognizes(source.text)) {
            continue;
        }
        if (source.radius && reader.has_own_radii) {
            throw CaseError(
                source.file + ": the file contains radii, and one for all was given: leave that out", source.file
            );
        }
        return reader.read(source);
    }
    throw Bug("the last format of packings takes any text");
}

void scale(ImportedPacking& packing, double unit) {
    grains::Grains& grains = packing.grains;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        grains.position[g] = unit * grains.position[g];
        grains.velocity[g] = unit * grains.velocity[g];
        grains.radius[g] *= unit;
        grains.mass[g] *= unit * unit * unit;
        grains.inertia[g] *= std::pow(unit, 5);
    }
    if (packing.cell) {
        packing.cell->h = unit * packing.cell->h;
    }
    packing.origin = unit * packing.origin;
}

} // namespace

ImportedPacking
read_packing(const std::filesystem::path& path, double density, double unit, std::optional<double> radius) {
    const std::string file = path.string(), text = read_text(path, refuse_named_file);
    const auto in_file = radius ? std::optional(*radius / unit) : std::nullopt;
    ImportedPacking packing =
        parse_any({.file = file, .text = text, .density = density, .radius = in_file, .unit = unit});
    if (packing.grains.size() == 0) {
        throw CaseError(fmt::format("{}: no grains found, expected at least one", file), file);
    }
    if (unit != 1) {
        scale(packing, unit);
    }
    return packing;
}

} // namespace suffuse::io
