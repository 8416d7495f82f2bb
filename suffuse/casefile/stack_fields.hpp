#pragma once
// Layers of a `pack`: their keys, and what must hold for a stack and for the stages that start from it.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/writer.hpp"

#include <string>

namespace suffuse::casefile {

/// `layers = [{ soil = "base", thickness = "3 mm" }, ...]`, with `axis` and `width`; a stack has its own `porosity`
/// unless the case gives one.
void layers_fields(Reader& v, packing::PackSpec& s);
void layers_fields(Writer& v, const packing::PackSpec& s);

/// The stage that packed the layers which this one starts from; null where its sample is no stack.
const packing::PackSpec* stack_of(const Variant& variant, const Stage& stage);

/// Whether a stage packs one soil, of which the study says which and how many grains.
bool packs_one_soil(const Stage& stage);

/// Reports layers that no soil of the case is named for; and soils, thicknesses and widths that make no stack.
/// @param path of the study: "study.one"
void check_layers(ReadContext& context, const Case& settings, const Variant& variant, const std::string& path);

/// Reports a stage that has no meaning in a stack: one that shears the cell, or judges which fines move through a
/// skeleton, or a migration that does not go through the layers in their order.
void check_in_stack(ReadContext& context, const Variant& variant, const Stage& stage, const Place& place);

} // namespace suffuse::casefile
