#pragma once
// [study.NAME]: its stages, which stage starts from which, and the copies that sweeps and replicates make.

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

/// Letters, digits, - and _, and points within: names become folders.
bool check_name(ReadContext& context, const std::string& what, const std::string& name, const Place& place);

/// The table of one stage; stages of `default_spec` feed the schema's defaults.
Node write_stage(const Stage& stage);

/// A stage that has every default, by its verb.
StageSpec default_spec(std::size_t verb);

} // namespace suffuse::casefile
