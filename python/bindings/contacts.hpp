#pragma once
// The touching contacts of a world, for NumPy: a picture of them, which later steps do not change.

#include "suffuse/dem/inspect.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace suffuse::python {

struct ContactTable {
    std::vector<dem::ContactView> rows;
    dem::ContactsAtLimit limits;
};

std::shared_ptr<ContactTable> take_contacts(const dem::World& world);

} // namespace suffuse::python
