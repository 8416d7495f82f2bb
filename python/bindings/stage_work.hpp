#pragma once
// What the functions of a World that do a stage's work have in common.

#include "suffuse/casefile/physics_checks.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/order.hpp"

#include <fmt/format.h>

#include "python/bindings/key_doc.hpp"
#include "python/bindings/world_handle.hpp"
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

namespace suffuse::python {

using Handle = std::shared_ptr<WorldHandle>;

/// With the rows along the curve and with contacts, as the stages of a run begin.
inline void prepare(dem::World& world) {
    dem::sort_along_curve(world);
    if (dem::awaits_first_step(world)) {
        dem::add_first_contacts(world);
    }
}

inline dem::World& begin(Stepping& call) {
    dem::World& world = call.world_for_new_rows();
    prepare(world);
    return world;
}

/// For work that leaves the world itself as it is.
inline dem::World begin_copy(Stepping& call) {
    dem::World copy = call.world();
    prepare(copy);
    return copy;
}

/// @throws CaseError where a case would be refused: grains are too soft for the stress [Pa]
inline void refuse_too_soft(const grains::Material& material, double stress) {
    if (const auto soft = casefile::check_stiffness(material, stress); soft && soft->is_error) {
        throw CaseError(soft->message + ", and no contact law describes them: " + soft->advice);
    }
}

/// Takes back what a compaction or a test has lent, unless it came to its end: the world lives on in Python.
template <class State>
class Loan {
public:
    Loan(Stepping& call, State& state) : call_(call), state_(state) {}

    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    ~Loan() {
        if (state_.phase != State::Phase::Done) {
            give_back(call_.world(), state_);
            call_.drop_caches();
        }
    }

private:
    Stepping& call_;
    State& state_;
};

/// The text of a function with the meaning of its arguments, as the case file's schema has it.
inline std::string with_keys(std::string doc, std::initializer_list<std::pair<const char*, const char*>> keys) {
    for (const auto& [table, name] : keys) {
        doc += fmt::format("\n{}: {}", name, key_doc(key_of(table, name)));
    }
    return doc;
}

} // namespace suffuse::python
