// Each member of a result that results.cbor has is in a row: what is forgotten does not compile.

#include "suffuse/facts/mobility.hpp"
#include "suffuse/facts/pass.hpp"

#include <gtest/gtest.h>

namespace suffuse::facts {
namespace {

/// Stands for a member of any type.
struct AnyMember {
    template <class Value>
    operator Value() const; // NOLINT(google-explicit-constructor): that is its use
};

/// How many members a plain structure has.
template <class Of, class... Counted>
consteval std::size_t members_of() {
    if constexpr (requires { Of{Counted{}..., AnyMember{}}; }) {
        return members_of<Of, Counted..., AnyMember>();
    } else {
        return sizeof...(Counted);
    }
}

/// How many of them results.cbor has by these rows.
template <class... Rows>
consteval std::size_t saved_by(const Rows&... lists) {
    std::size_t saved = 0;
    const auto count = [&]<class R>(const R& row) { saved += R::is_member && !row.saved.empty() ? 1 : 0; };
    (for_each_row(lists, count), ...);
    return saved;
}

TEST(SavedMembers, EachHasItsRow) {
    static_assert(
        saved_by(pass, pass_with_water) == members_of<erosion::PassResult>() &&
            saved_by(probe) == members_of<erosion::ProbeResult>() &&
            saved_by(mobility) == members_of<erosion::MobilityResult>(),
        "each member of a result has its row: with a key of stage.json, or saved_alone"
    );
}

} // namespace
} // namespace suffuse::facts
