#pragma once
// What a case says of weight, in a sentence for who is about to run it.

#include "suffuse/casefile/case.hpp"

#include <string>

namespace suffuse::casefile {

/// Whether the stage finds which fines move against their weight: it needs fines, and a coarse skeleton.
bool weighs_fines(const Stage& stage);

/// Which stages know weight, or what it would change; empty where no stage finds what water removes.
std::string weight_sentence(const Case& what);

} // namespace suffuse::casefile
