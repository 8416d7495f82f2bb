#pragma once
// [study.NAME]: its soil, its size, its stages, and the copies that sweeps and replicates make.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/writer.hpp"

namespace suffuse::casefile {

/// What a study is read from, besides its own table.
struct StudySurroundings {
    const Case& settings;          ///< material, fluid, soils: already read
    const Node* soils = nullptr;   ///< the tree of [soil]
    const Node* contact = nullptr; ///< that of [contact], where the case has it
};

Study read_study(ReadContext& context, const StudySurroundings& around, const Node::Entry& entry);

Node write_study(const Study& study);

} // namespace suffuse::casefile
