#include "suffuse/laboratory/test_record.hpp"

#include <algorithm>

namespace suffuse::laboratory {

TestColumn* TestRecord::find(Quantity quantity) {
    const auto found = std::ranges::find(columns, quantity, &TestColumn::quantity);
    return found == columns.end() ? nullptr : &*found;
}

const TestColumn* TestRecord::find(Quantity quantity) const {
    const auto found = std::ranges::find(columns, quantity, &TestColumn::quantity);
    return found == columns.end() ? nullptr : &*found;
}

} // namespace suffuse::laboratory
